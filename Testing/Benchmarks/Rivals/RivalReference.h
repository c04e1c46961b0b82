// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RivalReference.h
 * @brief What the marcher's image would be with no error of any rival: hidden light by the plain rays of Testing/Reference.
 */
#ifndef RivalReference_h
#define RivalReference_h

#include "RivalMarch.h"

namespace shadowcones
{

class ReferenceScene;

struct HiddenLight
{
  double Mean = 0.0;
  double StandardError = 0.0;
};

/**
 * Light of a pixel that the occluders hide, mean over wavelengths: @p samples random places in even strata, each with one random
 * point of the light and one ray. Neither the places nor the rays, nor their tree, are those of a rival. Sixteen independent parts
 * give the error.
 */
HiddenLight ReferenceHiddenLight(const RivalMarch& march, const ReferenceScene& occluders, std::size_t pixel, int samples);

} // namespace shadowcones

#endif
