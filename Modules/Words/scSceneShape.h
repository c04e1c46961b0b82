// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSceneShape.h
 * @brief What a mesh looks like from far: which way is up, is it a room, and where a lamp and a camera suit it. Internal to the module.
 */
#ifndef scSceneShape_h
#define scSceneShape_h

#include "scBox.h"
#include "scLight.h"
#include "scTriangleMesh.h"
#include "scVector3.h"

#include <vector>

namespace shadowcones
{

struct SceneShape
{
  Box Bounds;                     ///< of the mesh; a cube of size 1 where there is none
  int Up = 1;                     ///< the axis, in its positive direction
  bool Room = false;              ///< it has a ceiling, walls and something between them
  bool Open = false;              ///< of a room: one side has no wall
  Vector3 Front{ 0.0, 0.0, 1.0 }; ///< towards whom looks at it: of an open room out of its open side
  double Ceiling = 0.0;           ///< of a room: its lower side, along Up
};

/// @param up axis that is up, or -1: the one that the lights and the mesh's size speak for.
SceneShape LookAtMesh(const TriangleMeshView& mesh, const std::vector<Light>& lights, int up);

struct CameraPlace
{
  Vector3 Position;
  Vector3 FocalPoint;
  Vector3 ViewUp;
  double ViewAngle = 30.0; ///< vertical, degrees
};

/// A disc that suits the mesh.
Light DefaultLamp(const SceneShape& shape);
/// Around the mesh, its lamps where they are near, and the shadow behind it.
Box DefaultMedium(const SceneShape& shape, const std::vector<Light>& lights);
/// @param aspect width over height of the picture.
CameraPlace DefaultCamera(const SceneShape& shape, const std::vector<Light>& lights, double aspect);
/// Scattering coefficient, 1 / world unit, with which shafts are seen and what is behind them too.
double DefaultSigmaS(const Box& medium);

} // namespace shadowcones

#endif
