// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StageMemory.h
 * @brief The largest memory of each stage against the formula that 7-performance.md gives for it.
 */
#ifndef StageMemory_h
#define StageMemory_h

namespace shadowcones
{

/// One line a stage. @param triangles of the mesh whose search tree is built.
void MeasureMemory(double triangles);

} // namespace shadowcones

#endif
