// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitMinusBlocked.h
 * @brief The medium term as unshadowed light minus what occluders take of it, tile by tile. Internal to Core.
 */
#ifndef scLitMinusBlocked_h
#define scLitMinusBlocked_h

#include "scBlockedLight.h"
#include "scConeBeam.h"
#include "scLinesOfLight.h"
#include "scLitMinusBlockedScene.h"
#include "scLitPixel.h"
#include "scLitSums.h"
#include "scLitTile.h"
#include "scLookedPixels.h"
#include "scMediumInterval.h"
#include "scMediumOpticalDepth.h"
#include "scPixelRay.h"
#include "scPrimaryHit.h"
#include "scPrimaryHits.h"
#include "scRayInterval.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scSmoothShadow.h"
#include "scTileRange.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

/// Guided, Soft and Volume; one a thread.
class LitMinusBlocked
{
public:
  /// Cones and grid cells are looked for once for so many pixels by so many.
  static constexpr int BlockSide = 8;

  LitMinusBlocked(const LitMinusBlockedScene& shared, const PrimaryHits& hits, ScatteringImage& image);

  /// Do pixels ask their neighbours where a scene takes no lines?
  static bool MayLookAround(const ScatteringOptions& options);
  /// Does this scene ask pixels' neighbours?
  static bool LooksAround(const LitMinusBlockedScene& shared);
  /// Pixels ask their neighbours, which are looked at before; these must outlive this.
  void AskNeighbours(const LookedPixels& looked);
  /**
   * Look at pixels of a tile, each with few samples: at those of a level where what was seen at coarser ones does not tell.
   * The tile lies in one of LitTile's squares and holds whole blocks of all levels, as far as these were asked for.
   */
  void LookAtTile(const TileRange& tile, int level, LookedPixels& looked);
  /// Pixels of a tile that lies in one of LitTile's squares.
  void RenderTile(const TileRange& tile);
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }
  vtkIdType NumberOfShadowLines() const { return this->ShadowLines; }

private:
  void BeginBlock(const TileRange& block);
  void RenderBlock(const TileRange& block);
  void RenderPixel(int i, int j);
  void WritePixel(int i, int j, double variance, int samples);
  void PrepareTile(const TileRange& tile, LookedPixels& looked);
  bool IsKnown(const TileRange& block, int level);
  void LookAtBlock(const TileRange& block, int level, int samples, LookedPixels& looked);
  void LookAtPixel(int i, int j, int samples, LookedPixels& looked);
  int SamplesOfBlock(const TileRange& block, int level, const LookedPixels& looked) const;
  double LitError() const;
  bool BeginRay(const PrimaryHit& hit, MediumInterval& interval);
  bool EstimateRay(const PrimaryHit& hit, std::uint64_t seed);
  void FindIntervals(const Ray& ray, const MediumInterval& interval);
  bool IsBlockDark();
  template <class Estimator>
  void EstimateBy(Estimator& estimator, std::uint64_t seed);
  template <class Estimator>
  bool SeesLight(Estimator& estimator, int count, std::uint64_t seed);

  const LitMinusBlockedScene& Shared;
  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const PrimaryHits& Hits;
  ScatteringImage& Image;
  LitTile Tile;
  LitPixel Pixel; ///< of the ray at hand
  LitSums Sums;
  MediumOpticalDepth OpticalDepth;
  BlockedLight Blocked;
  std::unique_ptr<LinesOfLight> Lines; ///< nullptr: not of this light
  LitPixel OtherPixel; ///< of another ray of the block
  LitSums OtherSums;
  BlockedLight OtherBlocked;
  std::unique_ptr<LinesOfLight> OtherLines;
  std::vector<std::unique_ptr<SmoothShadow>> Neighbours; ///< of levels, the finest first; none: nobody is asked
  const LookedPixels* Looked = nullptr;
  std::unique_ptr<ConeBeam> Beam;
  std::vector<RayInterval> Intervals; ///< of the ray at hand where occluders may block
  std::array<LitPixel, 4> Corners; ///< of the block
  std::uint64_t CellsInShadow = 0; ///< of the block
  std::vector<PixelRay> Rays;      ///< of the pixel
  std::vector<double> LeftOfPixel; ///< per group
  int BlockI = 0;                  ///< first pixel of the block
  int BlockJ = 0;
  int Darkness = -1; ///< of the block: 1 where no ray of it sees any light inside cones; -1: nobody asked yet
  std::vector<double> Hidden; ///< of the ray at hand, per group: from a grid
  std::vector<double> Left; ///< of the ray at hand, per group: what is not hidden
  double Variance = 0.0;    ///< of its mean over wavelengths
  int Samples = 0;
  vtkIdType OcclusionRays = 0;
  vtkIdType ShadowLines = 0;
};

} // namespace shadowcones

#endif
