// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scWideLoops.h
 * @brief Mark a function whose loops are to run with wider vectors where the processor has them. Internal to Core.
 *
 * Products are never contracted into fused ones, so that the bits are the same everywhere. Not for files that include
 * PCL or Eigen, whose allocators depend on the instruction set.
 */
#ifndef scWideLoops_h
#define scWideLoops_h

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&                       \
  !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SHADOWCONES_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define SHADOWCONES_WIDE
#endif

/// Before a loop whose arrays do not overlap, where there are so many that a compiler would not look.
#if defined(__GNUC__) && !defined(__clang__)
#define SHADOWCONES_APART _Pragma("GCC ivdep")
#else
#define SHADOWCONES_APART
#endif

#endif
