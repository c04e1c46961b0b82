// SPDX-License-Identifier: BSD-3-Clause
// The single-precision loops of the unshadowed term against double precision.
#include "scLitKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;

namespace
{
/// Light points that face the origin, one unit of area each.
struct Points
{
  std::vector<float> Values[7];

  void Add(double x, double y, double z)
  {
    const double length = std::max(std::sqrt(x * x + y * y + z * z), 1e-300);
    const double values[7] = { x, y, z, -x / length, -y / length, -z / length, 1.0 };
    for (int k = 0; k < 7; ++k)
    {
      this->Values[k].push_back(static_cast<float>(values[k]));
    }
  }
  LightPoints View() const
  {
    const auto& v = this->Values;
    return { v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), v[5].data(), v[6].data(),
      static_cast<int>(v[0].size()) };
  }
};

/// Length inside the box [-1, 2] x [-3, 1] x [-2, 4] of the way from the origin to a point.
double LegTo(const double to[3])
{
  const double low[3] = { -1.0, -3.0, -2.0 };
  const double high[3] = { 2.0, 1.0, 4.0 };
  double share = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    share = to[axis] > 0.0 ? std::min(share, high[axis] / to[axis]) : share;
    share = to[axis] < 0.0 ? std::min(share, low[axis] / to[axis]) : share;
  }
  return share * std::sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
}
} // namespace

TEST(LitKernel, LegsAreThoseOfTheBoxAlsoAlongItsAxes)
{
  // All 27 signs of the components, 0 among them, inside of the box and far outside.
  Points points;
  std::vector<double> legs;
  for (const double size : { 0.5, 30.0 })
  {
    for (int k = 0; k < 27; ++k)
    {
      const double to[3] = { size * (k % 3 - 1), 0.8 * size * (k / 3 % 3 - 1), 1.3 * size * (k / 9 - 1) };
      if (k != 13)
      {
        points.Add(to[0], to[1], to[2]);
        legs.push_back(LegTo(to));
      }
    }
  }
  const LightPointsView view{ { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { -1.0f, -3.0f, -2.0f }, { 2.0f, 1.0f, 4.0f } };
  std::vector<float> weight(legs.size());
  std::vector<float> cosine(legs.size());
  std::vector<float> leg(legs.size());
  LookAtLight(points.View(), view, weight.data(), cosine.data(), leg.data());
  for (std::size_t k = 0; k < legs.size(); ++k)
  {
    EXPECT_NEAR(leg[k], legs[k], 1e-5 * legs[k]) << "point " << k;
    EXPECT_GT(weight[k], 0.0f);
  }
}

TEST(LitKernel, ALightPointAtTheVeryPlaceSendsNothing)
{
  Points points;
  points.Add(0.0, 0.0, 0.0);
  points.Add(0.0, 0.5, 0.0);
  const LightPointsView view{ { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { -1.0f, -1.0f, -1.0f }, { 1.0f, 1.0f, 1.0f } };
  float weight[2];
  float cosine[2];
  float leg[2];
  LookAtLight(points.View(), view, weight, cosine, leg);
  EXPECT_EQ(weight[0], 0.0f);
  EXPECT_EQ(cosine[0], 0.0f);
  EXPECT_EQ(leg[0], 0.0f);
  EXPECT_NEAR(weight[1], 4.0f, 1e-5f);
}
