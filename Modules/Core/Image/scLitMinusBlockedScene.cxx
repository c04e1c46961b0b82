// SPDX-License-Identifier: BSD-3-Clause
#include "scLitMinusBlockedScene.h"

#include "scBlockedLight.h"
#include "scLightLegsChoice.h"
#include "scLinesOfLight.h"
#include "scLitPixel.h"
#include "scLitTile.h"
#include "scMediumInterval.h"
#include "scRandom.h"
#include "scVisibilityGridSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace shadowcones
{
namespace
{
/// The image's mean is looked at along so many rays by so many, with samples each; at less than one in all of them it
/// is not known.
constexpr int lookSide = 8;
constexpr int lookSamples = 16;
/// A line costs as much as so many samples, and as much for every group of triangles that is looked at.
constexpr double costOfLine = 3.0;
constexpr double costOfGroup = 0.15;
/// Lines are not thought of where a mesh has more triangles.
constexpr vtkIdType mostTriangles = 1 << 16;

/// Largest error of the unshadowed light over itself, and this share of what Guided's pixels may err by. Rays that are
/// not checked err by half of it, say.
constexpr double litTolerance = 1e-3;
constexpr double litFraction = 0.2;
/// What samples and lines would cost, and how good a table is to be, is told for this goal where none is given.
constexpr double usualGoal = 0.01;
/// Standard errors that a table of the density towards the light may bring, of that tolerance; where pixels say by how
/// much they err, of the goal; and those of single ways, of the goal.
constexpr double tableFraction = 0.25;
constexpr double goalFraction = 0.2;
constexpr double legsFraction = 0.4;

double LitTolerance(const ScatteringOptions& options)
{
  const double goal = options.Mode == ScatteringMode::Guided ? options.RelativeErrorGoal : 0.0;
  return goal > 0.0 ? std::min(litTolerance, litFraction * goal) : litTolerance;
}

LightLegsTolerance LegsTolerance(const ScatteringOptions& options)
{
  if (options.Mode != ScatteringMode::Guided)
  {
    return { tableFraction * litTolerance, HUGE_VAL }; // only samples ask for single ways
  }
  const double goal = options.RelativeErrorGoal > 0.0 ? options.RelativeErrorGoal : usualGoal;
  return { goalFraction * goal, legsFraction * goal };
}

/// Call visit(sums, intervals, seed) for rays all over the image, whatever part of it is asked for.
template <typename Visitor>
void LookAlongRays(const LitMinusBlockedScene& shared, Visitor&& visit)
{
  const ScatteringScene& scene = shared.Context.Scene;
  const int width = shared.Context.Options.Width;
  const int height = shared.Context.Options.Height;
  LitProfiler profiler(shared.Lit);
  LitSums sums(shared.Context.Groups);
  MediumOpticalDepth depth(scene.Medium);
  LitPixel pixel;
  pixel.Values.resize(shared.Lit.Layout.Size());
  for (int k = 0; k < lookSide * lookSide; ++k)
  {
    pixel.Line = scene.Camera.PixelRay(
      (k % lookSide + 0.5) * width / lookSide, (k / lookSide + 0.5) * height / lookSide, width, height);
    pixel.Interval = shared.Lit.Intervals.Find(pixel.Line);
    const MediumInterval interval =
      MediumIntervalOf(scene.Medium.Bounds, scene.Occluders, pixel.Line, NearestSurface(scene.Occluders, pixel.Line));
    if (!interval.Crosses || pixel.Interval.Empty())
    {
      continue;
    }
    profiler.Evaluate(pixel.Line, pixel.Interval, shared.Lit.FirstLevel(), pixel.Values.data());
    FinishPixel(shared.Lit, pixel);
    depth.SetRay(pixel.Line.Origin, pixel.Line.Direction, pixel.Interval.MediumBegin, pixel.Interval.End);
    sums.Add(pixel, interval.EndOfMarch, depth.IsHomogeneous() ? nullptr : &depth);
    sums.Accumulate();
    visit(sums, std::vector<RayInterval>{ { interval.Begin, interval.EndOfMarch } },
      HashSeed(shared.Context.Options.Seed, static_cast<std::uint64_t>(k)));
  }
}

/// The image's mean over wavelengths, from few samples of each ray.
double LookAtImage(const LitMinusBlockedScene& shared)
{
  BlockedLight blocked(shared.Context, shared.Legs.get());
  double shown = 0.0;
  LookAlongRays(shared,
    [&](const LitSums& sums, const std::vector<RayInterval>& intervals, std::uint64_t seed)
    {
      blocked.EstimateFrom(lookSamples, sums, intervals, seed);
      for (std::size_t g = 0; g < blocked.Left().size(); ++g)
      {
        shown += shared.Context.Groups.MeanScatteredRadiance[g] * blocked.Left()[g];
      }
    });
  const double rays = lookSide * lookSide;
  return std::max(shown / rays, shared.TypicalMean / (rays * lookSamples));
}

/// What samples of a few rays would cost, and what lines would: by counts, so that the answer is always the same.
bool LinesCostLess(const LitMinusBlockedScene& shared, const LineShadows& shadows)
{
  ScatteringOptions options = shared.Context.Options;
  options.RelativeErrorGoal = options.RelativeErrorGoal > 0.0 ? options.RelativeErrorGoal : usualGoal;
  const RenderContext context(shared.Context.Scene, options);
  BlockedLight blocked(context, shared.Legs.get());
  LinesOfLight lines(context, shadows, shared.Legs.get());
  double bySamples = 0.0;
  double byLines = 0.0;
  LookAlongRays(shared,
    [&](const LitSums& sums, const std::vector<RayInterval>& intervals, std::uint64_t seed)
    {
      if (!lines.Fit(sums.Profile()))
      {
        return;
      }
      const BlockedLight::Yardstick yardstick{ shared.Darkest, 0.0 };
      const auto most = static_cast<double>(options.MaximumSamples);
      blocked.Look(sums, intervals, yardstick, seed);
      bySamples += blocked.NumberOfSamples() + std::min(blocked.NumberOfWantedSamples(), most);
      const std::int64_t before = LineShadows::GroupsLookedAt();
      lines.Look(sums, intervals, yardstick, seed);
      const double perLine = lines.NumberOfOcclusionRays() > 0
        ? costOfGroup * LinesOfLight::SamplesOfLine * static_cast<double>(LineShadows::GroupsLookedAt() - before) /
          static_cast<double>(lines.NumberOfOcclusionRays())
        : 0.0;
      byLines += (costOfLine + perLine) * (lines.NumberOfSamples() + std::min(lines.NumberOfWantedSamples(), most)) /
        LinesOfLight::SamplesOfLine;
    });
  return byLines < bySamples;
}
} // anonymous namespace

LitMinusBlockedScene::LitMinusBlockedScene(const RenderContext& context, const Monitor& monitor)
  : Context(context)
  , Lit(context.Scene.Light, context.Scene.Medium, context.Groups)
  , Tolerance(LitTolerance(context.Options))
  , Legs(ChooseLightLegs(Lit, context.Scene.Camera, context.Options, LegsTolerance(context.Options), monitor))
  , TypicalSums(TypicalLitSums(this->Lit, context.Scene.Camera, context.Options.Width, context.Options.Height))
  , TypicalMean(std::inner_product(context.Groups.MeanScatteredRadiance.begin(),
      context.Groups.MeanScatteredRadiance.end(), TypicalSums.begin(), 0.0))
{
  const ScatteringScene& scene = context.Scene;
  const ScatteringOptions& options = context.Options;
  this->Lit.UseTable(this->Legs.get());
  if (scene.Visibility && options.Mode != ScatteringMode::Guided)
  {
    if (!scene.Layout)
    {
      this->OwnGrid = std::make_unique<const VisibilityGridSampler>(*scene.Visibility);
    }
    this->Grid = scene.Layout ? scene.Layout : this->OwnGrid.get();
  }
  if (options.Mode == ScatteringMode::Guided)
  {
    this->Darkest = DarkestFraction * LookAtImage(*this);
    if (LinesOfLight::Fit(context) && scene.ShadowCasters().Mesh().NumberOfTriangles <= mostTriangles)
    {
      const LineShadows& lines = scene.ShadowCasters().Lines();
      this->Lines = LinesCostLess(*this, lines) ? &lines : nullptr;
    }
  }
}

LitMinusBlockedScene::~LitMinusBlockedScene() = default;

} // namespace shadowcones
