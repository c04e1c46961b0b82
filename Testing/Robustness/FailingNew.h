// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FailingNew.h
 * @brief operator new of the whole program, which gives no memory to one call from the libraries of the project.
 */
#ifndef FailingNew_h
#define FailingNew_h

namespace robustness
{

/// Count calls from here on; the @p failing-th of them, from 1, throws std::bad_alloc. 0: none does.
void CountAllocations(long failing);
/// Calls from the project's own libraries since then; counting ends.
long NumberOfAllocations();

} // namespace robustness

#endif
