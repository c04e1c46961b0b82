// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowVectors.h
 * @brief Photons from an area light, and the shadow vectors that they leave behind occluders (Hougs and Day, section 3.1).
 */
#ifndef scShadowVectors_h
#define scShadowVectors_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scTeam.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

enum class VectorStorage : int
{
  BackSide = 0, ///< at the exit of the solid that was entered; at the hit itself where the occluder is an open sheet
  HitPoint = 1  ///< where the path first meets the occluder
};

struct ShadowVectorOptions
{
  vtkIdType NumberOfPhotons = 40000; ///< emitted in all, at least 0; used where TargetNumberOfVectors is 0
  vtkIdType TargetNumberOfVectors =
    0; ///< emit until so many vectors are stored; 0: off; gives up at 1000 photons a vector
  /**
   * Aim photons at occluders that would have fewer vectors of a light than these, 0: off; never more than an even share of the
   * target, or of half the photons. They are among NumberOfPhotons.
   */
  int MinimumVectorsPerOccluder = 0;
  VectorStorage Storage = VectorStorage::BackSide;
  std::uint64_t Seed = 1;
  int Piece = 0; ///< this piece traces photons [N piece / pieces, N (piece + 1) / pieces)
  int NumberOfPieces = 1;
  /**
   * Processes that do this together, each its share; the result is that of one alone. Where each wants its own piece they
   * share what every piece has to know: the aimed photons, and how many photons meet the target.
   */
  Team* Workers = nullptr;
};

/// Structure of arrays; three values a vector where named so.
struct ShadowVectors
{
  std::vector<double> Points;    ///< 3
  std::vector<float> Directions; ///< 3, unit, away from the light
  std::vector<float> Normals;    ///< 3, unit, outward at the back side; HitPoint: outward at the hit
  std::vector<int> OccluderIds;
  std::vector<double> EmissionPoints; ///< 3
  std::vector<float> PathLengths;     ///< emission point to Points
  std::vector<float> Thicknesses;     ///< entry to exit; 0 on open sheets
  std::vector<vtkIdType> PhotonIndices;
  std::vector<int> LightIds;
};

struct PhotonPaths
{
  std::vector<double> Points;         ///< 3, first hit; where lit, where the path leaves the bounds of mesh and light
  std::vector<int> States;            ///< 0 lit, 1 blocked
  std::vector<int> OccluderIds;       ///< of the first hit; -1 where lit
  std::vector<double> EmissionPoints; ///< 3
  std::vector<float> Directions;      ///< 3
  std::vector<float> Powers;          ///< W, mean over the wavelength samples: flux that the photon stands for
  std::vector<vtkIdType> PhotonIndices;
  std::vector<int> LightIds;
};

struct ShadowPhotons
{
  std::vector<double> Points; ///< 3, on the next surface behind the first occluder
  std::vector<float> Normals; ///< 3, of that surface
  std::vector<float> Directions;
  std::vector<float> Powers;    ///< W, negative: the flux that is missing there
  std::vector<int> OccluderIds; ///< of the occluder that casts the shadow
  std::vector<int> ReceiverIds; ///< occluder id of the surface that was reached
  std::vector<vtkIdType> PhotonIndices;
  std::vector<int> LightIds;
};

struct ShadowVectorResult
{
  ShadowVectors Vectors;
  PhotonPaths Paths;
  ShadowPhotons Photons;
  vtkIdType NumberOfPhotons = 0;          ///< emitted by all pieces together
  std::vector<vtkIdType> PhotonsOfLights; ///< of these, one value a light
  double MeanSolidAngle = 0.0;            ///< sr, into which photons were aimed, mean over those traced
  vtkIdType MinimumVectors = 0;           ///< that each occluder was to have of each light
  vtkIdType NumberOfScarce = 0;       ///< pairs of an occluder and a light that have fewer nevertheless, and not none
  /// NumberOfPhotons that would give these MinimumVectorsPerOccluder, about; 0: none would, or a target was asked for.
  vtkIdType PhotonsForScarce = 0;
  vtkIdType NumberOfAimedPhotons = 0; ///< the first ones
};

/**
 * Trace photons. Photon i is a pure function of (Seed, i): stratified over the light and over the directions towards the
 * occluders' bounds by a scrambled Sobol sequence. Every occluder along a path stores one vector.
 *
 * Lights share the photons by power: see PhotonEmission::Power and LightShares. Each has the photons that it would have
 * alone, but fewer; their powers make up for that. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool TraceShadowVectors(const OccluderScene& scene, const std::vector<Light>& lights,
  const ShadowVectorOptions& options, const Monitor& monitor, ShadowVectorResult& result);
/// The same for one light.
SHADOWCONESCORE_EXPORT bool TraceShadowVectors(const OccluderScene& scene, const Light& light,
  const ShadowVectorOptions& options, const Monitor& monitor, ShadowVectorResult& result);

} // namespace shadowcones

#endif
