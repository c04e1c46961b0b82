// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitMinusBlockedScene.h
 * @brief What LitMinusBlocked shares among threads and parts of an image. Internal to Core.
 */
#ifndef scLitMinusBlockedScene_h
#define scLitMinusBlockedScene_h

#include "scLightLegs.h"
#include "scLitQuadrature.h"
#include "scParallel.h"
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

  /// @param monitor for what takes long; where it asks to stop the scene is not to be used.
  explicit LitMinusBlockedScene(const RenderContext& context, const Monitor& monitor = {});
  ~LitMinusBlockedScene();

  const RenderContext& Context;
  LitQuadrature Lit;
  /// Largest error of the unshadowed light over itself.
  double Tolerance = 0.0;
  std::unique_ptr<const LightLegs> Legs; ///< in a varying density, where a table serves
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
