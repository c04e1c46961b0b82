// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RoomTestScene.h
 * @brief A mesh of Data/ in the foggy room, with cones that bound its shadow.
 */
#ifndef RoomTestScene_h
#define RoomTestScene_h

#include "Chain.h"
#include "Room.h"
#include "Scenes.h"
#include "TestPolyData.h"

#include "scMeshData.h"

#include <string>

namespace shadowcones
{
namespace testsupport
{

/// "chair", "tree" or "blob".
inline TriangleMesh RoomMesh(const std::string& name)
{
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(ReadData(name + ".vtp"), mesh, error)) << error;
  return mesh;
}

/// Under the lamp of the room.
inline ImageTestScene RoomTestScene(const std::string& name)
{
  const TriangleMesh mesh = RoomMesh(name);
  ImageTestScene scene;
  scene.Mesh.Points = mesh.Points;
  scene.Mesh.Triangles = mesh.Triangles;
  scene.Source = RoomLight({ 1.0 });
  scene.Fog = RoomMedium(1, 0.05);
  scene.Eye = RoomCamera();
  scene.Bounds = Lengthened(BoundingCones(OccluderScene(scene.Mesh.View()), scene.Source));
  return scene;
}

} // namespace testsupport
} // namespace shadowcones

#endif
