// SPDX-License-Identifier: BSD-3-Clause
#include "scLightSampling.h"

#include "scLightShapes.h"

namespace shadowcones
{

LightSurfaceSample SampleLightArea(const Light& light, double u, double v)
{
  return VisitShape(light, [&](auto shape) { return shape.SampleArea(light, u, v); });
}

std::array<double, 2> InvertLightArea(const Light& light, const Vector3& position)
{
  return VisitShape(light, [&](auto shape) { return shape.InvertArea(light, position); });
}

LightDirectionSample SampleLightSolidAngle(const Light& light, const Vector3& from, double u, double v)
{
  return VisitShape(light, [&](auto shape) { return shape.SampleSolidAngle(light, from, u, v); });
}

double LightSolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
{
  return VisitShape(light, [&](auto shape) { return shape.SolidAnglePdf(light, from, direction); });
}

std::array<double, 2> InvertLightSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
{
  return VisitShape(light, [&](auto shape) { return shape.InvertSolidAngle(light, from, direction); });
}

double LightSolidAngle(const Light& light, const Vector3& from)
{
  return VisitShape(light, [&](auto shape) { return shape.SolidAngle(light, from); });
}

IncidentSample SampleIncidentLight(const Light& light, const Vector3& from, double u, double v, LightSampling sampling)
{
  return VisitShape(light, [&](auto shape) { return shape.SampleIncident(light, from, u, v, sampling); });
}

IncidentSample SampleVisibleLight(const Light& light, const Vector3& from, double u, double v)
{
  const LightDirectionSample sample =
    VisitShape(light, [&](auto shape) { return shape.SampleVisible(light, from, u, v); });
  return { sample.Direction, sample.Distance, sample.Pdf > 0.0 ? 1.0 : 0.0 };
}

} // namespace shadowcones
