// SPDX-License-Identifier: BSD-3-Clause
#include "scLitIntervals.h"

#include <gtest/gtest.h>

using namespace shadowcones;

namespace
{
/// A square lamp of triangles at y = 4 that shines down, a corner of it raised by @p lift.
Light LampOfTriangles(double lift)
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Triangles = { { Vector3{ -1.0, 4.0 + lift, -1.0 }, { 1.0, 4.0, -1.0 }, { 1.0, 4.0, 1.0 } },
    { Vector3{ 1.0, 4.0, 1.0 }, { -1.0, 4.0, 1.0 }, { -1.0, 4.0 + lift, -1.0 } } };
  light.Spectrum = { 1.0 };
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}
} // namespace

TEST(LitIntervals, ARayEndsWhereItPassesThePlaneOfAFlatLampOfTriangles)
{
  Box box;
  box.Add(Vector3{ -5.0, 0.0, -5.0 });
  box.Add(Vector3{ 5.0, 5.0, 5.0 });
  // From (0, 1, 0) up by 3 in 5: it passes y = 4 after 5, and leaves the box at x = 5 after 6.25.
  const Vector3 way = Normalized({ 4.0, 3.0, 0.0 });
  const Light flat = LampOfTriangles(0.0);
  const LitInterval lit = LitIntervals(flat, box).Find({ { 0.0, 1.0, 0.0 }, way });
  EXPECT_EQ(lit.Begin, 0.0);
  EXPECT_NEAR(lit.End, 5.0, 1e-12);
  // From above the lamp the lit part begins there.
  const LitInterval below = LitIntervals(flat, box).Find({ { 0.0, 4.75, 0.0 }, { way.X, -way.Y, 0.0 } });
  EXPECT_NEAR(below.Begin, 1.25, 1e-12);
  EXPECT_NEAR(below.End, 6.25, 1e-12);
  // A lamp that is not flat shines to both sides of any plane.
  const Light bent = LampOfTriangles(0.5);
  EXPECT_NEAR(LitIntervals(bent, box).Find({ { 0.0, 1.0, 0.0 }, way }).End, 6.25, 1e-12);
}
