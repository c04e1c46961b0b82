// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FirstImage.h
 * @brief What a first image of a body costs from its mesh on, with cones and without.
 */
#ifndef FirstImage_h
#define FirstImage_h

#include <string>

namespace shadowcones
{

/// A mesh's first image and further ones at a goal of .01, size x size pixels: processor seconds, errors, and when cones have paid.
void MeasureFirstImages(const std::string& nameOrFile, int size, int repeats);

} // namespace shadowcones

#endif
