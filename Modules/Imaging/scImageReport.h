// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageReport.h
 * @brief What a rendered image says of itself: numbers for the filter's warnings. Internal to Imaging.
 */
#ifndef scImageReport_h
#define scImageReport_h

#include "scImageScene.h"

namespace shadowcones
{

/**
 * What is to be said of an image of the scene: pixels that miss the goal, grids too coarse, steps too thick, and where it is
 * the @p whole image that there is nothing in it.
 */
void ReportImage(const ImageScene& scene, const ScatteringImage& image, bool whole, Warnings& warnings);

} // namespace shadowcones

#endif
