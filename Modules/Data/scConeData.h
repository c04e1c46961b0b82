// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeData.h
 * @brief Cone sets as poly data.
 */
#ifndef scConeData_h
#define scConeData_h

#include "ShadowConesDataModule.h"
#include "scConeSet.h"
#include "scConeTuning.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace shadowcones
{

/**
 * Read a cone set from its documented arrays. "Axis", "BaseRadius" and "HalfAngle" are required. The others have
 * fallbacks: "InnerHalfAngle" is -|HalfAngle| (the shortest umbra that a light can leave), "Normal" is the axis,
 * "OccluderId", "VectorCount" and "Planarity" are 0, "Overspill" is -1. Axes and normals within 1e-3 of unit length are
 * normalised.
 * @return false, with a sentence in @p error that names the array that is missing or has the wrong size, or the cone
 * whose value is not valid. No points give no cones.
 */
SHADOWCONESDATA_EXPORT bool ReadConeSet(vtkPolyData* input, std::vector<Cone>& cones, std::string& error);
/// Write cones as vertices with the documented arrays of a cone set.
SHADOWCONESDATA_EXPORT void WriteConeSet(const std::vector<Cone>& cones, vtkPolyData* output);

/**
 * Discs as wide as the vectors they were fitted to: figure 5's cosine is taken back where a cone set's field data,
 * @p parameters, tells of it.
 */
SHADOWCONESDATA_EXPORT void UndoCosineCorrection(vtkFieldData* parameters, std::vector<Cone>& cones);

/// Every parameter that the cones were fitted with, by its name, as field data.
SHADOWCONESDATA_EXPORT void WriteConeSetOptions(const ConeSetOptions& options, vtkFieldData* data);
/// What tuning found on the photons held out, as field data.
SHADOWCONESDATA_EXPORT void WriteConeTuning(const ConeTuningResult& tuning, vtkFieldData* data);

} // namespace shadowcones

#endif
