// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scUpdate.h
 * @brief Bring a filter up to date: progress, Ctrl-C, and its messages as sentences.
 */
#ifndef scUpdate_h
#define scUpdate_h

#include <string>

class vtkAlgorithm;

namespace shadowcones
{
/**
 * Update a filter and all that feed it. Warnings go to standard error, a line each. Throws a Failure with the first error, or where the
 * user pressed Ctrl-C.
 * @param step  what is being done, for the bar
 * @param quiet no bar, no warnings
 */
void Update(vtkAlgorithm* filter, const std::string& step, bool quiet);
} // namespace shadowcones

#endif
