// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringScene.h
 * @brief What a scattering image shows.
 */
#ifndef scScatteringScene_h
#define scScatteringScene_h

#include "ShadowConesCoreModule.h"
#include "scCamera.h"
#include "scConeHierarchy.h"
#include "scLight.h"
#include "scMedium.h"
#include "scOccluderScene.h"

#include <cstdint>
#include <memory>

namespace shadowcones
{

class VisibilityGridSampler;
struct PhotonEstimates;
struct VisibilityGrid;

/// A grid laid out for the camera's rays, by several threads: for what is rendered more than once. The grid must outlive it.
SHADOWCONESCORE_EXPORT std::shared_ptr<const VisibilityGridSampler> LayOutGrid(const VisibilityGrid& grid);
/// Bytes of such a layout, without the grid.
SHADOWCONESCORE_EXPORT std::int64_t MemoryOf(const VisibilityGridSampler& layout);

/// What is rendered in the light of one light; nothing is owned. The light spectrum, SigmaS and SigmaA have one length.
struct ScatteringScene
{
  const OccluderScene& Occluders; ///< what is seen, and reflects
  const shadowcones::Light& Light;
  const shadowcones::Medium& Medium;
  const shadowcones::Camera& Camera;
  /// Medium, Fast and Guided; Volume: for its surfaces. Bounds must hold the medium's. To Guided and Volume nullptr
  /// means that shadow may be anywhere.
  const ConeHierarchy* Cones = nullptr;
  const VisibilityGrid* Visibility = nullptr; ///< Soft, Volume
  const VisibilityGridSampler* Layout = nullptr; ///< of that grid; nullptr: it is laid out for this image
  /// Of all lights together: those of the first scene count. nullptr: single scattering and direct light alone.
  const PhotonEstimates* Photons = nullptr;
  const OccluderScene* Casters = nullptr; ///< the occluders without receivers, where there are any; else nullptr

  /// What hides the light from the medium and from surfaces.
  const OccluderScene& ShadowCasters() const { return this->Casters ? *this->Casters : this->Occluders; }
};

} // namespace shadowcones

#endif
