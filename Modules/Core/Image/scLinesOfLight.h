// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLinesOfLight.h
 * @brief What occluders leave of the medium term of a camera ray, whole lines at a time. Internal to Core.
 *
 * BlockedLight samples places and light points together. Here a sample is a light point alone: what it lights of the ray
 * is known exactly (see scLineShadows.h), edges of shadows and beams thinner than any step included, and few light
 * points make an image. What all of the lamp sends from there is known from the profile; by how much this point of it
 * sends more or less is asked at places spread evenly over the unshadowed light, on what is lit of the ray and on what
 * is hidden, which takes no ray. What is left is the unshadowed light of the intervals times a ratio of two sums over
 * the same light points, as in BlockedLight.
 */
#ifndef scLinesOfLight_h
#define scLinesOfLight_h

#include "scBlockedLight.h"
#include "scIntervalLight.h"
#include "scLightSampling.h"
#include "scLightStrata.h"
#include "scLineShadows.h"
#include "scLitSums.h"
#include "scMediumOpticalDepth.h"
#include "scRandom.h"
#include "scRayInterval.h"
#include "scRenderContext.h"
#include "scVisibleRatio.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// One a thread.
class LinesOfLight
{
public:
  /// A line counts as so many samples and rays: it costs what they do, about.
  static constexpr int SamplesOfLine = 16;

  /// @param legs as of BlockedLight.
  LinesOfLight(const RenderContext& context, const LineShadows& shadows, const LightLegs* legs = nullptr);

  /// May the light of such lamps be told by lines at all?
  static bool Fit(const RenderContext& context);
  /// Does the ray keep away from the lamp, whose points are as good as each other then?
  bool Fit(const LitPixel& pixel) const;

  /// As in BlockedLight, whose description holds here too.
  void Look(const LitSums& lit, const std::vector<RayInterval>& intervals, const BlockedLight::Yardstick& yardstick,
    std::uint64_t seed);
  bool LooksDark() const { return this->Wanted > 0.0 && this->Ratio.Ratio() == 0.0; }
  bool SeesLight() const { return !this->Passes.empty() && this->Ratio.Ratio() > 0.0; }
  double NumberOfWantedSamples() const { return SamplesOfLine * this->Wanted; }
  void Estimate(int mostSamples);
  void EstimateFrom(int lines, const LitSums& lit, const std::vector<RayInterval>& intervals, std::uint64_t seed);

  const std::vector<double>& Left() const { return this->Ratio.Left(); }
  double Variance() const { return this->SquaredError; }
  int NumberOfSamples() const { return SamplesOfLine * this->Lines; }
  vtkIdType NumberOfOcclusionRays() const { return static_cast<vtkIdType>(SamplesOfLine) * this->LinesAsked; }
  vtkIdType NumberOfLines() const { return this->LinesAsked; }

private:
  struct Pass
  {
    std::size_t First = 0; ///< of its lines' values
    int Count = 0;
    double Weight = 0.0;
  };
  /// A part of the ray, and the unshadowed light up to it and in it by the distribution of places.
  struct Piece
  {
    double Begin = 0.0;
    double Light = 0.0;
    double From = 0.0; ///< as distances
    double To = 0.0;
  };

  bool Begin(const LitSums& lit, const std::vector<RayInterval>& intervals);
  void Forget();
  void Sample(int count, std::uint64_t seed);
  void AddLine(const LightSurfaceSample& point, double weight, RandomStream& random);
  void CutPieces();
  void SumUp();
  void AddUpTo(double t, double factor, std::vector<double>& sums) const;
  void AddDifferences(const std::vector<Piece>& pieces, double light, const LightSurfaceSample& point,
    RandomStream& random, std::vector<double>& sums) const;
  double SentBy(const LightSurfaceSample& point, double t, double& depth) const;
  void Conclude(double litError);
  double Allowed() const;
  double VarianceOf(const Pass& pass);
  double UnseenVariance(int count) const;
  double Unseen() const;
  double LinesFor(double variance);
  int MostLines(int mostSamples) const;

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const LineShadows& Shadows;
  const RayRules Rules;
  MediumOpticalDepth OpticalDepth;
  const LightLegs* Legs;
  Vector3 LampCenter;
  double LampRadius = 0.0;
  IntervalLight Intervals;
  LineAndLight Query;
  double Apparent = 0.0;  ///< radius of the lamp as seen from the ray: over its distance
  bool HasPieces = false; ///< of this ray
  BlockedLight::Yardstick Measure;
  std::uint64_t Seed = 0;
  double Wanted = 0.0;              ///< lines of the next pass; 0: nothing to do
  std::vector<RayInterval> Hidden;  ///< of the line at hand
  std::vector<Piece> VisiblePieces; ///< of it
  std::vector<Piece> HiddenPieces;
  double VisibleLight = 0.0; ///< by the distribution of places
  double HiddenLight = 0.0;
  std::vector<double> Before;    ///< unshadowed light before each cell, group by group
  std::vector<double> Unhidden;  ///< unshadowed light of the visible pieces, per group
  std::vector<double> OfVisible; ///< of the line at hand, per group
  std::vector<double> OfHidden;
  std::vector<Pass> Passes;
  std::vector<double> AllOfLine; ///< means over wavelengths
  std::vector<double> VisibleOfLine;
  std::vector<double> Residuals; ///< of a pass
  double SumOfWeights = 0.0;
  VisibleRatio Ratio;
  double SampledVariance = 0.0;
  double SquaredError = 0.0;
  int Lines = 0;
  vtkIdType LinesAsked = 0;
};

} // namespace shadowcones

#endif
