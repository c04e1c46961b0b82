// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRayCheck.h
 * @brief Whether an image that asks no rays shows about what rays would. Internal to Imaging.
 */
#ifndef scRayCheck_h
#define scRayCheck_h

#include "scParallel.h"
#include "scScatteringImage.h"

namespace shadowcones
{

struct ImageScene;

/// Light from the medium at some pixels of an image, beside what rays find there.
struct RayCheck
{
  const char* Mode = ""; ///< of the image
  int Pixels = 0;        ///< that were compared; 0: none
  double Light = 1.0;    ///< of the image over that of rays, all these pixels together
  double Error = 0.0;    ///< of a pixel: root of the mean square over the mean of rays
};

/**
 * Compare a whole image of Fast or Soft, which take cones for shadow, with Guided without cones to a loose error goal. Nothing
 * is compared in other modes and without a mesh. @return false where aborted.
 */
bool CheckByRays(ImageScene& scene, const ScatteringImage& image, const Monitor& monitor, RayCheck& check);

} // namespace shadowcones

#endif
