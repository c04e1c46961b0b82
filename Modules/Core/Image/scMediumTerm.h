// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumTerm.h
 * @brief The medium term of a scattering image, tile by tile. Internal to Core.
 */
#ifndef scMediumTerm_h
#define scMediumTerm_h

#include "scLitMinusBlocked.h"
#include "scLitMinusBlockedScene.h"
#include "scPixelRay.h"
#include "scPrimaryHits.h"
#include "scRayMarcher.h"
#include "scRenderContext.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scTileRange.h"

#include <memory>
#include <vector>

namespace shadowcones
{

/// Writes "InScattering", "RelativeError" and "SampleCount" of an image; one a thread.
class MediumTerm
{
public:
  /// What the terms of an image share; nullptr for what it has not.
  struct Shared
  {
    const LitMinusBlockedScene* Lit = nullptr; ///< Guided, Soft and Volume
    const LightLegs* Legs = nullptr;           ///< the others, in a varying density
  };
  /// Everything is referred to and must outlive the term; the image's arrays have their size.
  MediumTerm(const RenderContext& context, const Shared& shared, const PrimaryHits& hits, ScatteringImage& image);

  /// Blocks of this side are rendered at once, and those of a square of the other side share what is costly to find: large
  /// ones only where there is such a thing, so that an abort is served soon.
  static int BlockSide(ScatteringMode mode);
  static int SquareSide(ScatteringMode mode);

  /// @p tile lies inside the extent and one square, aligned to pixel (0, 0) of the whole image.
  void RenderTile(const TileRange& tile);

  /// @name Neighbours: see LitMinusBlocked
  ///@{
  void LookAtTile(const TileRange& tile, int level, LookedPixels& looked)
  {
    this->Difference->LookAtTile(tile, level, looked);
  }
  void AskNeighbours(const LookedPixels& looked) { this->Difference->AskNeighbours(looked); }
  ///@}

  vtkIdType NumberOfOcclusionRays() const
  {
    return this->OcclusionRays + (this->Difference ? this->Difference->NumberOfOcclusionRays() : 0);
  }
  vtkIdType NumberOfShadowLines() const { return this->Difference ? this->Difference->NumberOfShadowLines() : 0; }
  /// Of marched rays: see ScatteringImage.
  vtkIdType NumberOfThickRays() const { return this->ThickRays; }
  double MarchOpticalDepth() const { return this->ThickestStep; }

private:
  void MarchTile(const TileRange& tile);
  void MarchPixel(int i, int j);

  const RenderContext& Context;
  const PrimaryHits& Hits;
  ScatteringImage& Image;
  RayMarcher Marcher;
  std::unique_ptr<LitMinusBlocked> Difference; ///< Guided, Soft, Volume
  std::vector<PixelRay> Rays;    ///< of the pixel
  std::vector<double> Integrals; ///< of the pixel, per group
  vtkIdType OcclusionRays = 0;
  vtkIdType ThickRays = 0;
  double ThickestStep = 0.0;
};

} // namespace shadowcones

#endif
