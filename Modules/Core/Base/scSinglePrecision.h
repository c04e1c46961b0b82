// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSinglePrecision.h
 * @brief Which numbers single precision holds.
 *
 * Casts there and back do not tell: GCC 12 leaves their rounding out where it takes two values at a time.
 */
#ifndef scSinglePrecision_h
#define scSinglePrecision_h

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace shadowcones
{

/// Is a number the same in single precision? Infinities are, NaN is not.
inline bool IsSinglePrecision(double value)
{
  using Single = std::numeric_limits<float>;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  const double size = std::fabs(value);
  if (size < static_cast<double>(Single::min()))
  {
    // Below, all numbers are multiples of the smallest one; the factor is exact.
    const double multiple = size / static_cast<double>(Single::denorm_min());
    return std::floor(multiple) == multiple;
  }
  constexpr std::uint64_t further = (std::uint64_t(1) << 29) - 1; // digits: 52 against 23
  return (bits & further) == 0 && (size <= static_cast<double>(Single::max()) || std::isinf(size));
}

/// The nearest value in single precision.
inline double RoundToSingle(double value)
{
  // Volatile: or the rounding may be left out.
  const volatile float single = static_cast<float>(value);
  return single;
}

} // namespace shadowcones

#endif
