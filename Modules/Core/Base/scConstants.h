// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConstants.h
 * @brief Numbers of mathematics. Internal to Core.
 */
#ifndef scConstants_h
#define scConstants_h

namespace shadowcones
{

constexpr double Pi = 3.14159265358979323846;
constexpr double TwoPi = 6.28318530717958647692;
constexpr double FourPi = 12.566370614359172953850573533118;

} // namespace shadowcones

#endif
