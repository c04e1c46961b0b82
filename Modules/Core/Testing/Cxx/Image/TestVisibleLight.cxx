// SPDX-License-Identifier: BSD-3-Clause
// The light as a ray meets it: from far behind, and through its own back.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scVisibleLight.h"

#include <gtest/gtest.h>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// A square of two triangles in the plane z = @p height, half as long as 1; it emits along its normal, up or down.
void AddSquare(Light& lamp, double height, bool up)
{
  const Vector3 corners[4] = { { -1.0, -1.0, height }, { 1.0, -1.0, height }, { 1.0, 1.0, height },
    { -1.0, 1.0, height } };
  for (const int k : { 1, 2 })
  {
    lamp.Triangles.push_back(up ? std::array<Vector3, 3>{ corners[0], corners[k], corners[k + 1] }
                                : std::array<Vector3, 3>{ corners[0], corners[k + 1], corners[k] });
  }
}

} // namespace

TEST(VisibleLight, ALampOfTrianglesIsMetFromItsFaceOnlyAtAnyDistance)
{
  Light lamp;
  lamp.Shape = LightShape::Mesh;
  AddSquare(lamp, 0.0, false);
  AddSquare(lamp, -3.0, true);
  lamp = Prepared(lamp);
  const VisibleLight visible(lamp);
  const Vector3 down{ 0.0, 0.0, -1.0 };
  double t = 0.0;
  double scale = 0.0;
  // From above the back of the upper square is in front of the face of the lower one.
  for (const double distance : { 1.0, 1e4, 1e8, 1e12 })
  {
    ASSERT_TRUE(visible.Intersect({ 0.2, 0.1, distance }, down, HUGE_VAL, t, scale)) << distance;
    EXPECT_NEAR(t, distance + 3.0, 1e-12 * distance) << distance;
    EXPECT_FALSE(visible.Intersect({ 0.2, 0.1, distance }, down, distance + 2.9, t, scale)) << distance;
    EXPECT_FALSE(visible.Intersect({ 5.0, 0.1, distance }, down, HUGE_VAL, t, scale)) << distance;
  }
}
