// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidScenes.h
 * @brief Plain occluders under plain lights, whose shadows as solids are compared with the reference.
 */
#ifndef SolidScenes_h
#define SolidScenes_h

#include "TestLights.h"
#include "TestMeshes.h"

#include "scBox.h"

#include <cmath>
#include <string>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// A mesh, a light, and the box in which the solids are compared.
struct SolidScene
{
  std::string Name;
  TestMesh Mesh;
  Light Lamp;
  Box Bounds;
};

/// A flat ring across z of triangles on one side.
inline TestMesh RingMesh(const Vector3& center, double inner, double outer, int corners)
{
  TestMesh mesh;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * Pi * k / corners;
    mesh.AddPoint(center + Vector3{ inner * std::cos(angle), inner * std::sin(angle), 0.0 });
    mesh.AddPoint(center + Vector3{ outer * std::cos(angle), outer * std::sin(angle), 0.0 });
  }
  for (int k = 0; k < corners; ++k)
  {
    const vtkIdType a = 2 * k;
    const vtkIdType b = 2 * ((k + 1) % corners);
    mesh.AddTriangle(a, a + 1, b + 1, 0);
    mesh.AddTriangle(a, b + 1, b, 0);
  }
  return mesh;
}

/// "house", "plate", "ring" or "sphere" under "sun", "disc" or "point".
inline SolidScene MakeSolidScene(const std::string& occluder, const std::string& light)
{
  SolidScene scene;
  scene.Name = occluder + " " + light;
  const Vector3 down = Normalized({ 0.3, 0.2, -1.0 });
  if (occluder == "house")
  {
    // Ten by ten and twenty high; what lies behind its far wall and no higher than its roof.
    scene.Mesh.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 10.0, 20.0 });
    scene.Bounds = { { 10.0, -5.0, 0.0 }, { 45.0, 15.0, 20.0 } };
    scene.Lamp = light == "sun" ? SunLight(Normalized({ 1.0, 0.0, -1.0 }), 0.5 * 0.533 * Pi / 180.0)
      : light == "disc"         ? DiscLight({ -30.0, 4.0, 50.0 }, Normalized({ 1.0, 0.0, -1.0 }), 1.0)
                                : PointLight({ -30.0, 4.0, 50.0 });
    return scene;
  }
  if (occluder == "plate")
  {
    scene.Mesh.AddSheet({ -1.0, -0.7, 2.0 }, { 2.0, 0.0, 0.2 }, { 0.0, 1.4, 0.0 });
  }
  else if (occluder == "ring")
  {
    scene.Mesh = RingMesh({ 0.0, 0.0, 2.0 }, 0.6, 1.2, 96);
  }
  else
  {
    scene.Mesh.AddSphere({ 0.0, 0.0, 2.0 }, 1.0, 48);
  }
  scene.Bounds = { { -3.0, -3.0, -1.0 }, { 3.5, 3.0, 3.5 } };
  scene.Lamp = light == "sun" ? SunLight(down, 0.04)
    : light == "disc"         ? DiscLight({ -1.0, -0.8, 6.0 }, Normalized({ 0.2, 0.2, -1.0 }), 0.3)
                              : PointLight({ -1.0, -0.8, 6.0 });
  return scene;
}

inline std::vector<SolidScene> AllSolidScenes()
{
  std::vector<SolidScene> scenes;
  for (const char* occluder : { "house", "plate", "ring", "sphere" })
  {
    for (const char* light : { "sun", "disc", "point" })
    {
      scenes.push_back(MakeSolidScene(occluder, light));
    }
  }
  return scenes;
}

} // namespace testsupport
} // namespace shadowcones

#endif
