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
/// Pixels darker than this share of the mean unshadowed light are sampled as if they had it.
constexpr double darkestShare = 0.1;

double LitTolerance(const ScatteringOptions& options)
{
  const double goal = options.Mode == ScatteringMode::Guided ? options.RelativeErrorGoal : 0.0;
  return goal > 0.0 ? std::min(litTolerance, litShare * goal) : litTolerance;
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
}

LitMinusBlockedScene::~LitMinusBlockedScene() = default;

LitMinusBlocked::LitMinusBlocked(const LitMinusBlockedScene& shared, const PrimaryHits& hits, ScatteringImage& image)
  : Shared(shared)
  , Hits(hits)
  , Image(image)
  , Tile(shared.Lit, shared.Scene.Eye, shared.Options.Width, shared.Options.Height,
      LitTolerance(shared.Options), shared.TypicalSums)
  , Sums(shared.Groups)
  , Blocked(shared.Scene, shared.Options, shared.Groups)
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
  const int corners[4][2] = { { i0, j0 }, { i1, j0 }, { i1, j1 }, { i0, j1 } };
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
  const ScatteringScene& scene = this->Shared.Scene;
  const ScatteringOptions& options = this->Shared.Options;
  this->Tile.Interpolate(i, j, this->Pixel);
  const Ray& ray = this->Pixel.Line;
  const MediumSegment segment = SegmentInside(scene.Fog.Bounds, scene.Occluders, ray, this->Hits.At(i, j));
  if (!segment.Crosses || this->Pixel.Span.Empty())
  {
    return; // beside the medium, or behind the light
  }
  this->Sums.Add(this->Pixel, segment.EndOfMarch);
  this->Left = this->Sums.Groups();
  this->Hidden.assign(this->Left.size(), 0.0);
  const std::size_t index = IndexInExtent(options, i, j);
  double variance = 0.0;
  if (options.Mode == ScatteringMode::Guided)
  {
    if (this->Beam)
    {
      this->Beam->Intersect(ray, segment.Begin, segment.EndOfMarch, this->Stretches);
    }
    else
    {
      this->Stretches.assign(1, { segment.Begin, segment.EndOfMarch, -1 });
    }
    if (!this->Stretches.empty())
    {
      this->Sums.Accumulate();
    }
    const double darkest = darkestShare * this->Shared.TypicalMean;
    const double litError = 0.5 * this->Pixel.Tolerance * std::max(this->Sums.Mean(), darkest);
    this->Blocked.Estimate(
      this->Sums, litError, this->Stretches, darkest, HashSeed(options.Seed, PixelIndex(options, i, j)));
    this->Hidden = this->Blocked.Blocked();
    variance = this->Blocked.Variance() + litError * litError;
    this->Image.SampleCount[index] = this->Blocked.NumberOfSamples();
    this->OcclusionRays += this->Blocked.NumberOfOcclusionRays();
  }
  else if (this->Shared.Field)
  {
    // Cells of a ray that passes other faces of the medium lie elsewhere.
    const bool alike = this->Pixel.Span.Faces == this->Corners[0].Span.Faces;
    this->Image.SampleCount[index] =
      this->Shared.Field->Walk(this->Sums, alike ? this->CellsInShadow : ~std::uint64_t(0), this->Hidden);
  }

  for (std::size_t g = 0; g < this->Left.size(); ++g)
  {
    // Where all is in shadow an estimate may take a little more than there is.
    this->Left[g] = std::max(this->Left[g] - this->Hidden[g], 0.0);
  }
  const ExtinctionGroups& groups = this->Shared.Groups;
  const double mean =
    groups.ToRadiance(this->Left, this->Image.InScattering.data() + index * groups.Source.size());
  // An estimate of nothing may stand for something: it is wrong by all of it.
  const double relative = mean > 0.0 ? std::sqrt(variance) / mean : (variance > 0.0 ? 1.0 : 0.0);
  this->Image.RelativeError[index] = options.Mode == ScatteringMode::Guided ? static_cast<float>(relative) : -1.0f;
}

} // namespace shadowcones
