// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringScene.h
 * @brief What a scattering image shows.
 */
#ifndef scScatteringScene_h
#define scScatteringScene_h

#include "scCamera.h"
#include "scConeHierarchy.h"
#include "scLight.h"
#include "scMedium.h"
#include "scOccluderScene.h"

namespace shadowcones
{

struct VisibilityGrid;

/// What is rendered in the light of one light; nothing is owned. The light spectrum, SigmaS and SigmaA have one length.
struct ScatteringScene
{
  const OccluderScene& Occluders;
  const shadowcones::Light& Light;
  const shadowcones::Medium& Medium;
  const shadowcones::Camera& Camera;
  /// Medium, Fast and Guided; Volume: for its surfaces. Bounds must hold the medium's. To Guided and Volume nullptr
  /// means that shadow may be anywhere.
  const ConeHierarchy* Cones = nullptr;
  const VisibilityGrid* Visibility = nullptr; ///< Soft, Volume
};

} // namespace shadowcones

#endif
