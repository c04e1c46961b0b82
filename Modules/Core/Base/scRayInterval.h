// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRayInterval.h
 * @brief A part of a ray: the one type for what lies between two distances along it.
 */
#ifndef scRayInterval_h
#define scRayInterval_h

namespace shadowcones
{

/// Distances along a ray. What knows more of a part of a ray derives from this, and is named for what more it knows.
struct RayInterval
{
  double Begin = 0.0;
  double End = 0.0; ///< not above Begin: there is no such part

  bool Empty() const { return !(this->End > this->Begin); }
};

} // namespace shadowcones

#endif
