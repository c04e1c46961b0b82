// SPDX-License-Identifier: BSD-3-Clause
// Hours in the Sun along paths made by hand: closed forms of walls and courtyards, and rays one by one.
#include "scSunHours.h"

#include "TestMeshes.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double degree = Pi / 180.0;

/// A Sun that rises in the east (x), stands overhead at 6 h and sets at 12 h: 15 degrees an hour.
std::vector<SunStep> HalfCircle(int count)
{
  std::vector<SunStep> steps;
  for (int k = 0; k < count; ++k)
  {
    SunStep step;
    step.Length = 12.0 / count;
    step.Begin = k * step.Length;
    const double angle = Pi * (k + 0.5) / count;
    step.Direction = { std::cos(angle), 0.0, std::sin(angle) };
    step.IsUp = true;
    steps.push_back(step);
  }
  return steps;
}

struct OnePoint
{
  double Hours, First, Last, Longest, Error;
  int OccluderId;
};

OnePoint Ask(const TestMesh& mesh, const std::vector<SunStep>& steps, const Vector3& point,
  const SunHoursOptions& options = {}, const Vector3& normal = {})
{
  const OccluderScene scene(mesh.View());
  const double p[3] = { point.X, point.Y, point.Z };
  const double n[3] = { normal.X, normal.Y, normal.Z };
  SunHoursResult result;
  EXPECT_TRUE(ComputeSunHours(scene, steps, p, n, 1, options, {}, result));
  return { result.Hours[0], result.First[0], result.Last[0], result.Longest[0], result.Errors[0],
    result.OccluderIds.empty() ? -2 : result.OccluderIds[0] };
}

/// The hour at which a Sun of HalfCircle stands at such an angle above the east.
double HourOf(double angle)
{
  return angle / (15.0 * degree);
}

} // namespace

TEST(SunHours, AWallInTheEastTakesTheMorning)
{
  // Of height 3 at distance 2: the Sun comes over it at atan(3 / 2).
  TestMesh wall;
  wall.AddSheet({ 2.0, -50.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 0.0, 0.0, 3.0 }, 4);
  const double comes = HourOf(std::atan2(3.0, 2.0));
  for (const int count : { 24, 720, 7001 })
  {
    SunHoursOptions options;
    options.FindOccluders = true;
    const OnePoint found = Ask(wall, HalfCircle(count), { 0.0, 0.0, 0.0 }, options);
    const double step = 12.0 / count;
    EXPECT_NEAR(found.Hours, 12.0 - comes, 0.5 * step + 1e-5);
    EXPECT_NEAR(found.First, comes, 0.5 * step + 1e-5);
    EXPECT_NEAR(found.Error, 0.5 * step, 1e-6);
    EXPECT_FLOAT_EQ(static_cast<float>(found.Last), 12.0f);
    EXPECT_EQ(found.Longest, found.Hours);
    EXPECT_EQ(found.OccluderId, 4);
  }
}

TEST(SunHours, ACourtyardHasTheMiddleOfTheDay)
{
  // Walls at distances 1 and 3, 4 high, and a beam over the middle that takes a piece out: z = 4, x from -.4 to .2.
  TestMesh yard;
  yard.AddBox({ 1.0, -9.0, 0.0 }, { 1.2, 9.0, 4.0 }, 0);
  yard.AddBox({ -3.5, -9.0, 0.0 }, { -3.0, 9.0, 4.0 }, 1);
  yard.AddBox({ -0.4, -9.0, 4.0 }, { 0.2, 9.0, 4.1 }, 2);
  constexpr int count = 7200;
  const double step = 12.0 / count;
  const double comes = HourOf(std::atan2(4.0, 1.0));
  const double goes = HourOf(std::atan2(4.0, -3.0));
  const double beamFrom = HourOf(std::atan2(4.0, 0.2));
  const double beamTo = HourOf(std::atan2(4.0, -0.4));
  SunHoursOptions options;
  options.FindOccluders = true;
  const OnePoint found = Ask(yard, HalfCircle(count), {}, options);
  EXPECT_NEAR(found.Hours, goes - comes - (beamTo - beamFrom), 2.0 * step + 1e-5);
  EXPECT_NEAR(found.First, comes, 0.5 * step + 1e-5);
  EXPECT_NEAR(found.Last, goes, 0.5 * step + 1e-5);
  EXPECT_NEAR(found.Longest, std::max(beamFrom - comes, goes - beamTo), step + 1e-5);
  EXPECT_NEAR(found.Error, 4.0 * 0.5 * step, 1e-5);
  EXPECT_EQ(found.OccluderId, 0); // it stands nearer
  // On the floor's other side all of it is dark, and nobody's.
  const OnePoint below = Ask(yard, HalfCircle(count), {}, options, { 0.0, 0.0, -1.0 });
  EXPECT_EQ(below.Hours, 0.0);
  EXPECT_EQ(below.First, -1.0);
  EXPECT_EQ(below.Last, -1.0);
  EXPECT_EQ(below.Longest, 0.0);
  EXPECT_EQ(below.Error, 0.0);
  EXPECT_EQ(below.OccluderId, -1);
}

TEST(SunHours, AnEdgeTakesTheDiscByAndBy)
{
  // The share above an edge that crosses a disc of radius r at height h of it is that of a circular segment.
  TestMesh wall;
  wall.AddSheet({ 2.0, -500.0, 0.0 }, { 0.0, 1000.0, 0.0 }, { 0.0, 0.0, 2.0 });
  SunHoursOptions options;
  options.AngularRadius = 0.2665 * degree;
  options.NumberOfLightSamples = 1024;
  for (const double h : { -1.2, -0.7, -0.2, 0.0, 0.4, 0.9, 1.3 })
  {
    SunStep step;
    step.Length = 1.0;
    step.IsUp = true;
    const double altitude = 45.0 * degree + h * options.AngularRadius;
    step.Direction = { std::cos(altitude), 0.0, std::sin(altitude) };
    const double cut = std::clamp(h, -1.0, 1.0);
    const double share = 1.0 - (std::acos(cut) - cut * std::sqrt(1.0 - cut * cut)) / Pi;
    EXPECT_NEAR(Ask(wall, { step }, {}, options).Hours, share, 0.01) << h;
    // Its own surface cuts the disc in the same way: one that is tilted by 45 degrees.
    const Vector3 normal{ -1.0, 0.0, 1.0 };
    EXPECT_NEAR(Ask(OutOfTheWay(), { step }, {}, options, normal).Hours, share, 0.01) << h;
  }
}

TEST(SunHours, TheHorizonCutsTheDisc)
{
  SunHoursOptions options;
  options.AngularRadius = 0.2665 * degree;
  options.NumberOfLightSamples = 1024;
  options.Up = { 0.0, 0.0, 1.0 };
  for (const double lowest : { 0.0, -5.0 * degree })
  {
    options.LowestAltitude = lowest;
    for (const double h : { -1.1, -0.6, 0.0, 0.3, 1.1 })
    {
      SunStep step;
      step.Length = 1.0;
      step.IsUp = true;
      const double altitude = lowest + h * options.AngularRadius;
      step.Direction = { std::cos(altitude), 0.0, std::sin(altitude) };
      const double cut = std::clamp(h, -1.0, 1.0);
      const double share = 1.0 - (std::acos(cut) - cut * std::sqrt(1.0 - cut * cut)) / Pi;
      EXPECT_NEAR(Ask(OutOfTheWay(), { step }, {}, options).Hours, share, 0.01) << h;
    }
  }
}

TEST(SunHours, ADayOfTheDiscIsADayOfItsMiddle)
{
  // What an edge takes from one half of the disc it leaves to the other: hours are those of a hard Sun. The wall goes
  // down to where the rising disc is seen below the horizon.
  TestMesh wall;
  wall.AddSheet({ 2.0, -500.0, -1.0 }, { 0.0, 1000.0, 0.0 }, { 0.0, 0.0, 4.0 }, 4);
  SunHoursOptions disc;
  disc.AngularRadius = 2.0 * degree;
  disc.FindOccluders = true;
  const OnePoint found = Ask(wall, HalfCircle(7200), {}, disc);
  EXPECT_NEAR(found.Hours, 12.0 - HourOf(std::atan2(3.0, 2.0)), 0.004);
  EXPECT_NEAR(found.First, HourOf(std::atan2(3.0, 2.0) - disc.AngularRadius), 0.02);
  EXPECT_NEAR(found.Error, 0.5 * 12.0 / 7200, 1e-5);
  EXPECT_EQ(found.OccluderId, 4);
}

TEST(SunHours, NightDividesAndCounts)
{
  std::vector<SunStep> steps = HalfCircle(240); // .05 h each
  for (int k = 100; k < 130; ++k)
  {
    steps[static_cast<std::size_t>(k)].IsUp = false;
  }
  steps[0].IsUp = false;
  const OnePoint found = Ask(OutOfTheWay(), steps, {});
  EXPECT_NEAR(found.Hours, 0.05 * (240 - 31), 1e-5);
  EXPECT_NEAR(found.First, 0.05, 1e-6);
  EXPECT_NEAR(found.Longest, 0.05 * 110, 1e-5);
  EXPECT_NEAR(found.Error, 3 * 0.025, 1e-6);
}

TEST(SunHours, StepsOfAnyLengthAndNone)
{
  std::vector<SunStep> steps = HalfCircle(3);
  steps[2].Length = 0.5; // the last one is cut off
  EXPECT_NEAR(Ask(OutOfTheWay(), steps, {}).Hours, 8.5, 1e-6);
  EXPECT_NEAR(Ask(OutOfTheWay(), steps, {}).Last, 8.5, 1e-6);
  TestMesh last;
  last.AddSheet({ -2.0, -50.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 0.0, 0.0, 3.0 }); // hides 30 degrees, the last step
  EXPECT_NEAR(Ask(last, steps, {}).Hours, 8.0, 1e-6);
  EXPECT_NEAR(Ask(last, steps, {}).Error, 0.5 * 4.0, 1e-6); // of the longer step
  EXPECT_EQ(Ask(last, {}, {}).Hours, 0.0);
  EXPECT_EQ(Ask(last, {}, {}).First, -1.0);
  SunHoursResult result;
  const OccluderScene scene(last.View());
  EXPECT_TRUE(ComputeSunHours(scene, steps, nullptr, nullptr, 0, {}, {}, result));
  EXPECT_TRUE(result.Hours.empty());
}

TEST(SunHours, PacketsAnswerAsRaysOneByOne)
{
  // A thicket of boxes, and directions all over the sphere, so that every fold of the curve is there.
  TestMesh mesh;
  RandomStream random(3, 0);
  for (int k = 0; k < 60; ++k)
  {
    const Vector3 low{ 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0 };
    mesh.AddBox(low, low + Vector3{ 0.3 * random.Next(), 0.3 * random.Next(), 0.8 * random.Next() }, k);
  }
  // Sheets that cover whole packets, or nearly.
  mesh.AddSheet({ -3.0, -3.0, 2.6 }, { 6.0, 0.0, 0.0 }, { 0.0, 4.0, 0.3 }, 60);
  mesh.AddSheet({ 2.6, -3.0, -3.0 }, { 0.0, 5.0, 0.0 }, { 0.2, 0.0, 6.0 }, 61);
  std::vector<SunStep> steps;
  for (int k = 0; k < 1000; ++k)
  {
    SunStep step;
    step.Length = 1.0;
    step.Begin = k;
    const double z = 2.0 * random.Next() - 1.0;
    const double angle = 2.0 * Pi * random.Next();
    step.Direction = { std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z };
    step.IsUp = k % 7 != 0;
    steps.push_back(step);
  }
  const OccluderScene scene(mesh.View());
  std::vector<double> points;
  for (int k = 0; k < 90; ++k)
  {
    points.push_back(5.0 * random.Next() - 2.5);
  }
  SunHoursResult result;
  ASSERT_TRUE(ComputeSunHours(scene, steps, points.data(), nullptr, 30, {}, {}, result));
  for (std::size_t i = 0; i < 30; ++i)
  {
    const Vector3 origin{ points[3 * i], points[3 * i + 1], points[3 * i + 2] };
    int lit = 0;
    int first = -1;
    for (int k = 0; k < 1000; ++k)
    {
      const SunStep& step = steps[static_cast<std::size_t>(k)];
      const bool sees = step.IsUp && !scene.Occluded(origin, step.Direction, 0.0, HUGE_VAL);
      lit += sees;
      first = sees && first < 0 ? k : first;
    }
    EXPECT_EQ(result.Hours[i], static_cast<float>(lit));
    EXPECT_EQ(result.First[i], static_cast<float>(first));
  }
}

TEST(SunHours, WhatCoversADiscHidesAllOfIt)
{
  // A roof tile from far off to just beside the disc, all around it: shares with a tile that may cover are those of the
  // same tile cut into pieces that cannot.
  const double radius = 0.05;
  SunHoursOptions options;
  options.AngularRadius = radius;
  options.NumberOfLightSamples = 64;
  std::vector<SunStep> steps;
  for (int k = 0; k < 400; ++k)
  {
    SunStep step;
    step.Length = 1.0;
    step.Begin = k;
    step.IsUp = true;
    const double x = -0.3 + 0.0015 * k;
    step.Direction = Normalized({ x, 0.1 * std::sin(0.1 * k), 1.0 });
    steps.push_back(step);
  }
  TestMesh whole;
  const vtkIdType a = whole.AddPoint({ -0.4, -0.6, 2.0 });
  const vtkIdType b = whole.AddPoint({ 0.5, -0.4, 2.1 });
  const vtkIdType c = whole.AddPoint({ 0.1, 0.5, 1.9 });
  whole.AddTriangle(a, b, c, 0);
  TestMesh cut;
  constexpr int parts = 40;
  const auto at = [&](int i, int j)
  {
    const Vector3 corner = whole.View().Point(a);
    return corner + (1.0 * i / parts) * (whole.View().Point(b) - corner) +
      (1.0 * j / parts) * (whole.View().Point(c) - corner);
  };
  for (int i = 0; i < parts; ++i)
  {
    for (int j = 0; i + j < parts; ++j)
    {
      const vtkIdType first = cut.AddPoint(at(i, j));
      cut.AddPoint(at(i + 1, j));
      cut.AddPoint(at(i, j + 1));
      cut.AddPoint(at(i + 1, j + 1));
      cut.AddTriangle(first, first + 1, first + 2, 0);
      if (i + j + 1 < parts)
      {
        cut.AddTriangle(first + 1, first + 3, first + 2, 0);
      }
    }
  }
  const OnePoint found = Ask(whole, steps, {}, options);
  const OnePoint expected = Ask(cut, steps, {}, options);
  EXPECT_EQ(found.Hours, expected.Hours);
  EXPECT_EQ(found.First, expected.First);
  EXPECT_EQ(found.Longest, expected.Longest);
  EXPECT_EQ(found.Error, expected.Error);
  EXPECT_GT(found.Hours, 150.0);
  EXPECT_LT(found.Hours, 350.0);
}

TEST(SunHours, AnAbortIsHeard)
{
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  const TestMesh mesh = OutOfTheWay();
  const OccluderScene scene(mesh.View());
  const double point[3] = {};
  SunHoursResult result;
  EXPECT_FALSE(ComputeSunHours(scene, HalfCircle(10), point, nullptr, 1, {}, monitor, result));
}
