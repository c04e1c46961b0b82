// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeProof.h
 * @brief Cone sets that hold all of the shadow of a mesh, as a fact.
 */
#ifndef scConeProof_h
#define scConeProof_h

#include "ShadowConesCoreModule.h"
#include "scConeSet.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Values of the array "ConeOrigin".
enum class ConeOrigin : int
{
  Fitted = 0, ///< as it was given
  Grown = 1,  ///< a given cone, larger
  Added = 2   ///< around parts of occluders
};

struct ConeProofOptions
{
  /// The box in which the cones' volume is to stay small; empty: the bounds of the casters, half of their diagonal wider.
  Box Region;
  /// Cones to add at most, where their half angles allow it; 0: as many as are given, and at least 16; without given cones 140.
  int LargestNumberOfAddedCones = 0;
};

/// Cones of which each pair of a part of an occluder and a convex part of the light has one that holds the part and all its shadow.
struct ConeProof
{
  std::vector<Cone> Cones; ///< the given ones in their order, then added ones; values as they are stored (StoredCone)
  std::vector<ConeOrigin> Origins;
  bool Certified = false;
  /// Where it holds; empty: everywhere. Outside of it shadow may be anywhere.
  Box CertifiedBounds;
  vtkIdType NumberOfProvedParts = 0; ///< held by the given cones as they were, or by grown or added ones
  vtkIdType NumberOfGrownCones = 0;
  vtkIdType NumberOfAddedCones = 0;
  vtkIdType NumberOfOccludersWithoutCone = 0; ///< that touch the light, or see too wide a Sun: a cone holds CertifiedBounds then
  double Volume = 0.0;                        ///< of the union of the cones in the region, estimated
};

/**
 * Cut the casting triangles into parts, see which of the given cones hold which part with all its shadow, and let cones grow or
 * add new ones for the others. See Documentation for what is proved. Cost is near-linear in the number of triangles. The same
 * result for any number of threads. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ProveConeSet(const TriangleMeshView& mesh, const Light& light, const std::vector<Cone>& given,
  const ConeProofOptions& options, const Monitor& monitor, ConeProof& proof);

/// A cone as it is read back from arrays in single precision.
SHADOWCONESCORE_EXPORT Cone StoredCone(const Cone& cone);

} // namespace shadowcones

#endif
