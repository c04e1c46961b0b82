// SPDX-License-Identifier: BSD-3-Clause
// Shadows on whole lines: by hand, and against occlusion rays.
#include "TestMeshes.h"
#include "scLineShadows.h"
#include "scOccluderScene.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// A line along x from x = 0, as long as asked for, under a sheet at y = 1 over x from 1 to 2.
struct LineUnderASheet
{
  Placement Where{ "", 1.0, {} };
  TestMesh Mesh;
  LineAndLight Query;

  explicit LineUnderASheet(const Placement& where = { "", 1.0, {} }, double length = 5.0)
    : Where(where)
  {
    this->Mesh.AddSheet(
      where({ 1.0, 1.0, -1.0 }), where.Scale * Vector3{ 1.0, 0.0, 0.0 }, where.Scale * Vector3{ 0.0, 0.0, 2.0 });
    this->Query.Line = { where({ -10.0, 0.0, 0.1 }), { 1.0, 0.0, 0.0 } };
    this->Query.Begin = 10.0 * where.Scale;
    this->Query.End = (10.0 + length) * where.Scale;
  }
  /// As x where nothing is moved.
  std::vector<RayInterval> Find(const Vector3& light, bool atInfinity, const unsigned char* ignored = nullptr)
  {
    const LineShadows shadows(this->Mesh.View());
    this->Query.Light = atInfinity ? Normalized(light) : this->Where(light);
    this->Query.AtInfinity = atInfinity;
    std::vector<RayInterval> hidden;
    EXPECT_TRUE(shadows.Find(this->Query, ignored, hidden));
    for (RayInterval& interval : hidden)
    {
      interval = { interval.Begin / this->Where.Scale - 10.0, interval.End / this->Where.Scale - 10.0 };
    }
    return hidden;
  }
};

void ExpectOne(const std::vector<RayInterval>& hidden, double begin, double end, double within)
{
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_NEAR(hidden[0].Begin, begin, within);
  EXPECT_NEAR(hidden[0].End, end, within);
}
} // namespace

TEST(LineShadows, AreBuiltWhenTheyAreAskedForAndCounted)
{
  const LineUnderASheet stage;
  const OccluderScene scene(stage.Mesh.View());
  const std::int64_t before = scene.Memory();
  const LineShadows& lines = scene.Lines();
  EXPECT_EQ(scene.Memory(), before + lines.Memory());
  EXPECT_GE(lines.Memory(), static_cast<std::int64_t>(2 * 9 * sizeof(double))); // the corners of two triangles
  EXPECT_EQ(&scene.Lines(), &lines);
}

TEST(LineShadows, ASheetBetweenALineAndALight)
{
  for (const Placement& where : Placements())
  {
    SCOPED_TRACE(where.Name);
    const double within = std::string(where.Name) == "far away" ? 1e-8 : 1e-12;
    LineUnderASheet scene(where);
    // From (0, 3) the edges at y = 1 are seen at half as far again.
    ExpectOne(scene.Find({ 0.0, 3.0, 0.0 }, false), 1.5, 3.0, within);
    ExpectOne(scene.Find({ 0.0, 1.0, 0.0 }, true), 1.0, 2.0, within);
    ExpectOne(scene.Find({ 1.0, 2.0, 0.0 }, true), 0.5, 1.5, within);
    EXPECT_TRUE(scene.Find({ 0.0, -3.0, 0.0 }, false).empty()) << "a light on the other side";
    EXPECT_TRUE(scene.Find({ 0.0, -1.0, 0.0 }, true).empty());
    EXPECT_TRUE(scene.Find({ 1.5, 0.9, 0.1 }, false).empty()) << "a light in front of the sheet";
    EXPECT_TRUE(scene.Find({ 1.5, 1.0, 0.1 }, false).empty()) << "a light in its plane";
    EXPECT_TRUE(scene.Find({ 1.5, 2.0, 9.0 }, false).empty()) << "past its edge";
  }
}

TEST(LineShadows, EndsOfTheLineAndWhatIsIgnored)
{
  LineUnderASheet scene({ "", 1.0, {} }, 2.0);
  const auto hidden = scene.Find({ 0.0, 3.0, 0.0 }, false);
  ExpectOne(hidden, 1.5, 2.0, 1e-12);
  EXPECT_EQ(hidden[0].End, 2.0) << "to the last bit";
  const unsigned char both[2] = { 1, 1 };
  EXPECT_TRUE(scene.Find({ 0.0, 3.0, 0.0 }, false, both).empty());
  // A line in the sheet's own plane is not hidden by it.
  scene.Query.Line.Origin.Y = 1.0;
  EXPECT_TRUE(scene.Find({ 0.0, 3.0, 0.0 }, false).empty());
  // A line that points at the light has no plane with it.
  scene.Query.Light = { 99.0, 1.0, 0.1 };
  std::vector<RayInterval> nothing;
  EXPECT_FALSE(LineShadows(scene.Mesh.View()).Find(scene.Query, nullptr, nothing));
  EXPECT_TRUE(LineShadows(TriangleMeshView()).Find(scene.Query, nullptr, nothing));
  EXPECT_TRUE(nothing.empty());
}

TEST(LineShadows, AreThoseOfRays)
{
  TestMesh mesh;
  RandomStream random(3, 0);
  const auto draw = [&random](double scale) {
    return Vector3{ scale * (random.Next() - 0.5), scale * (random.Next() - 0.5), scale * (random.Next() - 0.5) };
  };
  for (int k = 0; k < 500; ++k)
  {
    mesh.AddSheet(draw(4.0), draw(0.8), draw(0.8));
  }
  const LineShadows shadows(mesh.View());
  const OccluderScene rays(mesh.View());
  std::vector<RayInterval> hidden;
  int blocked = 0;
  constexpr int places = 50;
  for (int line = 0; line < 200; ++line)
  {
    LineAndLight query;
    query.Line = { draw(6.0), Normalized(draw(1.0)) };
    query.Begin = random.Next();
    query.End = query.Begin + 4.0 * random.Next();
    query.AtInfinity = line % 2 == 0;
    query.Light = query.AtInfinity ? Normalized(draw(1.0)) : draw(8.0);
    ASSERT_TRUE(shadows.Find(query, nullptr, hidden));
    for (std::size_t k = 1; k < hidden.size(); ++k)
    {
      ASSERT_GT(hidden[k].Begin, hidden[k - 1].End);
    }
    for (int k = 0; k < places; ++k)
    {
      const double t = query.Begin + (k + random.Next()) / places * (query.End - query.Begin);
      const bool inside = std::any_of(
        hidden.begin(), hidden.end(), [t](const RayInterval& part) { return t > part.Begin && t < part.End; });
      const Vector3 point = query.Line.Origin + t * query.Line.Direction;
      const Vector3 to = query.AtInfinity ? query.Light : query.Light - point;
      const double distance = query.AtInfinity ? HUGE_VAL : Length(to);
      EXPECT_EQ(inside, rays.Occluded(point, Normalized(to), 0.0, distance)) << "line " << line << ", t " << t;
      blocked += inside;
    }
  }
  EXPECT_GT(blocked, 1000);
  EXPECT_LT(blocked, 9000);
}

TEST(LineShadows, NothingLeaksBetweenTriangles)
{
  // A dome of many triangles around the line.
  TestMesh dome;
  dome.AddSphere({ 0.0, 0.0, 0.0 }, 2.0, 24);
  const LineShadows shadows(dome.View());
  RandomStream random(5, 0);
  std::vector<RayInterval> hidden;
  for (int k = 0; k < 300; ++k)
  {
    LineAndLight query;
    query.Line = { { -1.0, 0.3 * random.Next(), 0.3 * random.Next() }, { 1.0, 0.0, 0.0 } };
    query.End = 2.0;
    query.AtInfinity = k % 2 == 0;
    query.Light = Normalized({ random.Next() - 0.5, random.Next() + 0.1, random.Next() - 0.5 });
    query.Light = (query.AtInfinity ? 1.0 : 7.0) * query.Light;
    ASSERT_TRUE(shadows.Find(query, nullptr, hidden));
    ASSERT_EQ(hidden.size(), 1u) << k;
    EXPECT_EQ(hidden[0].Begin, 0.0);
    EXPECT_EQ(hidden[0].End, 2.0);
  }
}
