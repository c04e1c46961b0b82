// SPDX-License-Identifier: BSD-3-Clause
#include "scLitMinusBlockedScene.h"

#include "scBlockedLight.h"
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
/// The image's mean over wavelengths, from few samples of rays all over it, whatever part of it is asked for.
double LookAtImage(const LitMinusBlockedScene& shared)
{
  const ScatteringScene& scene = shared.Context.Scene;
  const int width = shared.Context.Options.Width;
  const int height = shared.Context.Options.Height;
  LitProfiler profiler(shared.Lit);
  LitSums sums(shared.Context.Groups);
  MediumOpticalDepth depth(scene.Medium);
  BlockedLight blocked(shared.Context);
  LitPixel pixel;
  pixel.Values.resize(shared.Lit.Layout.Size());
  double shown = 0.0;
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
    blocked.EstimateFrom(lookSamples, sums, { { interval.Begin, interval.EndOfMarch } },
      HashSeed(shared.Context.Options.Seed, static_cast<std::uint64_t>(k)));
    for (std::size_t g = 0; g < blocked.Left().size(); ++g)
    {
      shown += shared.Context.Groups.MeanScatteredRadiance[g] * blocked.Left()[g];
    }
  }
  const double rays = lookSide * lookSide;
  return std::max(shown / rays, shared.TypicalMean / (rays * lookSamples));
}
} // anonymous namespace

LitMinusBlockedScene::LitMinusBlockedScene(const RenderContext& context)
  : Context(context)
  , Lit(context.Scene.Light, context.Scene.Medium, context.Groups)
  , TypicalSums(TypicalLitSums(this->Lit, context.Scene.Camera, context.Options.Width, context.Options.Height))
  , TypicalMean(std::inner_product(context.Groups.MeanScatteredRadiance.begin(),
      context.Groups.MeanScatteredRadiance.end(), TypicalSums.begin(), 0.0))
{
  const ScatteringScene& scene = context.Scene;
  const ScatteringOptions& options = context.Options;
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
  }
}

LitMinusBlockedScene::~LitMinusBlockedScene() = default;

} // namespace shadowcones
