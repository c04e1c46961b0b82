// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeRequests.h
 * @brief Requests that need more memory than there is: a message and empty outputs, and the next request is answered.
 */
#ifndef LargeRequests_h
#define LargeRequests_h

namespace robustness
{

/// Try photons, cones, a volume, an image and a probe, each in a process of its own, and print a line each. @return how many were lost.
int TryLargeRequests();

} // namespace robustness

#endif
