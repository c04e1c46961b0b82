// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFootprintData.h
 * @brief Outlines and areas of shadows as poly data, written and read.
 */
#ifndef scFootprintData_h
#define scFootprintData_h

#include "ShadowConesDataModule.h"
#include "scShadowFootprint.h"
#include "scVector3.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace shadowcones
{

/**
 * Write footprints, one result a light: @p outlines as polylines (closed ones end with their first point), @p areas as polygons,
 * both with cell data "ShadowClass" (unsigned char), "OccluderId", "LightId" (int).
 */
SHADOWCONESDATA_EXPORT void WriteFootprints(
  const std::vector<ShadowFootprints>& footprints, vtkPolyData* outlines, vtkPolyData* areas);

/// An outline as it is read.
struct OutlineRing
{
  int ShadowClass = 1;
  int OccluderId = -1;
  int LightId = 0;
  bool Closed = true;
  std::vector<Vector3> Points; ///< the first is not repeated
};

/**
 * Read outlines: lines with cell data "ShadowClass", "OccluderId" and "LightId", each optional. @return false, with a sentence in
 * @p error, where an array has the wrong size or a coordinate is not finite.
 */
SHADOWCONESDATA_EXPORT bool ReadOutlines(vtkPolyData* input, std::vector<OutlineRing>& outlines, std::string& error);

} // namespace shadowcones

#endif
