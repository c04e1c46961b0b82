// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumTerm.h"

#include <cmath>

namespace shadowcones
{

MediumTerm::MediumTerm(const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups,
  const LightStrata& strata, const LitMinusBlockedScene* lit, const PrimaryHits& hits, ScatteringImage& image)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , Strata(strata)
  , Hits(hits)
  , Image(image)
  , March{ scene.Occluders, scene.Source, scene.Fog, scene.Cones, options, groups, strata }
  , Marcher(March)
  , Difference(lit ? std::make_unique<LitMinusBlocked>(*lit, hits, image) : nullptr)
{
}

int MediumTerm::TileSide(ScatteringMode mode)
{
  switch (mode)
  {
    case ScatteringMode::BruteForce:
    case ScatteringMode::Medium:
    case ScatteringMode::Fast:
      return 4;
    default:
      return LitTile::Side;
  }
}

void MediumTerm::RenderTile(const TileRange& tile)
{
  switch (this->Options.Mode)
  {
    case ScatteringMode::BruteForce:
    case ScatteringMode::Medium:
    case ScatteringMode::Fast:
      this->MarchTile(tile);
      break;
    case ScatteringMode::Guided:
    case ScatteringMode::Soft:
    case ScatteringMode::Volume:
      this->Difference->RenderTile(tile);
      break;
  }
}

void MediumTerm::MarchTile(const TileRange& tile)
{
  for (int j = tile.J0; j <= tile.J1; ++j)
  {
    for (int i = tile.I0; i <= tile.I1; ++i)
    {
      const Ray ray = this->Hits.RayOf(i, j);
      const MediumSegment segment =
        SegmentInside(this->Scene.Fog.Bounds, this->Scene.Occluders, ray, this->Hits.At(i, j));
      if (segment.Crosses)
      {
        this->Marcher.March(ray, segment.Begin, segment.EndOfMarch, PixelIndex(this->Options, i, j));
        this->WriteMarch(IndexInExtent(this->Options, i, j));
      }
    }
  }
}

void MediumTerm::WriteMarch(std::size_t index)
{
  this->OcclusionRays += this->Marcher.NumberOfOcclusionRays();
  this->Image.SampleCount[index] = this->Marcher.SampleCount();
  float* radiance = this->Image.InScattering.data() + index * this->Groups.Source.size();
  const double mean = this->Groups.ToRadiance(this->Marcher.Integrals(), radiance);
  const double deviation = std::sqrt(this->Marcher.Variance());
  this->Image.RelativeError[index] =
    this->Strata.Count() < 2 ? -1.0f : (mean > 0.0 ? static_cast<float>(deviation / mean) : 0.0f);
}

} // namespace shadowcones
