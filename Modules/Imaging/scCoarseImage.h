// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCoarseImage.h
 * @brief Pictures that are soon there, before the image itself. Internal to Imaging.
 */
#ifndef scCoarseImage_h
#define scCoarseImage_h

#include "scParallel.h"
#include "scScatteringImage.h"

#include <vector>

namespace shadowcones
{

struct ImageScene;

/// Pixels along a side for one of a coarse picture, coarsest first, each a quarter of the one before; none for small images.
std::vector<int> CoarseScales(int width, int height);

/**
 * The whole image from one pixel for scale x scale, to a loose error goal, enlarged to all of its pixels: radiances linearly,
 * the rest by the nearest. @return false where aborted.
 */
bool RenderCoarse(ImageScene& scene, int scale, const Monitor& monitor, ScatteringImage& image);

} // namespace shadowcones

#endif
