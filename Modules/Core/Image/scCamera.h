// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCamera.h
 * @brief Rays through the centres of an image's pixels, as vtkCamera sees them.
 */
#ifndef scCamera_h
#define scCamera_h

#include "ShadowConesCoreModule.h"
#include "scRay.h"
#include "scVector3.h"

namespace shadowcones
{

struct Camera
{
  Vector3 Position;
  Vector3 Forward{ 0.0, 0.0, -1.0 }; ///< unit
  Vector3 Right{ 1.0, 0.0, 0.0 };    ///< unit
  Vector3 Up{ 0.0, 1.0, 0.0 };       ///< unit, orthogonal to Forward
  bool Parallel = false;
  double HalfHeight = 0.2679; ///< tan(view angle / 2), vertical; Parallel: half the height of the view, world units

  /// The ray through the point (i + 0.5, j + 0.5) of a width x height image, j upwards; the aspect ratio is width / height.
  SHADOWCONESCORE_EXPORT Ray PixelRay(double i, double j, int width, int height) const;
};

} // namespace shadowcones

#endif
