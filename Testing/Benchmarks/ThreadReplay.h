// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreadReplay.h
 * @brief What threads are worth to each stage: two measured, more replayed from the times of single items.
 */
#ifndef ThreadReplay_h
#define ThreadReplay_h

#include <string>
#include <vector>

namespace shadowcones
{

/// Print a line a stage: seconds on one and two threads, and what 16 and 64 would do. Stages are those of threadStages.
void MeasureThreads(const std::string& scene, int size, const std::vector<std::string>& stages);

const std::vector<std::string> threadStages{ "Guided", "Volume", "BruteForce", "fill", "vectors", "cones", "tuning" };

} // namespace shadowcones

#endif
