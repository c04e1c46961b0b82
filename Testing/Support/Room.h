// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Room.h
 * @brief The room of the examples: its bounds, the lamp on its ceiling, its fog, and the camera in front of it.
 */
#ifndef Room_h
#define Room_h

#include "scCamera.h"
#include "scLight.h"
#include "scMedium.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// x and z in +-2.75, y in 0..5.2: below the lamp.
inline Box RoomBounds()
{
  return { { -2.75, 0.0, -2.75 }, { 2.75, 5.2, 2.75 } };
}

/// A disc on the ceiling that faces down.
struct RoomLamp
{
  Vector3 Center{ 0.0, 5.49, 0.0 };
  double Radius = 0.5;
};

inline Light RoomLight(std::vector<double> spectrum, const RoomLamp& lamp = {})
{
  Light light;
  light.Shape = LightShape::Disc;
  light.Center = lamp.Center;
  light.Normal = { 0.0, -1.0, 0.0 };
  light.Radius = lamp.Radius;
  light.Spectrum = std::move(spectrum);
  PrepareLight(light);
  return light;
}

/// Isotropic, SigmaS 0.12, in RoomBounds().
inline Medium RoomMedium(std::size_t wavelengths, double sigmaA = 0.0)
{
  Medium medium;
  medium.SigmaS.assign(wavelengths, 0.12);
  medium.SigmaA.assign(wavelengths, sigmaA);
  medium.Bounds = RoomBounds();
  return medium;
}

inline Camera RoomCamera()
{
  Camera camera;
  camera.Position = { 0.0, 2.65, 10.0 };
  camera.HalfHeight = 0.37;
  return camera;
}

} // namespace testsupport
} // namespace shadowcones

#endif
