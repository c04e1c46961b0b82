// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeSet.h
 * @brief Truncated cones, and fitting a set of them to shadow vectors (Hougs and Day, section 3.2).
 */
#ifndef scConeSet_h
#define scConeSet_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"
#include "scParallel.h"
#include "scVector3.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Values of the array "ConeOrigin".
enum class ConeOrigin : int
{
  Fitted = 0, ///< to shadow vectors
  Grown = 1,  ///< fitted, then made larger to hold parts of occluders with all their shadow
  Added = 2   ///< around parts of occluders
};

/// One cone: all points x with h = (x - Center) . Axis >= 0 and distance from the axis <= BaseRadius + h tan(HalfAngle).
struct Cone
{
  Vector3 Center;              ///< of the base disc
  Vector3 Axis;                ///< unit, away from the light
  double BaseRadius = 0.0;     ///< world units
  double HalfAngle = 0.0;      ///< outer half angle, radians, in (-pi/2, pi/2); negative: the cone converges to a tip
  double InnerHalfAngle = 0.0; ///< of the umbra of the base disc, radians; negative: the umbra contracts to a tip
  Vector3 Normal;              ///< unit, of the plane fitted to the vectors, on the side of Axis
  int OccluderId = -1;         ///< the occluder of most of its vectors
  int VectorCount = 0;         ///< vectors inside the base
  double Planarity = 0.0;      ///< rms distance of the vectors from the base plane over BaseRadius
  double Overspill = -1.0;     ///< share of lit photon paths among those through the base disc; -1: no paths were given
  int LightId = 0;             ///< of the light whose shadow it bounds
  ConeOrigin Origin = ConeOrigin::Fitted;
};

/// The cones of each of @p count lights, in their order.
SHADOWCONESCORE_EXPORT std::vector<std::vector<Cone>> ConesOfLights(const std::vector<Cone>& cones, std::size_t count);

/// Shadow vectors, not owned; three doubles or floats each.
struct ShadowVectorView
{
  vtkIdType Count = 0;
  const double* Points = nullptr;
  const float* Directions = nullptr;      ///< unit, away from the light
  const double* EmissionPoints = nullptr; ///< on the light
  const int* OccluderIds = nullptr;       ///< one each, or nullptr: all 0
  const int* LightIds = nullptr;          ///< one each, or nullptr: all 0
};

/// Photon paths, not owned.
struct PhotonPathView
{
  vtkIdType Count = 0;
  const double* Points = nullptr;         ///< where the path ends
  const double* EmissionPoints = nullptr; ///< where it starts
  const float* Directions = nullptr;
  const int* States = nullptr;   ///< 0 lit, 1 blocked at Points
  const int* LightIds = nullptr; ///< one each, or nullptr: all 0
};

enum class ConeExpansion : int
{
  MaximumDeviation = 0, ///< largest angle between a vector and their mean: the intent of section 3.2.2's pseudo-code
  RadiusRatio = 1,      ///< from the disc of the vectors' ends over the base disc; finds converging sets
  LightGeometry = 2     ///< outer penumbra cone of the base disc under the light: see PenumbraAngles
};

/// What the expansion of a cone needs to know of the light; see LightExtentOf.
struct LightExtent
{
  bool AtInfinity = false; ///< a Sun: Radius is its angular radius, radians
  std::vector<Vector3> Extremes; ///< points whose convex hull holds the light; empty: the sphere of Center and Radius
  Vector3 Center;          ///< a Sun: the unit way that its light travels
  double Radius = 0.0;
};

/// The extent of an exact light shape.
SHADOWCONESCORE_EXPORT LightExtent LightExtentOf(const Light& light);
/// The extent that emission points (3 values each) span: the sphere around their bounds.
SHADOWCONESCORE_EXPORT LightExtent LightExtentOf(const double* emissionPoints, vtkIdType count);

/**
 * Half angles of the outer cone (the penumbra's bound) and of the inner one (the umbra) of a base disc under the light:
 * the largest (r + rho) / d and the smallest (r - rho) / d over the light's points, with rho their distance from the cone's
 * axis and d their height above the base.
 */
SHADOWCONESCORE_EXPORT void PenumbraAngles(
  const LightExtent& light, const Vector3& center, const Vector3& axis, double baseRadius, double& outer, double& inner);

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
 */
SHADOWCONESCORE_EXPORT bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const LightExtent& light, const ConeSetOptions& options, const Monitor& monitor, ConeSet& result);

/**
 * The same for vectors of several lights, one extent a light: a cone never joins vectors of two. Each light has the
 * cones that it would have alone, those of the first light first. Throws std::invalid_argument where a "LightId" has no
 * extent.
 */
SHADOWCONESCORE_EXPORT bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const std::vector<LightExtent>& lights, const ConeSetOptions& options, const Monitor& monitor, ConeSet& result);

/// nullptr, or what is wrong with the options.
/// nullptr, or what is wrong with the options: a range that is left, or parameters with which no cone could be made.
SHADOWCONESCORE_EXPORT const char* CheckConeSetOptions(const ConeSetOptions& options);

} // namespace shadowcones

#endif
