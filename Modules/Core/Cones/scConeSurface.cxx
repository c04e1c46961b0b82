// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSurface.h"

#include "scConstants.h"
#include "scFrame.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// How far a generator runs, in units of height above the base.
double CutHeight(const ConeCut& cut, const Vector3& start, const Vector3& perHeight)
{
  double height = cut.Length;
  if (cut.Where == ConeCut::Kind::Plane)
  {
    const double distance = Dot(cut.PlaneOrigin - start, cut.PlaneNormal);
    const double slope = Dot(perHeight, cut.PlaneNormal);
    const double hit = slope != 0.0 ? distance / slope : HUGE_VAL;
    // A generator that runs away from the plane ends by length alone.
    return hit < 0.0 ? height : std::min(height, hit);
  }
  if (cut.Where == ConeCut::Kind::Box)
  {
    double low = 0.0;
    return cut.Bounds.Contains(start) && cut.Bounds.Clip(start, perHeight, low, height) ? height : 0.0;
  }
  return height;
}
} // anonymous namespace

void ConeGenerators(const Cone& cone, double halfAngle, int resolution, const ConeCut& cut,
  std::vector<ConeGenerator>& generators)
{
  generators.clear();
  const Frame frame = FrameAround(cone.Axis);
  const double tangent = std::tan(halfAngle);
  const double tip = TipHeight(cone.BaseRadius, tangent);
  for (int i = 0; i < resolution; ++i)
  {
    const double angle = 2.0 * Pi * i / resolution;
    const Vector3 radial = std::cos(angle) * frame.U + std::sin(angle) * frame.V;
    const Vector3 perHeight = cone.Axis + tangent * radial;
    ConeGenerator generator;
    generator.Base = cone.Center + cone.BaseRadius * radial;
    generator.End = generator.Base + std::min(tip, CutHeight(cut, generator.Base, perHeight)) * perHeight;
    generator.Normal = std::cos(halfAngle) * radial - std::sin(halfAngle) * cone.Axis;
    generators.push_back(generator);
  }
}

} // namespace shadowcones
