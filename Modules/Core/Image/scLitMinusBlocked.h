// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitMinusBlocked.h
 * @brief The medium term as unshadowed light minus what occluders take of it, tile by tile. Internal to Core.
 */
#ifndef scLitMinusBlocked_h
#define scLitMinusBlocked_h

#include "scBlockedLight.h"
#include "scConeBeam.h"
#include "scLitTile.h"
#include "scPrimaryHits.h"
#include "scTileRange.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

class VisibilityField;

/// What all threads share.
struct LitMinusBlockedScene
{
  LitMinusBlockedScene(
    const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups);
  ~LitMinusBlockedScene();

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  LitQuadrature Lit;
  std::vector<double> TypicalSums; ///< of every group
  double TypicalMean = 0.0;        ///< over wavelengths
  std::unique_ptr<VisibilityField> Field; ///< Soft, Volume
};

/// Guided, Soft and Volume; one a thread.
class LitMinusBlocked
{
public:
  LitMinusBlocked(const LitMinusBlockedScene& shared, const PrimaryHits& hits, ScatteringImage& image);

  /// Pixels of a tile that lies in one of LitTile's squares.
  void RenderTile(const TileRange& tile);
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  void RenderBlock(const TileRange& block);
  void RenderPixel(int i, int j);

  const LitMinusBlockedScene& Shared;
  const PrimaryHits& Hits;
  ScatteringImage& Image;
  LitTile Tile;
  LitPixel Pixel;
  LitSums Sums;
  BlockedLight Blocked;
  std::unique_ptr<ConeBeam> Beam;
  std::vector<RayInterval> Stretches;
  std::array<LitPixel, 4> Corners; ///< of the block
  std::uint64_t CellsInShadow = 0; ///< of the block
  std::vector<double> Hidden; ///< per group, of the light
  std::vector<double> Left;   ///< per group, without what is hidden
  vtkIdType OcclusionRays = 0;
};

} // namespace shadowcones

#endif
