// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LampPoints.h
 * @brief A light as a fixed set of points: what shadow buffers and projected solids are made for, one each.
 */
#ifndef LampPoints_h
#define LampPoints_h

#include "scLight.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace shadowcones
{

/// Is the light one point, or one direction?
inline bool IsOnePoint(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Sun && !(light.Radius > 0.0));
}

/// A single point is the middle of the light; more are spread evenly (Sobol) by area, of a Sun by solid angle.
class LampPoints
{
public:
  LampPoints(const Light& light, int count)
    : Parallel(light.Shape == LightShape::Sun)
    , Flat(light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle)
    , Normal(light.Normal)
  {
    if (!this->Parallel && !this->Flat && light.Shape != LightShape::Point)
    {
      throw std::runtime_error("The rivals know discs, rectangles, points and Suns.");
    }
    count = IsOnePoint(light) ? 1 : count;
    for (int k = 0; k < count; ++k)
    {
      const std::array<double, 4> u = count == 1 ? std::array<double, 4>{ 0.5, 0.5 } : SobolPoint(1, k);
      this->Positions.push_back(SampleLightArea(light, u[0], u[1]).Position);
    }
  }

  bool Parallel; ///< positions are unit vectors towards the light
  std::vector<Vector3> Positions;

  int Count() const { return static_cast<int>(this->Positions.size()); }
  /// From @p x to point @p k; of a parallel light a unit vector.
  Vector3 Towards(int k, const Vector3& x) const
  {
    return this->Parallel ? this->Positions[static_cast<std::size_t>(k)]
                          : this->Positions[static_cast<std::size_t>(k)] - x;
  }
  /// What the point counts for among the others, by the light that it sends along @p to, which is from Towards().
  double Weight(const Vector3& to) const
  {
    if (this->Parallel)
    {
      return 1.0;
    }
    const double squared = Dot(to, to);
    return this->Flat ? std::max(0.0, -Dot(to, this->Normal)) / (squared * std::sqrt(squared)) : 1.0 / squared;
  }

private:
  bool Flat;
  Vector3 Normal;
};

} // namespace shadowcones

#endif
