// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitMinusBlockedScene.h
 * @brief What LitMinusBlocked shares among threads and parts of an image. Internal to Core.
 */
#ifndef scLitMinusBlockedScene_h
#define scLitMinusBlockedScene_h

#include "scLitQuadrature.h"
#include "scRenderContext.h"

#include <memory>
#include <vector>

namespace shadowcones
{

class LineShadows;
class VisibilityGridSampler;

/// What all threads share, whatever part of the image is rendered.
struct LitMinusBlockedScene
{
  /// Pixels darker than this fraction of the image's mean are sampled as if they had it: of the mean unshadowed light what
  /// that is read from, of what the image shows what is sampled.
  static constexpr double DarkestFraction = 0.1;

  explicit LitMinusBlockedScene(const RenderContext& context);
  ~LitMinusBlockedScene();

  const RenderContext& Context;
  LitQuadrature Lit;
  std::vector<double> TypicalSums; ///< of every group
  double TypicalMean = 0.0;        ///< over wavelengths
  double Darkest = 0.0;            ///< pixels that are darker are sampled as if they had this, mean over wavelengths
  const VisibilityGridSampler* Grid = nullptr; ///< Soft, Volume
  const LineShadows* Lines = nullptr;          ///< Guided, where whole lines are worth it

private:
  std::unique_ptr<const VisibilityGridSampler> OwnGrid;
};

} // namespace shadowcones

#endif
