// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeSet.h
 * @brief Fitting a set of cones to shadow vectors (Hougs and Day, section 3.2).
 */
#ifndef scConeSet_h
#define scConeSet_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scLightExtent.h"
#include "scParallel.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scTeam.h"

#include <vector>

namespace shadowcones
{

enum class ConeExpansion : int
{
  MaximumDeviation = 0, ///< largest angle between a vector and their mean: the intent of section 3.2.2's pseudo-code
  RadiusRatio = 1,      ///< from the disc of the vectors' ends over the base disc; finds converging sets
  LightGeometry = 2     ///< outer penumbra cone of the base disc under the light: see PenumbraAngles
};

enum class ConeLeftovers : int
{
  Discard = 0, ///< vectors that no base took have no cone (section 3.2.1)
  Cover = 1    ///< they get cones of their own
};

struct ConeSetOptions
{
  int NumberOfNeighbors = 100;       ///< p1: vectors in K, 3..1000000
  int NumberOfSectors = 20;          ///< p2: angular bins, 1..65536
  int PointsPerRing = 16;            ///< p3: vectors in each ring, at least 1, below NumberOfNeighbors
  int MinimumVectorsPerCone = 20;    ///< p4: fewer make no cone; at least 1, at most the seed and the rings that K holds
  double VarianceThreshold = 1.6;    ///< largest variance over mean of a ring's sector counts
  double PlanarityThreshold = 0.0;   ///< largest rms distance from the plane over the ring's radius; 0: no test
  bool CosineCorrection = true;      ///< base radius r cos(theta) (figure 5)
  ConeExpansion Expansion = ConeExpansion::MaximumDeviation;
  double ExpansionFraction = 1.0;    ///< HalfAngle is this share of the angle found, 0..1
  double RadiusScale = 1.0;          ///< factor on the base radius, above 0, finite
  double MaximumOverspill = 1.0;     ///< shrink bases until at most this share of their paths is lit, 0..1; 1: off; needs paths
  ConeLeftovers Leftovers = ConeLeftovers::Discard;
  bool Overlap = false;              ///< neighbours come from all vectors; covered ones only stop being seeds
};

struct ConeSet
{
  std::vector<Cone> Cones;
  std::vector<vtkIdType> ConeIds; ///< for each vector the first cone that holds it, or -1
  vtkIdType NumberOfDiscarded = 0;
};

/**
 * Fit cones to shadow vectors: seeds in index order; K nearest living neighbours; rings and sectors in the fitted plane;
 * stop where a ring's sector counts vary too much. @param paths may be empty (Count 0); @return false where aborted.
 * Cost: one nearest-neighbour query a seed, near-linear in the number of vectors. Memory: about 100 bytes a vector.
 * @param workers processes that do this together, seeds dealt out by place: the same result in all of them.
 */
SHADOWCONESCORE_EXPORT bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const LightExtent& light, const ConeSetOptions& options, const Monitor& monitor, ConeSet& result, Team* workers = nullptr);

/**
 * The same for vectors of several lights, one extent a light: a cone never joins vectors of two. Each light has the
 * cones that it would have alone, those of the first light first. Throws std::invalid_argument where a "LightId" has no
 * extent.
 */
SHADOWCONESCORE_EXPORT bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const std::vector<LightExtent>& lights, const ConeSetOptions& options, const Monitor& monitor, ConeSet& result,
  Team* workers = nullptr);

/// nullptr, or what is wrong with the options: a range that is left, or parameters with which no cone could be made.
SHADOWCONESCORE_EXPORT const char* CheckConeSetOptions(const ConeSetOptions& options);

} // namespace shadowcones

#endif
