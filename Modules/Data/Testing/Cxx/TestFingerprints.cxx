// SPDX-License-Identifier: BSD-3-Clause
// Fingerprints: what leaves them as they are, what changes them, and what is said where they differ.
#include "scFingerprints.h"

#include "scMeshData.h"

#include "vtkFieldData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

TriangleMesh TwoTriangles()
{
  TriangleMesh mesh;
  mesh.Points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.1 };
  mesh.Triangles = { 0, 1, 2, 1, 3, 2 };
  mesh.OccluderIds = { 0, 1 };
  return mesh;
}

} // namespace

TEST(Fingerprints, AreOfTheSetOfCastingTriangles)
{
  const std::uint64_t own = CastersFingerprintOf(TwoTriangles());
  EXPECT_NE(own, 0u);

  TriangleMesh same = TwoTriangles();
  same.Triangles = { 2, 3, 1, 0, 2, 1, 2, 1, 0 }; // another order, turned, one twice
  same.OccluderIds = { 7, 7, 3 };
  EXPECT_EQ(CastersFingerprintOf(same), own);
  same.OccluderIds.clear();
  EXPECT_EQ(CastersFingerprintOf(same), own) << "without ids all are casters";

  TriangleMesh room = TwoTriangles();
  room.Points.insert(room.Points.end(), { 50, 50, 50 });
  room.Triangles.insert(room.Triangles.end(), { 0, 1, 4, 0, 1, 1 });
  room.OccluderIds = { 0, 1, -1, 0 };
  EXPECT_EQ(CastersFingerprintOf(room), own) << "a receiver, and a triangle without area";
  room.OccluderIds[2] = 0;
  EXPECT_NE(CastersFingerprintOf(room), own);

  TriangleMesh moved = TwoTriangles();
  moved.Points[11] += 1e-15;
  EXPECT_NE(CastersFingerprintOf(moved), own);
  moved = TwoTriangles();
  moved.Points[0] = -0.0;
  EXPECT_EQ(CastersFingerprintOf(moved), own);
  EXPECT_EQ(CastersFingerprintOf(TriangleMesh()), 0u);
}

TEST(Fingerprints, AreComparedWhereBothSay)
{
  vtkNew<vtkFieldData> data;
  const auto compare = [&data](const std::vector<std::uint64_t>& own)
  { return CompareFingerprints(castersFingerprint, data, own, "The cone set", "casters than those of the mesh"); };
  EXPECT_EQ(compare({ 5 }), "") << "it does not say";
  const std::vector<std::uint64_t> wide{ 18446744073709551615u, 9007199254740993u };
  WriteFingerprints(castersFingerprint, wide, data);
  EXPECT_EQ(ReadFingerprints(castersFingerprint, data), wide);
  EXPECT_EQ(compare(wide), "");
  EXPECT_EQ(compare({ wide[0], wide[1] - 1 }),
    "The cone set was made from other casters than those of the mesh: shadows may be missing or out of place. Make it "
    "again from these.");
}
