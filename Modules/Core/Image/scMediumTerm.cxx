// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumTerm.h"

#include "scMediumInterval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{
namespace
{
/// Marched rays are called thick where their steps may make them too bright by more than this share.
constexpr double largestExcess = 0.005;
} // anonymous namespace

MediumTerm::MediumTerm(
  const RenderContext& context, const Shared& shared, const PrimaryHits& hits, ScatteringImage& image)
  : Context(context)
  , Hits(hits)
  , Image(image)
  , Marcher(context, shared.Legs)
  , Difference(shared.Lit ? std::make_unique<LitMinusBlocked>(*shared.Lit, hits, image) : nullptr)
{
}

int MediumTerm::BlockSide(ScatteringMode mode)
{
  return IsMarched(mode) ? 4 : LitMinusBlocked::BlockSide;
}

int MediumTerm::SquareSide(ScatteringMode mode)
{
  return IsMarched(mode) ? 4 : LitTile::Side;
}

void MediumTerm::RenderTile(const TileRange& tile)
{
  if (IsMarched(this->Context.Options.Mode))
  {
    this->MarchTile(tile);
    return;
  }
  this->Difference->RenderTile(tile);
}

void MediumTerm::MarchTile(const TileRange& tile)
{
  for (int j = tile.J0; j <= tile.J1; ++j)
  {
    for (int i = tile.I0; i <= tile.I1; ++i)
    {
      this->MarchPixel(i, j);
    }
  }
}

void MediumTerm::MarchPixel(int i, int j)
{
  const ScatteringScene& scene = this->Context.Scene;
  const ExtinctionGroups& groups = this->Context.Groups;
  const std::uint64_t pixel = PixelIndex(this->Context.Options, i, j);
  this->Hits.RaysOf(i, j, this->Rays);
  this->Integrals.assign(static_cast<std::size_t>(groups.Count()), 0.0);
  double variance = 0.0;
  vtkIdType samples = 0;
  bool any = false;
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const PixelRay& part = this->Rays[k];
    const MediumInterval interval = MediumIntervalOf(scene.Medium.Bounds, scene.Occluders, part.Line, part.Hit);
    if (!interval.Crosses)
    {
      continue;
    }
    any = true;
    // Numbers of pixels are below 2^31: those of an edge's rays are no pixel's.
    const std::uint64_t key = this->Rays.size() > 1 ? pixel + ((k + 1) << 32) : pixel;
    this->Marcher.March(part.Line, interval.Begin, interval.EndOfMarch, key);
    this->OcclusionRays += this->Marcher.NumberOfOcclusionRays();
    if (this->Marcher.Excess() > largestExcess)
    {
      this->ThickRays += 1;
      this->ThickestStep = std::max(this->ThickestStep, this->Marcher.OpticalDepthOfStep());
    }
    samples += this->Marcher.SampleCount();
    variance += part.Fraction * part.Fraction * this->Marcher.Variance();
    for (std::size_t g = 0; g < this->Integrals.size(); ++g)
    {
      this->Integrals[g] += part.Fraction * this->Marcher.Integrals()[g];
    }
  }
  if (!any)
  {
    return;
  }
  const std::size_t index = this->Image.IndexOf(i, j);
  constexpr vtkIdType most = std::numeric_limits<int>::max();
  this->Image.SampleCount[index] = static_cast<int>(std::min(samples, most));
  float* radiance = this->Image.InScattering.data() + index * groups.ScatteredRadiance.size();
  const double mean = groups.ToRadiance(this->Integrals, radiance);
  const double relative = mean > 0.0 ? std::sqrt(variance) / mean : 0.0;
  const bool known = this->Context.Strata.Count() >= 2;
  this->Image.RelativeError[index] = known ? static_cast<float>(relative) : -1.0f;
  this->Image.MediumError[index] = known ? static_cast<float>(std::sqrt(variance)) : -1.0f;
}

} // namespace shadowcones
