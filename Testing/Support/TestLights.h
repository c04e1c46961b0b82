// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLights.h
 * @brief Prepared lights of every shape.
 */
#ifndef TestLights_h
#define TestLights_h

#include "scLight.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// The light after PrepareLight, with seven wavelengths of 1 where it has none.
inline Light Prepared(Light light)
{
  if (light.Spectrum.empty())
  {
    light.Spectrum.assign(7, 1.0);
  }
  const char* fault = PrepareLight(light);
  EXPECT_EQ(fault, nullptr) << fault;
  return light;
}

/// Any shape that a centre, a normal and a radius make.
inline Light MakeLight(
  LightShape shape, const Vector3& center, const Vector3& normal, double radius, std::vector<double> spectrum = {})
{
  Light light;
  light.Shape = shape;
  light.Center = center;
  light.Normal = normal;
  light.Radius = radius;
  light.Spectrum = std::move(spectrum);
  return Prepared(std::move(light));
}

inline Light DiscLight(const Vector3& center, const Vector3& normal, double radius, std::vector<double> spectrum = {})
{
  return MakeLight(LightShape::Disc, center, normal, radius, std::move(spectrum));
}

inline Light PointLight(const Vector3& center, std::vector<double> spectrum = {})
{
  return MakeLight(LightShape::Point, center, { 0.0, 0.0, 1.0 }, 0.0, std::move(spectrum));
}

inline Light SphereLight(const Vector3& center, double radius, std::vector<double> spectrum = {})
{
  return MakeLight(LightShape::Sphere, center, { 0.0, 0.0, 1.0 }, radius, std::move(spectrum));
}

inline Light SunLight(const Vector3& travels, double angularRadius, std::vector<double> spectrum = {})
{
  return MakeLight(LightShape::Sun, {}, travels, angularRadius, std::move(spectrum));
}

/// @param u, v half edges; the normal is u x v.
inline Light RectangleLight(
  const Vector3& center, const Vector3& u, const Vector3& v, std::vector<double> spectrum = {})
{
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = center;
  light.AxisU = u;
  light.AxisV = v;
  light.Normal = Normalized(Cross(u, v));
  light.Spectrum = std::move(spectrum);
  return Prepared(std::move(light));
}

} // namespace testsupport
} // namespace shadowcones

#endif
