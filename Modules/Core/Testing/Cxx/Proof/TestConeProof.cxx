// SPDX-License-Identifier: BSD-3-Clause
// Cone sets that are proved: by the check that shares nothing with the builder, by closed forms, and by a search for leaks.
#include "scConeProof.h"

#include "ConeAdversary.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scConeProofCheck.h"
#include "scOccluderParts.h"
#include "scProofMargins.h"
#include "scProvedSet.h"

#include "vtkSMPTools.h"

#include <map>
#include <random>
#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{
Light MeshLight(const std::vector<std::array<Vector3, 3>>& faces)
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Triangles = faces;
  return Prepared(light);
}

/// A turned lamp of two faces that shines down from about (0, 0, 3).
std::vector<std::array<Vector3, 3>> LampFaces(const Vector3& at)
{
  const Vector3 a = at + Vector3{ -0.4, -0.4, 0.0 };
  const Vector3 b = at + Vector3{ 0.4, -0.4, 0.1 };
  const Vector3 c = at + Vector3{ 0.4, 0.4, 0.0 };
  const Vector3 d = at + Vector3{ -0.4, 0.4, -0.1 };
  return { { a, c, b }, { a, d, c } };
}

std::map<std::string, Light> LightsAbove()
{
  return { { "disc", DiscLight({ 0.0, 0.0, 3.0 }, { 0.1, 0.0, -1.0 }, 0.5) },
    { "rectangle", RectangleLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.3, 0.0 }, { 0.6, 0.0, 0.0 }) },
    { "sphere", SphereLight({ 0.0, 0.0, 3.0 }, 0.5) }, { "point", PointLight({ 0.0, 0.0, 3.0 }) },
    { "sun", SunLight({ 0.3, 0.1, -1.0 }, 0.005) }, { "hard sun", SunLight({ 0.3, 0.1, -1.0 }, 0.0) },
    { "sky", SunLight({ 0.0, 0.0, -1.0 }, 1.3) }, { "mesh", MeshLight(LampFaces({ 0.0, 0.0, 3.0 })) } };
}

std::map<std::string, TestMesh> Casters()
{
  std::map<std::string, TestMesh> casters;
  for (int strip = 0; strip < 7; ++strip)
  {
    casters["slats"].AddSheet({ -1.0 + 0.3 * strip, -1.0, 1.0 }, { 0.2, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, strip);
  }
  casters["cube"].AddBox({ -0.5, -0.5, 0.2 }, { 0.5, 0.5, 1.2 }, 0);
  casters["sheet"].AddSheet({ -0.8, -0.3, 1.4 }, { 1.5, 0.2, 0.3 }, { 0.1, 0.9, -0.2 }, 0);
  casters["sphere"].AddSphere({ 0.3, 0.2, 0.8 }, 0.6, 12, 0);
  // Parts beside and above the lamp, all around it: no cone holds them all.
  for (int k = 0; k < 24; ++k)
  {
    const auto at = [](int i, double z) {
      return Vector3{ 2.0 * std::cos(Pi * i / 12.0), 2.0 * std::sin(Pi * i / 12.0), z };
    };
    casters["ring"].AddSheet(at(k, 2.4), at(k + 1, 2.4) - at(k, 2.4), { 0.0, 0.0, 0.4 }, 0);
  }
  casters["dome"].AddSphere({ 0.0, 0.0, 3.0 }, 1.5, 10, 0);
  casters["closed box"].AddBox({ -1.5, -1.2, -0.5 }, { 1.0, 1.4, 4.0 }, 0);
  return casters;
}

ConeProof Prove(const TestMesh& mesh, const Light& light, const std::vector<Cone>& given = {})
{
  ConeProof proof;
  EXPECT_TRUE(ProveConeSet(mesh.View(), { light }, given, {}, {}, proof));
  return proof;
}

ConeProofCheck Check(const TestMesh& mesh, const Light& light, const std::vector<Cone>& cones, const Box& held = {})
{
  ConeProofCheck check;
  EXPECT_TRUE(CheckConeProof(mesh.View(), light, cones, held, {}, check));
  return check;
}

bool IsProved(const TestMesh& mesh, const Light& light, const std::vector<Cone>& cones)
{
  return Check(mesh, light, cones).Proved;
}

/// A square sheet of 2 x 2 around the z axis at height 0.
TestMesh Square()
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 0);
  return mesh;
}

/// A cone around a square from a little above it, down the z axis.
Cone ConeOfSquare(double halfAngle)
{
  Cone cone;
  cone.Center = { 0.0, 0.0, 1e-4 };
  cone.Axis = { 0.0, 0.0, -1.0 };
  cone.BaseRadius = 1.4145;
  cone.HalfAngle = halfAngle;
  return cone;
}
} // anonymous namespace

TEST(ConeProofCheck, HalfAnglesOfClosedForms)
{
  const TestMesh square = Square();
  const double corner = std::sqrt(2.0);
  // The largest angle between the axis and a way from the light to a corner.
  const std::map<std::string, std::pair<Light, double>> cases = {
    { "point", { PointLight({ 0.0, 0.0, 2.0 }), std::atan2(corner, 2.0) } },
    { "disc", { DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5), std::atan2(corner + 0.5, 2.0) } },
    { "sphere", { SphereLight({ 0.0, 0.0, 2.0 }, 0.5), std::atan2(corner, 2.0) + std::asin(0.5 / std::sqrt(6.0)) } },
    { "sun", { SunLight({ 0.0, 0.0, -1.0 }, 0.2), 0.2 } },
    { "rectangle", { RectangleLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.5, 0.0 }, { 0.5, 0.0, 0.0 }), std::atan2(1.5 * corner, 2.0) } }
  };
  for (const auto& one : cases)
  {
    const double angle = one.second.second;
    // The polygon around a disc is larger than it by 1 / cos(pi / 64), 0.12 %.
    EXPECT_TRUE(IsProved(square, one.second.first, { ConeOfSquare(angle + 1e-3) })) << one.first;
    EXPECT_FALSE(IsProved(square, one.second.first, { ConeOfSquare(angle - 1e-4) })) << one.first;
  }
}

TEST(ConeProofCheck, NamesThePartThatNoConeHolds)
{
  const TestMesh square = Square();
  const Light light = PointLight({ 0.0, 0.0, 2.0 });
  Cone cone = ConeOfSquare(0.8);
  cone.BaseRadius = 1.3;
  const ConeProofCheck check = Check(square, light, { cone });
  ASSERT_FALSE(check.Proved);
  // What sticks out are the corners, 1.414 from the axis.
  EXPECT_EQ(check.Triangle, 0);
  EXPECT_EQ(check.LightFace, -1);
  EXPECT_GT(Length(check.Part[0]), 1.29);
  // A converging cone holds no shadow; behind the square nothing is held; no cones hold nothing.
  EXPECT_FALSE(IsProved(square, light, { ConeOfSquare(-0.1) }));
  cone = ConeOfSquare(0.8);
  cone.Center.Z = -1e-4;
  EXPECT_FALSE(IsProved(square, light, { cone }));
  EXPECT_FALSE(IsProved(square, light, {}));
  EXPECT_TRUE(IsProved(TestMesh(), light, {}));
}

TEST(ConeProofCheck, CastersBehindALampNeedNoCone)
{
  const TestMesh square = Square();
  EXPECT_TRUE(IsProved(square, DiscLight({ 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 }, 0.5), {}));
  EXPECT_TRUE(IsProved(square, DiscLight({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, 0.5), {})) << "flush with the lamp";
  EXPECT_FALSE(IsProved(square, SphereLight({ 0.0, 0.0, -1.0 }, 0.5), {}));
  EXPECT_TRUE(IsProved(square, SphereLight({ 0.0, 0.0, 0.0 }, 5.0), {})) << "inside the lamp";
}

TEST(ConeProof, EveryCasterBeforeEveryLightIsProved)
{
  int pair = 0;
  for (const auto& caster : Casters())
  {
    ++pair;
    for (const auto& light : LightsAbove())
    {
      // Every second pair, as on a chessboard: each caster before half of the lights, each light behind half of the casters.
      if (++pair % 2 != 0)
      {
        continue;
      }
      SCOPED_TRACE(caster.first + ", " + light.first);
      const ConeProof proof = Prove(caster.second, light.second);
      EXPECT_TRUE(proof.Certified);
      EXPECT_EQ(proof.NumberOfOccludersWithoutCone, 0);
      EXPECT_TRUE(proof.CertifiedBounds.Empty());
      EXPECT_EQ(proof.Cones.size(), static_cast<std::size_t>(proof.NumberOfAddedCones));
      const ConeProofCheck check = Check(caster.second, light.second, proof.Cones);
      const auto& p = check.Part;
      EXPECT_TRUE(check.Proved) << "triangle " << check.Triangle << ", face " << check.LightFace << ", at " << p[0].X << " "
                                << p[0].Y << " " << p[0].Z << " " << p[1].X << " " << p[1].Y << " " << p[1].Z;

      const ConeAdversary adversary(caster.second.View(), light.second, proof.Cones);
      const AdversaryResult leaks = adversary.Search(3600, 1);
      EXPECT_EQ(leaks.Leaks, 0) << leaks.Leak.X << " " << leaks.Leak.Y << " " << leaks.Leak.Z;
      EXPECT_GT(leaks.Inside, 600);
    }
  }
}

TEST(ConeProof, TheSearchFindsLeaksOfASetThatIsNotProved)
{
  const TestMesh cube = Casters()["cube"];
  const Light light = LightsAbove()["disc"];
  ConeProof proof = Prove(cube, light);
  for (Cone& cone : proof.Cones)
  {
    cone.HalfAngle *= 0.8;
  }
  EXPECT_GT(ConeAdversary(cube.View(), light, proof.Cones).Search(20000, 1).Leaks, 0);
}

TEST(ConeProof, OneConeThatShrinksByOnePercentIsFound)
{
  for (const char* name : { "disc", "point", "sun" })
  {
    const std::pair<std::string, Light> light{ name, LightsAbove()[name] };
    const TestMesh square = Square();
    ConeProof proof = Prove(square, light.second);
    ASSERT_TRUE(IsProved(square, light.second, proof.Cones)) << light.first;
    std::size_t found = 0;
    for (Cone& cone : proof.Cones)
    {
      const Cone kept = cone;
      cone.BaseRadius *= 0.99;
      cone.HalfAngle *= 0.99;
      found += IsProved(square, light.second, proof.Cones) ? 0 : 1;
      cone = kept;
    }
    // Where cones overlap a part may have two that hold it.
    EXPECT_GE(5 * found, proof.Cones.size()) << light.first;
  }
}

TEST(ConeProof, TwoLampsOnEitherSideOfAWall)
{
  TestMesh wall;
  wall.AddSheet({ 0.0, -2.0, 0.0 }, { 0.0, 4.0, 0.0 }, { 0.0, 0.0, 3.0 }, 0);
  // Each shines towards the wall.
  const Light light = MeshLight({ { { { -2.0, -0.5, 1.0 }, { -2.0, 0.5, 1.0 }, { -2.0, 0.0, 2.0 } } },
    { { { 2.0, -0.5, 1.0 }, { 2.0, 0.0, 2.0 }, { 2.0, 0.5, 1.0 } } } });
  const ConeProof proof = Prove(wall, light);
  EXPECT_TRUE(IsProved(wall, light, proof.Cones));
  EXPECT_EQ(ConeAdversary(wall.View(), light, proof.Cones).Search(5000, 2).Leaks, 0);
  // The shadow of each lamp alone is not enough.
  std::vector<Cone> toTheRight;
  for (const Cone& cone : proof.Cones)
  {
    if (cone.Axis.X > 0.0)
    {
      toTheRight.push_back(cone);
    }
  }
  EXPECT_FALSE(toTheRight.empty());
  const ConeProofCheck check = Check(wall, light, toTheRight);
  EXPECT_FALSE(check.Proved);
  EXPECT_EQ(check.LightFace, 1);
}

TEST(ConeProof, GivenConesStayOrGrow)
{
  const TestMesh square = Square();
  const Light light = PointLight({ 0.0, 0.0, 2.0 });
  const Cone enough = StoredCone(ConeOfSquare(0.7));
  ConeProof proof = Prove(square, light, { enough });
  ASSERT_EQ(proof.Cones.size(), 1u);
  EXPECT_EQ(proof.Cones[0].Origin, ConeOrigin::Fitted);
  EXPECT_EQ(proof.Cones[0].HalfAngle, enough.HalfAngle);
  EXPECT_EQ(proof.NumberOfGrownCones + proof.NumberOfAddedCones, 0);

  Cone narrow = enough;
  narrow.BaseRadius = 1.40;
  narrow.Center.Z = -0.01; // a little behind the square
  ConeProofOptions options;
  options.LargestNumberOfAddedCones = 1;
  ASSERT_TRUE(ProveConeSet(square.View(), { light }, { narrow }, options, {}, proof));
  EXPECT_TRUE(IsProved(square, light, proof.Cones));
  EXPECT_GE(proof.NumberOfGrownCones + proof.NumberOfAddedCones, 1);
  EXPECT_LE(proof.NumberOfAddedCones, 1);

  Cone elsewhere = enough;
  elsewhere.Center = { 30.0, 0.0, 0.0 };
  proof = Prove(square, light, { elsewhere });
  EXPECT_TRUE(IsProved(square, light, proof.Cones));
  EXPECT_EQ(proof.Cones[0].Origin, ConeOrigin::Fitted);
  EXPECT_GT(proof.NumberOfAddedCones, 0);
}

TEST(ConeProof, ConesThatNearlyHoldTheirPartsGrow)
{
  const TestMesh cube = Casters()["cube"];
  const Light light = LightsAbove()["disc"];
  const ConeProof whole = Prove(cube, light);
  std::vector<Cone> nearly = whole.Cones;
  for (Cone& cone : nearly)
  {
    cone.BaseRadius *= 0.98;
    cone.HalfAngle *= 0.99;
  }
  EXPECT_FALSE(IsProved(cube, light, nearly));
  const ConeProof proof = Prove(cube, light, nearly);
  EXPECT_TRUE(IsProved(cube, light, proof.Cones));
  EXPECT_GT(proof.NumberOfGrownCones, 0);
  EXPECT_LE(proof.Cones.size(), 2 * nearly.size());
  for (std::size_t i = 0; i < nearly.size(); ++i)
  {
    const Cone& grown = proof.Cones[i];
    EXPECT_EQ(grown.Origin == ConeOrigin::Fitted, grown.BaseRadius == StoredCone(nearly[i]).BaseRadius);
    EXPECT_GE(grown.HalfAngle, StoredCone(nearly[i]).HalfAngle);
  }
}

TEST(ConeProof, WhatHasNoConeIsHeldByABox)
{
  // A sheet through the middle of a spherical lamp, and a sky of 179 degrees.
  const TestMesh square = Square();
  const std::vector<Light> lights{ SphereLight({ 0.0, 0.0, 0.0 }, 0.5), SunLight({ 0.0, 0.0, -1.0 }, 179.0 * Pi / 360.0) };
  for (const Light& light : lights)
  {
    const ConeProof proof = Prove(square, light);
    EXPECT_TRUE(proof.Certified);
    EXPECT_EQ(proof.NumberOfOccludersWithoutCone, 1);
    ASSERT_FALSE(proof.CertifiedBounds.Empty());
    EXPECT_TRUE(proof.CertifiedBounds.Contains({ 1.0, 1.0, -20.0 }));
    EXPECT_FALSE(IsProved(square, light, proof.Cones));
    EXPECT_TRUE(Check(square, light, proof.Cones, proof.CertifiedBounds).Proved);
    std::vector<Cone> less = proof.Cones;
    less.back().BaseRadius *= 0.5;
    EXPECT_FALSE(Check(square, light, less, proof.CertifiedBounds).Proved);
  }
}

TEST(ConeProof, SliversAreNotCutToTheirWidth)
{
  // Edges by area alone make a million pieces of the first, and no end of the second.
  for (const auto& corners : { std::array<Vector3, 2>{ { { 1e9, 0.0, 1.0 }, { 0.0, 6.0, 1.0 } } },
         std::array<Vector3, 2>{ { { 6.0, 0.0, 1.0 }, { 3.0, 1e-12, 1.0 } } } })
  {
    TestMesh mesh;
    mesh.AddPoint({ 0.0, 0.0, 1.0 });
    mesh.AddPoint(corners[0]);
    mesh.AddPoint(corners[1]);
    mesh.AddTriangle(0, 1, 2, 0);
    const Light light = PointLight({ 0.0, 0.0, 3.0 });
    const OccluderParts parts(mesh.View(), light, ProofMarginsOf(MeshBounds(mesh.View())));
    std::vector<OccluderPart> pieces;
    vtkIdType proved = 0;
    ASSERT_TRUE(parts.FindUnproved({}, {}, pieces, proved));
    EXPECT_GT(pieces.size(), 1000u);
    EXPECT_LT(pieces.size(), 200000u);
  }
}

TEST(ProvedSet, TakesWhatIsTighter)
{
  // A round plate under a round lamp: one cone holds its shadow and little more.
  TestMesh plate;
  plate.AddDisc({ 0.0, 0.0, 0.0 }, 1.0, 96);
  const Light lamp = DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  Cone close;
  close.Center = { 0.0, 0.0, 1e-4 };
  close.Axis = { 0.0, 0.0, -1.0 };
  close.BaseRadius = 1.0001;
  close.HalfAngle = std::atan2(1.51, 2.0);
  ConeSet set;
  set.Cones = { close };
  ConeProof proof;
  ProofChoice choice;
  ASSERT_TRUE(ProveFittedSet(plate.View(), { lamp }, {}, true, {}, set, proof, choice));
  EXPECT_FALSE(choice.TakesParts);
  EXPECT_TRUE(choice.FittedProved);
  ASSERT_EQ(set.Cones.size(), 1u);
  EXPECT_EQ(set.Cones[0].Origin, ConeOrigin::Fitted);

  // One that holds far more loses, even before it is proved; without a choice it stays.
  close.BaseRadius = 3.0;
  set.Cones = { close };
  ASSERT_TRUE(ProveFittedSet(plate.View(), { lamp }, {}, true, {}, set, proof, choice));
  EXPECT_TRUE(choice.TakesParts);
  EXPECT_FALSE(choice.FittedProved);
  EXPECT_GT(choice.FittedVolume, choice.PartVolume);
  EXPECT_EQ(choice.NumberOfFittedCones, 1u);
  EXPECT_EQ(set.Cones.size(), choice.NumberOfPartCones);
  EXPECT_TRUE(IsProved(plate, lamp, set.Cones));
  for (const Cone& cone : set.Cones)
  {
    EXPECT_EQ(cone.Origin, ConeOrigin::Added);
  }
  set.Cones = { close };
  choice = {};
  ASSERT_TRUE(ProveFittedSet(plate.View(), { lamp }, {}, false, {}, set, proof, choice));
  EXPECT_FALSE(choice.TakesParts);
  EXPECT_EQ(set.Cones.size(), 1u);
}

TEST(ConeProof, ConesAroundPartsAreTight)
{
  // What of the cones' volume behind a ball is in shadow: by random points, and rays to random points of the lamp.
  const TestMesh ball = Casters()["sphere"];
  const Light lamp = LightsAbove()["disc"];
  const ConeProof proof = Prove(ball, lamp);
  EXPECT_LE(proof.Cones.size(), 150u);
  const ReferenceScene scene(ball.View());
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> along(-2.0, 2.0);
  int inside = 0;
  int shadowed = 0;
  while (inside < 4000)
  {
    const Vector3 point{ along(random), along(random), along(random) - 0.5 };
    if (std::any_of(proof.Cones.begin(), proof.Cones.end(),
          [&](const Cone& cone) { return ReferenceConeContains(cone, point, HUGE_VAL); }))
    {
      ++inside;
      shadowed += ReferenceVisibility(scene, lamp, point, 48, static_cast<std::uint64_t>(inside)) < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(shadowed, 0.80 * inside);
}

TEST(ConeProof, StoredConesAreReadBackAsTheyAre)
{
  for (int i = 0; i < 2000; ++i)
  {
    Cone cone = ConeOfSquare(0.001 * i);
    cone.Axis = Normalized({ std::sin(3.0 * i), std::cos(5.0 * i), std::sin(7.0 * i + 1.0) });
    cone.BaseRadius = 0.1 * i + 1e-9;
    const Cone stored = StoredCone(cone);
    const Cone again = StoredCone(stored);
    ASSERT_EQ(stored.Axis.X, again.Axis.X) << i;
    ASSERT_EQ(stored.Axis.Y, again.Axis.Y) << i;
    ASSERT_EQ(stored.Axis.Z, again.Axis.Z) << i;
    ASSERT_EQ(stored.BaseRadius, again.BaseRadius) << i;
    ASSERT_LT(Length(stored.Axis - cone.Axis), 1e-6) << i;
    const std::vector<float> written{ static_cast<float>(cone.BaseRadius), static_cast<float>(cone.HalfAngle) };
    ASSERT_EQ(stored.BaseRadius, written[0]) << i;
    ASSERT_EQ(stored.HalfAngle, written[1]) << i;
  }
}

TEST(ConeProof, SeveralLightsTogether)
{
  const TestMesh cube = Casters()["cube"];
  const std::vector<Light> lights{ LightsAbove()["disc"], SunLight({ 1.0, 0.0, -1.0 }, 0.005), PointLight({ 0.0, 4.0, 0.5 }) };
  ConeProof proof;
  ASSERT_TRUE(ProveConeSet(cube.View(), lights, {}, {}, {}, proof));
  const std::vector<std::vector<Cone>> own = ConesOfLights(proof.Cones, lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    EXPECT_TRUE(IsProved(cube, lights[k], own[k])) << k;
    EXPECT_FALSE(IsProved(cube, lights[k], own[(k + 1) % 3])) << k;
  }
  EXPECT_FALSE(IsProved(cube, PointLight({ 0.0, -4.0, 0.5 }), proof.Cones));
}

TEST(ConeProof, HashKnowsConesCastersAndLights)
{
  TestMesh cube = Casters()["cube"];
  std::vector<Light> lights{ LightsAbove()["disc"] };
  std::vector<Cone> cones{ ConeOfSquare(0.5), ConeOfSquare(0.6) };
  const auto hash = [&]() { return CertificateHash(cones, cube.View(), lights); };
  const std::uint64_t first = hash();
  lights[0].Spectrum.assign(3, 7.0); // dimmed
  std::swap(cube.Triangles[0], cube.Triangles[1]);
  std::swap(cube.Triangles[3], cube.Triangles[0]);
  std::swap(cube.Triangles[4], cube.Triangles[1]);
  std::swap(cube.Triangles[5], cube.Triangles[2]);
  EXPECT_EQ(hash(), first) << "the same triangles in another order";
  cones[1].HalfAngle *= 0.999;
  EXPECT_NE(hash(), first);
  cones[1] = ConeOfSquare(0.6);
  lights[0].Center.X = 0.01;
  EXPECT_NE(hash(), first);
  lights[0].Center.X = 0.0;
  EXPECT_EQ(hash(), first);
  cube.AddSheet({ 5.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, -1);
  EXPECT_EQ(hash(), first) << "a receiver casts nothing";
  cube.OccluderIds.back() = 3;
  EXPECT_NE(hash(), first);
  lights = { LightsAbove()["mesh"] };
  const std::uint64_t faces = hash();
  lights[0].Triangles[1][2].Z += 1e-9;
  EXPECT_NE(hash(), faces) << "a corner of the lamp";
}

TEST(ConeProof, ReceiversCastNothing)
{
  TestMesh room = Square();
  room.AddBox({ -5.0, -5.0, -5.0 }, { 5.0, 5.0, 5.0 }, -1);
  const Light light = PointLight({ 0.0, 0.0, 2.0 });
  const ConeProof proof = Prove(room, light);
  EXPECT_TRUE(IsProved(room, light, proof.Cones));
  for (const Cone& cone : proof.Cones)
  {
    EXPECT_LT(cone.Axis.Z, 0.0);
  }
}

TEST(ConeProof, TheSameForAnyNumberOfThreadsAndStopsWhenAsked)
{
  const TestMesh mesh = Casters()["sphere"];
  const Light light = LightsAbove()["disc"];
  vtkSMPTools::Initialize(1);
  const ConeProof one = Prove(mesh, light);
  vtkSMPTools::Initialize(2);
  const ConeProof two = Prove(mesh, light);
  vtkSMPTools::Initialize(0);
  ASSERT_EQ(one.Cones.size(), two.Cones.size());
  for (std::size_t i = 0; i < one.Cones.size(); ++i)
  {
    EXPECT_EQ(one.Cones[i].Center.X, two.Cones[i].Center.X);
    EXPECT_EQ(one.Cones[i].BaseRadius, two.Cones[i].BaseRadius);
    EXPECT_EQ(one.Cones[i].HalfAngle, two.Cones[i].HalfAngle);
  }
  Monitor monitor;
  monitor.Aborted = []() { return true; };
  ConeProof stopped;
  EXPECT_FALSE(ProveConeSet(mesh.View(), { light }, {}, {}, monitor, stopped));
}
