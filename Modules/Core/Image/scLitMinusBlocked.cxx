// SPDX-License-Identifier: BSD-3-Clause
#include "scLitMinusBlocked.h"

#include "scRandom.h"
#include "scVisibilityField.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{
namespace
{
/// Cones and grid cells are looked for once for so many pixels by so many.
constexpr int blockSide = 8;
/// Largest error of the unshadowed light over itself, and this share of what Guided's pixels may err by. Rays that are
/// not checked err by half of it, say.
constexpr double litTolerance = 1e-3;
constexpr double litShare = 0.2;
/// Pixels darker than this share of the image's mean are sampled as if they had it: of the mean unshadowed light what
/// that is read from, of what the image shows what is sampled.
constexpr double darkestShare = 0.1;
/// The image's mean is looked at along so many rays by so many, with samples each; at less than one in all of them it
/// is not known.
constexpr int lookSide = 8;
constexpr int lookSamples = 16;
/// A pixel whose look sees no light takes no more samples than this, where none of so many a pixel does in all its
/// block.
constexpr int darkSamples = 64;
constexpr int blockSamples = 16;

double LitTolerance(const ScatteringOptions& options)
{
  const double goal = options.Mode == ScatteringMode::Guided ? options.RelativeErrorGoal : 0.0;
  return goal > 0.0 ? std::min(litTolerance, litShare * goal) : litTolerance;
}

PrimaryHit NearestSurface(const OccluderScene& occluders, const Ray& ray)
{
  PrimaryHit hit;
  RayHit surface;
  if (occluders.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, surface))
  {
    hit.T = surface.T;
    hit.Triangle = surface.Triangle;
  }
  return hit;
}

/// The image's mean over wavelengths, from few samples of rays all over it, whatever part of it is asked for.
double LookAtImage(const LitMinusBlockedScene& shared)
{
  const ScatteringScene& scene = shared.Scene;
  const int width = shared.Options.Width;
  const int height = shared.Options.Height;
  LitProfiler profiler(shared.Lit);
  LitSums sums(shared.Groups);
  MediumDepth depth(scene.Fog);
  BlockedLight blocked(scene, shared.Options, shared.Groups);
  LitPixel pixel;
  pixel.Values.resize(shared.Lit.Layout.Size());
  double shown = 0.0;
  for (int k = 0; k < lookSide * lookSide; ++k)
  {
    pixel.Line = scene.Eye.PixelRay(
      (k % lookSide + 0.5) * width / lookSide, (k / lookSide + 0.5) * height / lookSide, width, height);
    pixel.Span = shared.Lit.Spans.Find(pixel.Line);
    const MediumSegment segment = SegmentInside(
      scene.Fog.Bounds, scene.Occluders, pixel.Line, NearestSurface(scene.Occluders, pixel.Line));
    if (!segment.Crosses || pixel.Span.Empty())
    {
      continue;
    }
    profiler.Evaluate(pixel.Line, pixel.Span, shared.Lit.FirstLevel(), pixel.Values.data());
    FinishPixel(shared.Lit, pixel);
    depth.SetRay(pixel.Line.Origin, pixel.Line.Direction, pixel.Span.MediumBegin, pixel.Span.End);
    sums.Add(pixel, segment.EndOfMarch, depth.IsHomogeneous() ? nullptr : &depth);
    sums.Accumulate();
    blocked.EstimateFrom(lookSamples, sums, { { segment.Begin, segment.EndOfMarch, -1 } },
      HashSeed(shared.Options.Seed, static_cast<std::uint64_t>(k)));
    for (std::size_t g = 0; g < blocked.Left().size(); ++g)
    {
      shown += shared.Groups.MeanSource[g] * blocked.Left()[g];
    }
  }
  const double rays = lookSide * lookSide;
  return std::max(shown / rays, shared.TypicalMean / (rays * lookSamples));
}
} // anonymous namespace

LitMinusBlockedScene::LitMinusBlockedScene(
  const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , Lit(scene.Source, scene.Fog, groups)
  , TypicalSums(TypicalLitSums(this->Lit, scene.Eye, options.Width, options.Height))
  , TypicalMean(std::inner_product(groups.MeanSource.begin(), groups.MeanSource.end(), TypicalSums.begin(), 0.0))
{
  if (scene.Visibility && options.Mode != ScatteringMode::Guided)
  {
    this->Field = std::make_unique<VisibilityField>(*scene.Visibility);
  }
  if (options.Mode == ScatteringMode::Guided)
  {
    this->Darkest = darkestShare * LookAtImage(*this);
  }
}

LitMinusBlockedScene::~LitMinusBlockedScene() = default;

LitMinusBlocked::LitMinusBlocked(const LitMinusBlockedScene& shared, const ScatteringOptions& options,
  const PrimaryHits& hits, ScatteringImage& image)
  : Shared(shared)
  , Options(options)
  , Hits(hits)
  , Image(image)
  , Tile(shared.Lit, shared.Scene.Eye, shared.Options.Width, shared.Options.Height,
      LitTolerance(shared.Options), shared.TypicalSums)
  , Sums(shared.Groups)
  , Depth(shared.Scene.Fog)
  , Blocked(shared.Scene, shared.Options, shared.Groups)
  , OtherSums(shared.Groups)
  , OtherBlocked(shared.Scene, shared.Options, shared.Groups)
{
  if (shared.Scene.Cones && shared.Options.Mode == ScatteringMode::Guided)
  {
    this->Beam = std::make_unique<ConeBeam>(*shared.Scene.Cones);
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
  if (this->Shared.Field)
  {
    bool alike = true;
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->Tile.Interpolate(corners[k][0], corners[k][1], this->Corners[k]);
      alike = alike && !this->Corners[k].Span.Empty() && this->Corners[k].Span.Faces == this->Corners[0].Span.Faces;
    }
    this->CellsInShadow = alike ? this->Shared.Field->CellsInShadow(this->Corners) : ~std::uint64_t(0);
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
  const ScatteringOptions& options = this->Options;
  const ExtinctionGroups& groups = this->Shared.Groups;
  const std::uint64_t seed = HashSeed(options.Seed, PixelIndex(options, i, j));
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
      this->LeftOfPixel[g] += part.Share * this->Left[g];
    }
    variance += part.Share * part.Share * this->Variance;
    samples += this->Samples;
  }
  if (!any)
  {
    return;
  }
  const std::size_t index = IndexInExtent(options, i, j);
  this->Image.SampleCount[index] = samples;
  const double mean =
    groups.ToRadiance(this->LeftOfPixel, this->Image.InScattering.data() + index * groups.Source.size());
  // An estimate of nothing may stand for something: it is wrong by all of it.
  const double relative = mean > 0.0 ? std::sqrt(variance) / mean : (variance > 0.0 ? 1.0 : 0.0);
  const bool known = options.Mode == ScatteringMode::Guided;
  this->Image.RelativeError[index] = known ? static_cast<float>(relative) : -1.0f;
  this->Image.MediumError[index] = known ? static_cast<float>(std::sqrt(variance)) : -1.0f;
}

void LitMinusBlocked::FindStretches(const Ray& ray, const MediumSegment& segment)
{
  if (this->Beam)
  {
    this->Beam->Intersect(ray, segment.Begin, segment.EndOfMarch, this->Stretches);
  }
  else
  {
    this->Stretches.assign(1, { segment.Begin, segment.EndOfMarch, -1 });
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
  const ScatteringScene& scene = this->Shared.Scene;
  this->Darkness = 1;
  for (int k = 0; k < blockSide * blockSide && this->Darkness > 0; ++k)
  {
    // In leaps over the block: light is soon found where there is some.
    const int place = 37 * k % (blockSide * blockSide);
    this->Tile.Interpolate(this->BlockI + place % blockSide, this->BlockJ + place / blockSide, this->OtherPixel);
    const Ray& ray = this->OtherPixel.Line;
    const MediumSpan& span = this->OtherPixel.Span;
    const MediumSegment segment =
      SegmentInside(scene.Fog.Bounds, scene.Occluders, ray, NearestSurface(scene.Occluders, ray));
    if (!segment.Crosses || span.Empty())
    {
      continue;
    }
    this->FindStretches(ray, segment);
    MediumDepth depth(scene.Fog);
    depth.SetRay(ray.Origin, ray.Direction, span.MediumBegin, span.End);
    this->OtherSums.Add(this->OtherPixel, segment.EndOfMarch, depth.IsHomogeneous() ? nullptr : &depth);
    this->OtherSums.Accumulate();
    this->OtherBlocked.EstimateFrom(blockSamples, this->OtherSums, this->Stretches,
      HashSeed(HashSeed(this->Options.Seed, static_cast<std::uint64_t>(place)),
        PixelIndex(this->Options, this->BlockI, this->BlockJ)));
    this->OcclusionRays += this->OtherBlocked.NumberOfOcclusionRays();
    this->Darkness = this->OtherBlocked.SeesLight() ? 0 : 1;
  }
  return this->Darkness > 0;
}

/// What is left of the light along the ray of Pixel, up to a surface. @return false where the ray has none.
bool LitMinusBlocked::EstimateRay(const PrimaryHit& hit, std::uint64_t seed)
{
  const ScatteringScene& scene = this->Shared.Scene;
  const Ray& ray = this->Pixel.Line;
  const MediumSpan& span = this->Pixel.Span;
  const MediumSegment segment = SegmentInside(scene.Fog.Bounds, scene.Occluders, ray, hit);
  if (!segment.Crosses || span.Empty())
  {
    return false;
  }
  const bool homogeneous = this->Depth.IsHomogeneous();
  if (!homogeneous)
  {
    this->Depth.SetRay(ray.Origin, ray.Direction, span.MediumBegin, span.End);
  }
  this->Sums.Add(this->Pixel, segment.EndOfMarch, homogeneous ? nullptr : &this->Depth);
  this->Left = this->Sums.Groups();
  this->Variance = 0.0;
  this->Samples = 0;
  if (this->Shared.Options.Mode == ScatteringMode::Guided)
  {
    this->FindStretches(ray, segment);
    if (!this->Stretches.empty())
    {
      this->Sums.Accumulate();
    }
    const double smallest = darkestShare * this->Shared.TypicalMean;
    this->Blocked.Look(this->Sums, this->Stretches,
      { this->Shared.Darkest, 0.5 * this->Pixel.Tolerance * std::max(this->Sums.Mean(), smallest) }, seed);
    const bool dark =
      this->Blocked.LooksDark() && this->Blocked.NumberOfWantedSamples() > darkSamples && this->IsBlockDark();
    this->Blocked.Estimate(dark ? darkSamples : this->Options.MaximumSamples);
    this->Left = this->Blocked.Left();
    this->Variance = this->Blocked.Variance();
    this->Samples = this->Blocked.NumberOfSamples();
    this->OcclusionRays += this->Blocked.NumberOfOcclusionRays();
  }
  else if (this->Shared.Field)
  {
    // Cells of a ray that passes other faces of the medium lie elsewhere.
    const bool alike = span.Faces == this->Corners[0].Span.Faces;
    this->Hidden.assign(this->Left.size(), 0.0);
    this->Samples =
      this->Shared.Field->Walk(this->Sums, alike ? this->CellsInShadow : ~std::uint64_t(0), this->Hidden);
    for (std::size_t g = 0; g < this->Left.size(); ++g)
    {
      this->Left[g] -= this->Hidden[g];
    }
  }
  return true;
}

} // namespace shadowcones
