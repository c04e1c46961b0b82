// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfaceLight.h
 * @brief What reaches a point on a surface from one light, to a wanted error. Internal to Core.
 *
 * Unshadowed light comes from a rule over the light that is refined until two of its levels agree. Where something may
 * hide the light, a first look with few rays says what share of it is seen, about, and how many rays are needed: of the
 * light that is sampled after that, independently of the look, only what differs from that share is noise. So nothing
 * is left, exactly, where all rays are blocked, and all of the light where none is; and since no sample decides whether
 * it counts, the mean is right for any number of them.
 */
#ifndef scSurfaceLight_h
#define scSurfaceLight_h

#include "scExtinctionGroups.h"
#include "scLightSampler.h"
#include "scMediumOpticalDepth.h"
#include "scShadingLight.h"
#include "scShiftedGrid.h"
#include "scSurfacePoint.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// What is known of the light at a point.
struct SurfaceEstimate
{
  std::vector<double> Irradiance; ///< per extinction group, for a light of radiance 1
  double Mean = 0.0;              ///< radiance at the camera, mean over wavelengths; after Look() a first guess
  double Variance = 0.0;          ///< its squared standard error; after Look() not known
  bool StopsShort = false;        ///< MaximumSamples are not enough for what was wanted

  /// Of the look.
  std::vector<double> Lit;     ///< unshadowed, per extinction group
  std::vector<double> Weights; ///< from irradiance to the mean radiance at the camera, per extinction group
  double MeanLit = 0.0;        ///< the mean radiance of all of Lit
  double LitError = 0.0;
  bool LitIsKnown = false; ///< well enough to be used
  bool IsDone = false;     ///< nothing is to be sampled
  bool Traces = false;     ///< something may be in the way
  bool MayMiss = false;    ///< so samples may have missed something; in Medium too: it claims what BruteForce does
  double Share = 0.0;      ///< of the light, that is seen
  double Edges = 0.0;      ///< variance of n samples times n^(3/2)
  bool Agrees = false;     ///< all samples say the same of what is in the way
};

/// Looks at one light, one a thread.
class SurfaceLight
{
public:
  /// Everything must outlive it.
  SurfaceLight(const ShadingLight& light, const ScatteringOptions& options, const ExtinctionGroups& groups);

  /// Unshadowed light, and a first look of so many samples at what is in the way. @p key tells a pixel's rays apart.
  void Look(
    const SurfacePoint& point, int samples, std::uint64_t key, const PixelShift& shift, SurfaceEstimate& estimate);
  /**
   * After a look, of the same point: the estimate, with as many samples as make its variance @p allowed. Where all of a
   * look is dark a second one, with as many, has the last word on their number.
   * @param allowedInTheDark the same where no sample of the looks sees the light.
   */
  void Finish(const SurfacePoint& point, double allowed, double allowedInTheDark, std::uint64_t key,
    const PixelShift& shift, SurfaceEstimate& estimate);

  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  /// Samples of one grid.
  struct Samples
  {
    std::vector<Vector3> Directions;
    std::vector<double> Distances;
    std::vector<double> Weights; ///< with the cosine to the normal; 0: sends nothing
    std::vector<char> Seen;
    std::vector<double> Values; ///< of the mean radiance, over which the error is estimated
    int NumberOfLit = 0;
    int NumberOfSeen = 0;

    bool Agree() const { return this->NumberOfSeen == 0 || this->NumberOfSeen == this->NumberOfLit; }
  };

  double MeanOf(const std::vector<double>& irradiance, const SurfaceEstimate& estimate) const;
  double OpticalDepthTo(const SurfacePoint& point, const Vector3& direction, double distance) const;
  void AddRule(const LightRule& rule, const SurfacePoint& point, bool attenuated, std::vector<double>& sums);
  void Illuminate(const SurfacePoint& point, SurfaceEstimate& estimate);
  void LookAgain(const SurfacePoint& point, int samples, std::uint64_t seed, const PixelShift& shift,
    SurfaceEstimate& estimate);
  void TakeOne(const SurfacePoint& point, SurfaceEstimate& estimate);
  /// Draw and trace the samples of a grid.
  void Draw(const SurfacePoint& point, const ShiftedGrid& grid, bool traces);
  void Trace(const SurfacePoint& point);
  double Add(const SurfacePoint& point, double share, const SurfaceEstimate& estimate);
  double EdgesOf(const ShiftedGrid& grid, const SurfaceEstimate& estimate) const;
  int SamplesFor(double allowed, const SurfaceEstimate& estimate) const;
  /// Squared error of @p samples where they may have missed something.
  double Unseen(bool agree, double samples, const SurfaceEstimate& estimate) const;

  const ShadingLight& Shading;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const MediumOpticalDepth OpticalDepth;
  LightSampler Sampler;
  Samples Drawn;
  std::vector<double> Visible;   ///< of samples that see the light
  std::vector<double> Coarse;    ///< of a rule, per group
  std::vector<double> Means;     ///< of samples, per group
  std::vector<float> RuleValues; ///< weight, cosine and length in the medium of each point of a light rule
  vtkIdType OcclusionRays = 0;
};

} // namespace shadowcones

#endif
