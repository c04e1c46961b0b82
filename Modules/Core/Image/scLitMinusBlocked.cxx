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
/// Pixels that ask their neighbours take as many samples as make the noise this many times what a pixel may err by, unless
/// that takes more than the most.
constexpr double noiseOfLook = 2.0;
/// The random numbers of a look are no other samples'.
constexpr std::uint64_t numberOfLook = 0x4C6F6F6B;
/// In smaller images neighbours are not alike, and for a larger goal a pixel's own samples are few.
constexpr int smallestImage = 48;
constexpr double largestGoal = 0.02;
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

bool LitMinusBlocked::MayLookAround(const ScatteringOptions& options)
{
  return options.Mode == ScatteringMode::Guided && options.RelativeErrorGoal > 0.0 &&
    options.RelativeErrorGoal <= largestGoal && std::min(options.Width, options.Height) >= smallestImage;
}

bool LitMinusBlocked::LooksAround(const LitMinusBlockedScene& shared)
{
  return MayLookAround(shared.Context.Options) && !shared.Lines;
}

void LitMinusBlocked::AskNeighbours(const LookedPixels& looked)
{
  this->Looked = &looked;
  this->Neighbours.resize(static_cast<std::size_t>(looked.Levels()));
  SmoothShadow* coarser = nullptr;
  for (int level = looked.Levels() - 1; level >= 0; --level)
  {
    std::unique_ptr<SmoothShadow>& own = this->Neighbours[static_cast<std::size_t>(level)];
    own = std::make_unique<SmoothShadow>(
      looked, level, coarser, SmoothShadow::Wanted{ this->Options.RelativeErrorGoal, this->Shared.Darkest });
    coarser = own.get();
  }
}

void LitMinusBlocked::LookAtTile(const TileRange& tile, int level, LookedPixels& looked)
{
  this->Tile.MoveTo(tile.I0 / LitTile::Side * LitTile::Side, tile.J0 / LitTile::Side * LitTile::Side);
  if (level + 1 == looked.Levels())
  {
    this->PrepareTile(tile, looked);
  }
  const int fewest = lookLevels[level].Fewest;
  std::vector<TileRange> blocks = TilesOf({ tile.I0, tile.I1, tile.J0, tile.J1 }, lookLevels[level].Side);
  // All are judged before any is looked at: coarser blocks read the pixels of several.
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [this, level](const TileRange& block) { return this->IsKnown(block, level); }),
    blocks.end());
  for (const TileRange& block : blocks)
  {
    this->LookAtBlock(block, level, fewest, looked);
    const int samples = this->SamplesOfBlock(block, level, looked);
    if (samples > fewest)
    {
      this->LookAtBlock(block, level, samples, looked);
    }
  }
}

/// The unshadowed light of all pixels.
void LitMinusBlocked::PrepareTile(const TileRange& tile, LookedPixels& looked)
{
  for (const TileRange& block : TilesOf({ tile.I0, tile.I1, tile.J0, tile.J1 }, blockSide))
  {
    this->BeginBlock(block);
    for (int j = block.J0; j <= block.J1; ++j)
    {
      for (int i = block.I0; i <= block.I1; ++i)
      {
        this->LookAtPixel(i, j, 0, looked);
      }
    }
  }
}

/// Do coarser levels tell all pixels of a block?
bool LitMinusBlocked::IsKnown(const TileRange& block, int level)
{
  const auto coarser = static_cast<std::size_t>(level + 1);
  if (coarser >= this->Neighbours.size())
  {
    return false;
  }
  SmoothShadow& neighbours = *this->Neighbours[coarser];
  neighbours.MoveTo(block.I0, block.J0);
  for (int j = block.J0; j <= block.J1; ++j)
  {
    for (int i = block.I0; i <= block.I1; ++i)
    {
      if (this->Looked->At(i, j).Kind >= 0 && !neighbours.Of(i, j))
      {
        return false;
      }
    }
  }
  return true;
}

/// Those of its pixels that belong to this level alone.
void LitMinusBlocked::LookAtBlock(const TileRange& block, int level, int samples, LookedPixels& looked)
{
  const bool coarsest = level + 1 == looked.Levels();
  for (const TileRange& part : TilesOf({ block.I0, block.I1, block.J0, block.J1 }, blockSide))
  {
    this->BeginBlock(part);
    for (int j = part.J0; j <= part.J1; ++j)
    {
      for (int i = part.I0; i <= part.I1; ++i)
      {
        if (looked.At(i, j).Kind >= 0 && lookLevels[level].Has(i, j) && (coarsest || !lookLevels[level + 1].Has(i, j)))
        {
          this->LookAtPixel(i, j, samples, looked);
        }
      }
    }
  }
}

/// As many samples as a block's pixels are to take whose shadows differ; 0: no more than they have. The samples that decide
/// are no part of what is taken then.
int LitMinusBlocked::SamplesOfBlock(const TileRange& block, int level, const LookedPixels& looked) const
{
  const LookLevel& look = lookLevels[level];
  // Mixed differences of neighbours see neither a level nor a slope.
  double squares = 0.0;
  double shown = 0.0;
  double whole = 0.0;
  int count = 0;
  const auto isInside = [&block](int i, int j)
  { return i >= block.I0 && i <= block.I1 && j >= block.J0 && j <= block.J1; };
  for (int j = block.J0; j <= block.J1; ++j)
  {
    for (int i = block.I0; i <= block.I1; ++i)
    {
      double mixed = 0.0;
      double noise = 0.0; // where a pixel of a first look has 1
      bool alike = look.Has(i, j);
      for (int k = 0; k < 4 && alike; ++k)
      {
        const int a = i + (k & 1) * look.Along[0] + (k >> 1) * look.Across[0];
        const int b = j + (k & 1) * look.Along[1] + (k >> 1) * look.Across[1];
        alike = isInside(a, b) && looked.At(a, b).Kind >= 0 && looked.At(a, b).Kind == looked.At(i, j).Kind &&
          looked.At(a, b).Samples > 0;
        if (alike)
        {
          const auto value = static_cast<double>(looked.At(a, b).Shown);
          mixed += k == 0 || k == 3 ? value : -value;
          noise += std::pow(static_cast<double>(look.Fewest) / looked.At(a, b).Samples, 1.5);
        }
      }
      if (alike)
      {
        squares += mixed * mixed / noise;
        shown += static_cast<double>(looked.At(i, j).Shown * looked.At(i, j).Whole);
        whole += static_cast<double>(looked.At(i, j).Whole);
        count += 1;
      }
    }
  }
  if (!(squares > 0.0))
  {
    return 0;
  }
  const double least = std::max(shown, count * this->Shared.Darkest) / whole;
  const double noise = std::sqrt(squares / count) / (noiseOfLook * this->Options.RelativeErrorGoal * least);
  const double samples = look.Fewest * std::pow(noise, 4.0 / 3.0);
  return samples > look.Most ? 0 : static_cast<int>(std::min<double>(std::ceil(samples), this->Options.MaximumSamples));
}

/// @param samples 0: the unshadowed light alone.
void LitMinusBlocked::LookAtPixel(int i, int j, int samples, LookedPixels& looked)
{
  LookedPixel& pixel = looked.At(i, j);
  pixel = LookedPixel();
  MediumInterval interval;
  this->Hits.RaysOf(i, j, this->Rays);
  if (this->Rays.size() != 1)
  {
    return; // an edge
  }
  this->Tile.Interpolate(i, j, this->Pixel);
  if (!this->BeginRay(this->Rays.front().Hit, interval) || !(this->Sums.Mean() > 0.0))
  {
    return;
  }
  this->FindIntervals(this->Pixel.Line, interval);
  if (!this->Intervals.empty())
  {
    this->Sums.Accumulate();
  }
  const bool surface = this->Rays.front().Hit.HasSurface() && interval.End >= this->Rays.front().Hit.T;
  pixel.Kind = 2 * this->Pixel.Interval.Faces + (surface ? 1 : 0);
  pixel.Whole = static_cast<float>(this->Sums.Mean());
  pixel.LitError = static_cast<float>(this->LitError());
  const std::vector<double>* inside = nullptr;
  if (samples == 0)
  {
    inside = this->Blocked.FindInside(this->Sums, this->Intervals);
  }
  else
  {
    const std::uint64_t seed = HashSeed(this->Options.Seed, PixelIndex(this->Options, i, j));
    this->Blocked.EstimateFrom(std::min(samples, this->Options.MaximumSamples), this->Sums, this->Intervals,
      HashSeed(seed, numberOfLook + static_cast<std::uint64_t>(samples)));
    this->OcclusionRays += this->Blocked.NumberOfOcclusionRays();
    pixel.Samples = this->Blocked.NumberOfSamples();
    pixel.Visible = !this->Blocked.SeesShadow() ? pixel.Samples : this->Blocked.SeesLight() ? -1 : 0;
    pixel.Shown = static_cast<float>(this->Blocked.MeanLeft() / this->Sums.Mean());
    pixel.Inside = static_cast<float>(this->Blocked.MeanInside());
  }
  for (std::size_t g = 0; g < this->Left.size(); ++g)
  {
    const double whole = this->Sums.Groups()[g];
    const double hidden = samples == 0 ? (inside ? (*inside)[g] : 0.0) : whole - this->Blocked.Left()[g];
    looked.LightOf(i, j)[g] = static_cast<float>(whole);
    looked.HiddenOf(i, j)[g] = whole > 0.0 ? static_cast<float>(hidden / whole) : 0.0f;
    pixel.Inside += samples == 0 ? static_cast<float>(this->Groups.MeanScatteredRadiance[g] * hidden) : 0.0f;
  }
}

/// Standard error of the unshadowed light of the ray at hand.
double LitMinusBlocked::LitError() const
{
  const double smallest = LitMinusBlockedScene::DarkestFraction * this->Shared.TypicalMean;
  const double tableError = this->Shared.Legs ? this->Shared.Legs->ErrorOfRays : 0.0;
  return (0.5 * this->Pixel.Tolerance + tableError) * std::max(this->Sums.Mean(), smallest);
}

/// What rays of a block share.
void LitMinusBlocked::BeginBlock(const TileRange& block)
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
}

void LitMinusBlocked::RenderBlock(const TileRange& block)
{
  this->BeginBlock(block);
  if (!this->Neighbours.empty())
  {
    this->Neighbours.front()->MoveTo(this->BlockI, this->BlockJ);
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
  const auto groups = static_cast<std::size_t>(this->Groups.Count());
  int samples = this->Looked ? std::max(this->Looked->At(i, j).Samples, 0) : 0;
  const SmoothShadow::Answer* answer = this->Neighbours.empty() ? nullptr : this->Neighbours.front()->Of(i, j);
  if (answer)
  {
    this->LeftOfPixel.assign(answer->Left, answer->Left + groups);
    this->WritePixel(i, j, answer->Variance, samples);
    return;
  }
  const std::uint64_t seed = HashSeed(this->Options.Seed, PixelIndex(this->Options, i, j));
  this->Hits.RaysOf(i, j, this->Rays);
  this->LeftOfPixel.assign(groups, 0.0);
  double variance = 0.0;
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
  if (any)
  {
    this->WritePixel(i, j, variance, samples);
  }
}

void LitMinusBlocked::WritePixel(int i, int j, double variance, int samples)
{
  const ExtinctionGroups& groups = this->Groups;
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
  estimator.Look(this->Sums, this->Intervals, { this->Shared.Darkest, this->LitError() }, seed);
  const bool dark =
    estimator.LooksDark() && estimator.NumberOfWantedSamples() > darkSamples && this->IsBlockDark();
  estimator.Estimate(dark ? darkSamples : this->Options.MaximumSamples);
  this->Left = estimator.Left();
  this->Variance = estimator.Variance();
  this->Samples = estimator.NumberOfSamples();
  this->OcclusionRays += estimator.NumberOfOcclusionRays();
  this->ShadowLines += estimator.NumberOfLines();
}

/// The unshadowed light along the ray of Pixel, up to a surface. @return false where the ray has none.
bool LitMinusBlocked::BeginRay(const PrimaryHit& hit, MediumInterval& interval)
{
  const Ray& ray = this->Pixel.Line;
  const LitInterval& lit = this->Pixel.Interval;
  interval = MediumIntervalOf(this->Scene.Medium.Bounds, this->Scene.Occluders, ray, hit);
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
  return true;
}

/// What is left of it. @return false where the ray has none.
bool LitMinusBlocked::EstimateRay(const PrimaryHit& hit, std::uint64_t seed)
{
  MediumInterval interval;
  if (!this->BeginRay(hit, interval))
  {
    return false;
  }
  const Ray& ray = this->Pixel.Line;
  const LitInterval& lit = this->Pixel.Interval;
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
