// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeProof.h
 * @brief Cone sets that hold all of the shadow of a mesh, as a fact.
 */
#ifndef scConeProof_h
#define scConeProof_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scLight.h"
#include "scParallel.h"
#include "scTriangleMesh.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

struct ConeProofOptions
{
  /// The box in which the cones' volume is to stay small; empty: the bounds of the casters, half of their diagonal wider.
  Box Region;
  /// Cones to add at most for a light, where their half angles allow it; 0: as many as are given, and at least 16; without given cones 140.
  int LargestNumberOfAddedCones = 0;
};

/// Cones of which each pair of a part of an occluder and a convex part of the light has one that holds the part and all its shadow.
struct ConeProof
{
  std::vector<Cone> Cones; ///< the given ones in their order, then added ones; values as they are stored (StoredCone)
  bool Certified = false;
  /// Where it holds; empty: everywhere. Outside of it shadow may be anywhere.
  Box CertifiedBounds;
  vtkIdType NumberOfProvedParts = 0; ///< held by the given cones as they were, or by grown or added ones
  vtkIdType NumberOfGrownCones = 0;
  vtkIdType NumberOfAddedCones = 0;
  vtkIdType NumberOfOccludersWithoutCone = 0; ///< that touch the light, or see too wide a Sun: a cone holds CertifiedBounds then
  double Volume = 0.0;                        ///< of the union of the cones in the region, by 16,384 points
};

/**
 * Cut the casting triangles into parts, see which of the given cones hold which part with all its shadow, and let cones grow or
 * add new ones for the others, a light at a time: cones of that LightId alone count. Cost is near-linear in the number of triangles. The same
 * result for any number of threads. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ProveConeSet(const TriangleMeshView& mesh, const std::vector<Light>& lights,
  const std::vector<Cone>& given, const ConeProofOptions& options, const Monitor& monitor, ConeProof& proof);

/// The Volume of cones of one's own, as ProveConeSet measures it.
SHADOWCONESCORE_EXPORT double VolumeOfCones(
  const TriangleMeshView& mesh, const std::vector<Cone>& cones, const ConeProofOptions& options);

/// Does the union of the cones of @p a have the smaller Volume? Where they differ by less than a hundredth: has it fewer cones?
SHADOWCONESCORE_EXPORT bool IsTighter(const ConeProof& a, const ConeProof& b);

/// One word for what was proved: cones as they are stored, casting triangles in any order, and the lights without their spectra.
SHADOWCONESCORE_EXPORT std::uint64_t CertificateHash(
  const std::vector<Cone>& cones, const TriangleMeshView& mesh, const std::vector<Light>& lights);

/// A cone as it is read back from arrays in single precision.
SHADOWCONESCORE_EXPORT Cone StoredCone(const Cone& cone);

} // namespace shadowcones

#endif
