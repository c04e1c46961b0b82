// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeData.h
 * @brief Cone sets as poly data.
 */
#ifndef scConeData_h
#define scConeData_h

#include "ShadowConesDataModule.h"
#include "scCone.h"
#include "scConeProof.h"
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
 * "OccluderId", "VectorCount", "Planarity", "LightId" and "ConeOrigin" are 0, "Overspill" is -1. Axes and normals within 1e-3 of unit
 * length are normalised.
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

/// The box in which a cone set's field data says that it is proved; empty: everywhere, or not at all; at infinity,
/// which is nowhere, where the numbers are no box.
SHADOWCONESDATA_EXPORT Box ReadCertifiedBounds(vtkFieldData* data);
/// One cone around @p region for each light: rays are then sent from everywhere.
SHADOWCONESDATA_EXPORT std::vector<Cone> ConesEverywhere(const Box& region, std::size_t lights);
/// @p cones, or ConesEverywhere where @p region reaches out of the box @p proved in which the set is proved, which is empty where
/// it has none (ReadCertifiedBounds): shadow may be anywhere there.
SHADOWCONESDATA_EXPORT std::vector<Cone> ConesFor(
  const Box& region, std::size_t lights, const Box& proved, const std::vector<Cone>& cones);

/// What a cone set's field data says of its proof.
struct ConeCertificate
{
  bool Certified = false;
  Box Bounds; ///< where it holds; empty: everywhere
  vtkIdType NumberOfProvedParts = 0;
  vtkIdType NumberOfGrownCones = 0;
  vtkIdType NumberOfAddedCones = 0;
  vtkIdType NumberOfOccludersWithoutCone = 0;
  std::uint64_t Hash = 0;
};

/// The certificate of cones that were proved, or not.
SHADOWCONESDATA_EXPORT ConeCertificate CertificateOf(const ConeProof& proof, const std::vector<Cone>& cones,
  const TriangleMeshView& mesh, const std::vector<Light>& lights);
/// "Certified", "CertifiedBounds" (infinite: everywhere), the four counts and "CertificateHash", as field data.
SHADOWCONESDATA_EXPORT void WriteConeCertificate(const ConeCertificate& certificate, vtkFieldData* data);
/**
 * The certificate of a cone set for these cones, casters and lights. Not Certified, with a sentence in @p why, where the field
 * data does not say so or its hash is of other cones, casters or lights.
 */
SHADOWCONESDATA_EXPORT ConeCertificate ReadConeCertificate(vtkFieldData* data, const std::vector<Cone>& cones,
  const TriangleMeshView& mesh, const std::vector<Light>& lights, std::string& why);

} // namespace shadowcones

#endif
