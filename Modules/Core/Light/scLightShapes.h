// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightShapes.h
 * @brief The shapes of light, and what each of them must give. Internal to Core.
 */
#ifndef scLightShapes_h
#define scLightShapes_h

#include "scDiscShape.h"
#include "scMeshShape.h"
#include "scPointShape.h"
#include "scRectangleShape.h"
#include "scSphereShape.h"
#include "scSunShape.h"

namespace shadowcones
{

/**
 * Call visit(Shape()) with the functions of the light's shape: chosen once a call, nothing virtual.
 *
 * A new shape takes a value of LightShape (scLight.h), a line here, and a file like scDiscShape.h with a struct of static
 * functions:
 * - Prepare(light): make its values ready. nullptr, or what is wrong with them;
 * - AddTo(fingerprint, light): what it uses of place, direction and size;
 * - Area(light), BoundingSphere(light, center, radius), Hull(light), Face(light): see LightArea, LightBoundingSphere,
 *   LightHull and FlatFaceOf;
 * - SampleArea(light, u, v), InvertArea(light, position): see SampleLightArea;
 * - SampleSolidAngle(light, from, u, v), SolidAnglePdf(light, from, direction), InvertSolidAngle(light, from, direction),
 *   SolidAngle(light, from): see SampleLightSolidAngle;
 * - SampleIncident(light, from, u, v, sampling): see SampleIncidentLight;
 * - SampleVisible(light, from, u, v): a direction for the visible fraction of the light, see SampleVisibleLight.
 *
 * Beyond sampling a shape is asked for in these places, whose switches have a case for each: WholeFluence and
 * WholeIrradiance (closed forms), LightRule (quadrature),
 * LightPatterns (what a probe sees), VisibleLight (what the camera sees), LightPartsOf and CheckConeProof (proofs),
 * MisfitOf (a mesh that goes with it), and ReadLight of the module Data.
 */
template <typename Visitor>
auto VisitShape(const Light& light, Visitor&& visit)
{
  switch (light.Shape)
  {
    case LightShape::Disc:
      return visit(DiscShape());
    case LightShape::Rectangle:
      return visit(RectangleShape());
    case LightShape::Sphere:
      return visit(SphereShape());
    case LightShape::Sun:
      return visit(SunShape());
    case LightShape::Mesh:
      return light.Triangles.empty() ? visit(PointShape()) : visit(MeshShape());
    case LightShape::Point:
      break;
  }
  return visit(PointShape());
}

} // namespace shadowcones

#endif
