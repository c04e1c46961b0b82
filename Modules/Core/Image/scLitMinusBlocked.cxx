// SPDX-License-Identifier: BSD-3-Clause
#include "scLitMinusBlocked.h"

#include "scMediumInterval.h"
#include "scRandom.h"
#include "scVisibilityGridSampler.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int blockSide = LitMinusBlocked::BlockSide;
/// A pixel whose look sees no light takes no more samples than this, where none of so many a pixel does in all its
/// block.
constexpr int darkSamples = 64;
constexpr int blockSamples = 16;
constexpr int blockLines = 2;
} // anonymous namespace

LitMinusBlocked::LitMinusBlocked(const LitMinusBlockedScene& shared, const PrimaryHits& hits, ScatteringImage& image)
  : Shared(shared)
  , Scene(shared.Context.Scene)
  , Options(shared.Context.Options)
  , Groups(shared.Context.Groups)
  , Hits(hits)
  , Image(image)
  , Tile(shared.Lit, Scene.Camera, Options.Width, Options.Height, shared.Tolerance, shared.TypicalSums)
  , Sums(Groups)
  , OpticalDepth(Scene.Medium)
  , Blocked(shared.Context, shared.Legs.get())
  , OtherSums(Groups)
  , OtherBlocked(shared.Context, shared.Legs.get())
{
  if (shared.Lines)
  {
    this->Lines = std::make_unique<LinesOfLight>(shared.Context, *shared.Lines, shared.Legs.get());
    this->OtherLines = std::make_unique<LinesOfLight>(shared.Context, *shared.Lines, shared.Legs.get());
  }
  if (this->Scene.Cones && this->Options.Mode == ScatteringMode::Guided)
  {
    this->Beam = std::make_unique<ConeBeam>(*this->Scene.Cones);
  }
}

void LitMinusBlocked::RenderTile(const TileRange& tile)
{
  this->Tile.MoveTo(tile.I0 / LitTile::Side * LitTile::Side, tile.J0 / LitTile::Side * LitTile::Side);
  for (const TileRange& block : TilesOf({ tile.I0, tile.I1, tile.J0, tile.J1 }, blockSide))
  {
    this->RenderBlock(block);
  }
}

void LitMinusBlocked::RenderBlock(const TileRange& block)
{
  // The whole block, also where less of it is asked for: results do not depend on that.
  const int i0 = block.I0 / blockSide * blockSide;
  const int j0 = block.J0 / blockSide * blockSide;
  const int i1 = i0 + blockSide - 1;
  const int j1 = j0 + blockSide - 1;
  this->BlockI = i0;
  this->BlockJ = j0;
  this->Darkness = -1;
  // Rays at edges lie anywhere in their pixels.
  const double corners[4][2] = { { i0 - 0.5, j0 - 0.5 }, { i1 + 0.5, j0 - 0.5 }, { i1 + 0.5, j1 + 0.5 },
    { i0 - 0.5, j1 + 0.5 } };
  if (this->Beam)
  {
    std::array<Ray, 4> rays;
    for (std::size_t k = 0; k < 4; ++k)
    {
      rays[k] = this->Hits.RayOf(corners[k][0], corners[k][1]);
    }
    this->Beam->Gather(rays);
  }
  if (this->Shared.Grid)
  {
    bool alike = true;
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->Tile.Interpolate(corners[k][0], corners[k][1], this->Corners[k]);
      alike = alike && !this->Corners[k].Interval.Empty() &&
        this->Corners[k].Interval.Faces == this->Corners[0].Interval.Faces;
    }
    this->CellsInShadow = alike ? this->Shared.Grid->CellsInShadow(this->Corners) : ~std::uint64_t(0);
  }
  for (int j = block.J0; j <= block.J1; ++j)
  {
    for (int i = block.I0; i <= block.I1; ++i)
    {
      this->RenderPixel(i, j);
    }
  }
}

void LitMinusBlocked::RenderPixel(int i, int j)
{
  const ExtinctionGroups& groups = this->Groups;
  const std::uint64_t seed = HashSeed(this->Options.Seed, PixelIndex(this->Options, i, j));
  this->Hits.RaysOf(i, j, this->Rays);
  this->LeftOfPixel.assign(static_cast<std::size_t>(groups.Count()), 0.0);
  double variance = 0.0;
  int samples = 0;
  bool any = false;
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const PixelRay& part = this->Rays[k];
    this->Tile.Interpolate(part.I, part.J, this->Pixel);
    if (!this->EstimateRay(part.Hit, this->Rays.size() > 1 ? HashSeed(seed, k + 1) : seed))
    {
      continue; // beside the medium, or behind the light
    }
    any = true;
    for (std::size_t g = 0; g < this->Left.size(); ++g)
    {
      this->LeftOfPixel[g] += part.Fraction * this->Left[g];
    }
    variance += part.Fraction * part.Fraction * this->Variance;
    samples += this->Samples;
  }
  if (!any)
  {
    return;
  }
  const std::size_t index = this->Image.IndexOf(i, j);
  this->Image.SampleCount[index] = samples;
  const double mean =
    groups.ToRadiance(this->LeftOfPixel, this->Image.InScattering.data() + index * groups.ScatteredRadiance.size());
  // An estimate of nothing may stand for something: it is wrong by all of it.
  const double relative = mean > 0.0 ? std::sqrt(variance) / mean : (variance > 0.0 ? 1.0 : 0.0);
  const bool known = this->Options.Mode == ScatteringMode::Guided;
  this->Image.RelativeError[index] = known ? static_cast<float>(relative) : -1.0f;
  this->Image.MediumError[index] = known ? static_cast<float>(std::sqrt(variance)) : -1.0f;
}

void LitMinusBlocked::FindIntervals(const Ray& ray, const MediumInterval& interval)
{
  if (this->Beam)
  {
    this->Beam->Intersect(ray, interval.Begin, interval.EndOfMarch, this->Intervals);
  }
  else
  {
    this->Intervals.assign(1, { interval.Begin, interval.EndOfMarch });
  }
}

/// Where all of many samples of all rays of the block are blocked, one of its rays needs no more of them to be
/// believed.
bool LitMinusBlocked::IsBlockDark()
{
  if (this->Darkness >= 0)
  {
    return this->Darkness > 0;
  }
  this->Darkness = 1;
  for (int k = 0; k < blockSide * blockSide && this->Darkness > 0; ++k)
  {
    // In leaps over the block: light is soon found where there is some.
    const int place = 37 * k % (blockSide * blockSide);
    this->Tile.Interpolate(this->BlockI + place % blockSide, this->BlockJ + place / blockSide, this->OtherPixel);
    const Ray& ray = this->OtherPixel.Line;
    const LitInterval& lit = this->OtherPixel.Interval;
    const MediumInterval interval = MediumIntervalOf(
      this->Scene.Medium.Bounds, this->Scene.Occluders, ray, NearestSurface(this->Scene.Occluders, ray));
    if (!interval.Crosses || lit.Empty())
    {
      continue;
    }
    this->FindIntervals(ray, interval);
    MediumOpticalDepth depth(this->Scene.Medium);
    depth.SetRay(ray.Origin, ray.Direction, lit.MediumBegin, lit.End);
    this->OtherSums.Add(this->OtherPixel, interval.EndOfMarch, depth.IsHomogeneous() ? nullptr : &depth);
    this->OtherSums.Accumulate();
    const std::uint64_t seed = HashSeed(HashSeed(this->Options.Seed, static_cast<std::uint64_t>(place)),
      PixelIndex(this->Options, this->BlockI, this->BlockJ));
    const bool light = this->OtherLines && this->OtherLines->Fit(this->OtherPixel)
      ? this->SeesLight(*this->OtherLines, blockLines, seed)
      : this->SeesLight(this->OtherBlocked, blockSamples, seed);
    this->Darkness = light ? 0 : 1;
  }
  return this->Darkness > 0;
}

/// Along the other ray of the block.
template <class Estimator>
bool LitMinusBlocked::SeesLight(Estimator& estimator, int count, std::uint64_t seed)
{
  estimator.EstimateFrom(count, this->OtherSums, this->Intervals, seed);
  this->OcclusionRays += estimator.NumberOfOcclusionRays();
  this->ShadowLines += estimator.NumberOfLines();
  return estimator.SeesLight();
}

/// What occluders leave of the sums, in the intervals.
template <class Estimator>
void LitMinusBlocked::EstimateBy(Estimator& estimator, std::uint64_t seed)
{
  const double smallest = LitMinusBlockedScene::DarkestFraction * this->Shared.TypicalMean;
  const double tableError = this->Shared.Legs ? this->Shared.Legs->ErrorOfRays : 0.0;
  estimator.Look(this->Sums, this->Intervals,
    { this->Shared.Darkest, (0.5 * this->Pixel.Tolerance + tableError) * std::max(this->Sums.Mean(), smallest) }, seed);
  const bool dark =
    estimator.LooksDark() && estimator.NumberOfWantedSamples() > darkSamples && this->IsBlockDark();
  estimator.Estimate(dark ? darkSamples : this->Options.MaximumSamples);
  this->Left = estimator.Left();
  this->Variance = estimator.Variance();
  this->Samples = estimator.NumberOfSamples();
  this->OcclusionRays += estimator.NumberOfOcclusionRays();
  this->ShadowLines += estimator.NumberOfLines();
}

/// What is left of the light along the ray of Pixel, up to a surface. @return false where the ray has none.
bool LitMinusBlocked::EstimateRay(const PrimaryHit& hit, std::uint64_t seed)
{
  const Ray& ray = this->Pixel.Line;
  const LitInterval& lit = this->Pixel.Interval;
  const MediumInterval interval = MediumIntervalOf(this->Scene.Medium.Bounds, this->Scene.Occluders, ray, hit);
  if (!interval.Crosses || lit.Empty())
  {
    return false;
  }
  const bool homogeneous = this->OpticalDepth.IsHomogeneous();
  if (!homogeneous)
  {
    this->OpticalDepth.SetRay(ray.Origin, ray.Direction, lit.MediumBegin, lit.End);
  }
  this->Sums.Add(this->Pixel, interval.EndOfMarch, homogeneous ? nullptr : &this->OpticalDepth);
  this->Left = this->Sums.Groups();
  this->Variance = 0.0;
  this->Samples = 0;
  if (this->Options.Mode == ScatteringMode::Guided)
  {
    this->FindIntervals(ray, interval);
    if (!this->Intervals.empty())
    {
      this->Sums.Accumulate();
    }
    this->Lines && this->Lines->Fit(this->Pixel) ? this->EstimateBy(*this->Lines, seed)
                                                 : this->EstimateBy(this->Blocked, seed);
  }
  else if (this->Shared.Grid)
  {
    // Cells of a ray that passes other faces of the medium lie elsewhere.
    const bool alike = lit.Faces == this->Corners[0].Interval.Faces;
    this->Hidden.assign(this->Left.size(), 0.0);
    this->Samples = this->Shared.Grid->Walk(this->Sums, alike ? this->CellsInShadow : ~std::uint64_t(0), this->Hidden);
    for (std::size_t g = 0; g < this->Left.size(); ++g)
    {
      this->Left[g] -= this->Hidden[g];
    }
  }
  return true;
}

} // namespace shadowcones
