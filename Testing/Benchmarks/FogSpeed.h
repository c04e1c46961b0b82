// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FogSpeed.h
 * @brief What a density image costs an image of scattered light.
 */
#ifndef FogSpeed_h
#define FogSpeed_h

namespace shadowcones
{

/**
 * Print a line for each fog: processor seconds with it over those without, Guided and BruteForce, of a chair and of slats in
 * the room. Frames with and without fog take turns, and the shortest counts.
 */
void MeasureFog(int size, int repeats);

} // namespace shadowcones

#endif
