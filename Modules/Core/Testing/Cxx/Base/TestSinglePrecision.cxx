// SPDX-License-Identifier: BSD-3-Clause
// Numbers of single precision and their neighbours, also two and three side by side; what follows for flush triangles.
#include "scFlatFace.h"
#include "scRandom.h"
#include "scSinglePrecision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace shadowcones;

namespace
{

/// Numbers that single precision holds, of all sizes: small multiples of powers of two.
std::vector<double> SingleNumbers()
{
  std::vector<double> numbers{ 0.0, 1.0, 16777215.0, std::ldexp(1.0, -149), std::ldexp(3.0, -149),
    std::ldexp(1.0, -126), std::ldexp(16777215.0, 104) };
  for (std::uint64_t i = 0; i < 2000; ++i)
  {
    RandomStream random(1, i);
    const double digits = std::floor(16777216.0 * random.Next());
    numbers.push_back(std::ldexp(digits, static_cast<int>(-149.0 + 250.0 * random.Next())));
  }
  return numbers;
}

} // namespace

TEST(SinglePrecision, NumbersAreToldFromTheirNeighbours)
{
  for (const double x : SingleNumbers())
  {
    for (const double y : { x, -x })
    {
      EXPECT_TRUE(IsSinglePrecision(y)) << y;
      EXPECT_FALSE(IsSinglePrecision(std::nextafter(y, HUGE_VAL))) << y;
      EXPECT_FALSE(IsSinglePrecision(std::nextafter(y, -HUGE_VAL))) << y;
      EXPECT_EQ(RoundToSingle(std::nextafter(y, HUGE_VAL)), y);
      EXPECT_EQ(RoundToSingle(y), y);
    }
  }
  EXPECT_TRUE(IsSinglePrecision(HUGE_VAL));
  EXPECT_FALSE(IsSinglePrecision(1e300));
  EXPECT_FALSE(IsSinglePrecision(std::ldexp(1.0, 128))); // the first power of two beyond
  EXPECT_FALSE(IsSinglePrecision(std::ldexp(1.0, -150)));
  EXPECT_FALSE(IsSinglePrecision(std::numeric_limits<double>::quiet_NaN()));
}

TEST(SinglePrecision, OneCoordinateOfThreeThatIsNotSingleIsSeen)
{
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i)
  {
    const double x[2] = { 0.1, RoundToSingle(0.1) };
    points.push_back({ x[i & 1], 2.0 * x[(i >> 1) & 1], 3.5 * x[(i >> 2) & 1] });
  }
  points[7].Z = RoundToSingle(0.35);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // A step of single precision at .35 is 2^-25: a corner is off by no more than 2^-22 times its largest coordinate.
    const double expected = i == 7 ? std::ldexp(RoundToSingle(0.35), -22) : 0.0;
    EXPECT_EQ(SinglePrecisionRounding(points[i]), expected) << i;
  }
}
