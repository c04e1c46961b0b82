// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCurve.h"

#include <gtest/gtest.h>

#include <vector>

using namespace shadowcones;

TEST(ErrorCurve, IsStraightInLogarithms)
{
  // A quarter of the time for twice the error, as of random samples.
  const std::vector<CurvePoint> points = { { 16.0, 0.005 }, { 1.0, 0.02 }, { 4.0, 0.01 } };
  for (const double error : { 0.02, 0.0123, 0.01, 0.007, 0.005 })
  {
    const TimeAtError time = TimeAt(points, error);
    EXPECT_NEAR(time.Seconds, 4e-4 / (error * error), 1e-9) << error;
    EXPECT_EQ(time.Is, error < 0.02 ? TimeAtError::Interpolated : TimeAtError::AtMost) << error;
  }
}

TEST(ErrorCurve, NeverExtrapolates)
{
  const std::vector<CurvePoint> points = { { 1.0, 0.02 }, { 4.0, 0.01 } };
  EXPECT_EQ(TimeAt(points, 0.009).Is, TimeAtError::NotReached);
  EXPECT_FALSE(TimeAt({}, 1.0).IsKnown());
  const TimeAtError cheap = TimeAt(points, 0.5);
  EXPECT_EQ(cheap.Is, TimeAtError::AtMost);
  EXPECT_DOUBLE_EQ(cheap.Seconds, 1.0);
}

TEST(ErrorCurve, LeavesOutPointsThatAnotherOneBeats)
{
  const std::vector<CurvePoint> points = { { 1.0, 0.02 }, { 2.0, 0.04 }, { 3.0, 0.02 }, { 4.0, 0.01 } };
  EXPECT_DOUBLE_EQ(TimeAt(points, 0.02).Seconds, 1.0);
  EXPECT_NEAR(TimeAt(points, 0.0141421356).Seconds, 2.0, 1e-6);
}

TEST(ErrorCurve, TakesAnErrorOfNoneAsTiny)
{
  const TimeAtError time = TimeAt({ { 1.0, 0.01 }, { 2.0, 0.0 } }, 0.0);
  EXPECT_EQ(time.Is, TimeAtError::Interpolated);
  EXPECT_NEAR(time.Seconds, 2.0, 1e-9);
}

TEST(ErrorCurve, FindsTheExponentOfAPower)
{
  const std::vector<double> x = { 1.0, 2.0, 4.0, 10.0 };
  std::vector<double> y;
  for (const double value : x)
  {
    y.push_back(7.0 * value * value * value);
  }
  EXPECT_NEAR(GrowthExponent(x, y), 3.0, 1e-12);
  EXPECT_EQ(GrowthExponent({ 5.0, 5.0 }, { 1.0, 2.0 }), 0.0);
}

TEST(ErrorCurve, MedianIsTheMiddle)
{
  EXPECT_EQ(Median({ 9.0, 1.0, 2.0 }), 2.0);
  EXPECT_EQ(Median({ 9.0, 1.0, 2.0, 4.0 }), 3.0);
  EXPECT_EQ(Median({}), 0.0);
}
