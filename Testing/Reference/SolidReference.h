// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidReference.h
 * @brief Penumbra and umbra of a scene by random points, and what a closed surface holds: plain, slow, and of nobody's code.
 */
#ifndef SolidReference_h
#define SolidReference_h

#include "scReference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace shadowcones
{

/// Points of a light: so many on its rim at a random turn, and as many inside; unit ways where it is a Sun.
class ReferenceLightPoints
{
public:
  ReferenceLightPoints(const Light& light, int each, std::uint64_t seed)
    : Lamp(light)
    , Each(each)
    , Random(seed)
  {
    const Vector3 helper = std::fabs(light.Normal.X) < 0.7 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
    this->U = Normalized(Cross(light.Normal, helper));
    this->V = Cross(light.Normal, this->U);
  }

  /// Does the place see any of the light, and is any of it hidden?
  std::pair<bool, bool> Look(const ReferenceScene& scene, const Vector3& place)
  {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    bool seen = false;
    bool hidden = false;
    const bool isPoint =
      this->Lamp.Shape == LightShape::Point || (this->Lamp.Shape == LightShape::Sun && this->Lamp.Radius == 0.0);
    const int count = isPoint ? 1 : 2 * this->Each;
    const double turn = uniform(this->Random);
    for (int k = 0; k < count && !(seen && hidden); ++k)
    {
      const double radius = isPoint ? 0.0 : (k < this->Each ? 1.0 : std::sqrt(uniform(this->Random)));
      const double angle = 6.283185307179586 * (k < this->Each ? (k + turn) / this->Each : uniform(this->Random));
      const Vector3 across = radius * (std::cos(angle) * this->U + std::sin(angle) * this->V);
      const bool sun = this->Lamp.Shape == LightShape::Sun;
      const Vector3 to = sun ? std::tan(this->Lamp.Radius) * across - this->Lamp.Normal
                             : this->Lamp.Center + (isPoint ? 0.0 : this->Lamp.Radius) * across - place;
      const bool blocked = scene.Blocked(place, Normalized(to), 0.0, sun ? HUGE_VAL : Length(to));
      seen = seen || !blocked;
      hidden = hidden || blocked;
    }
    return { seen, hidden };
  }

private:
  Light Lamp;
  int Each;
  std::mt19937_64 Random;
  Vector3 U;
  Vector3 V;
};

struct ReferenceVolumes
{
  double Outer = 0.0;
  double Inner = 0.0;
  double OuterError = 0.0; ///< one standard error, of independent points: these are stratified
  double InnerError = 0.0;
};

/// Volumes in a box where not all of the light is seen, and where none of it is: one random point in each of side^3 cells.
inline ReferenceVolumes MeasureShadow(
  const TriangleMeshView& mesh, const Light& light, const Box& bounds, int side, int each, std::uint64_t seed = 1)
{
  const ReferenceScene scene(mesh);
  ReferenceLightPoints points(light, each, seed);
  std::mt19937_64 random(seed + 1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vector3 size = bounds.Size();
  double outer = 0.0;
  double inner = 0.0;
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    const double x = (cell % side + uniform(random)) / side;
    const double y = (cell / side % side + uniform(random)) / side;
    const double z = (cell / side / side + uniform(random)) / side;
    const auto [seen, hidden] = points.Look(scene, bounds.Min + Vector3{ x * size.X, y * size.Y, z * size.Z });
    outer += hidden ? 1.0 : 0.0;
    inner += hidden && !seen ? 1.0 : 0.0;
  }
  const double count = static_cast<double>(side) * side * side;
  const double volume = size.X * size.Y * size.Z;
  const auto error = [&](double hits) { return volume * std::sqrt(hits * (count - hits) / count) / count; };
  return { volume * outer / count, volume * inner / count, error(outer), error(inner) };
}

/// A closed surface of triangles as a body: points inside it are told by how often a line crosses it.
class ReferenceBody
{
public:
  explicit ReferenceBody(const TriangleMeshView& surface)
    : Scene(surface)
  {
  }
  bool Contains(const Vector3& point) const
  {
    const Vector3 way = Normalized({ 0.2718281, 0.5772156, 0.7390851 });
    int crossings = 0;
    for (double at = this->Scene.Nearest(point, way, 0.0, HUGE_VAL); std::isfinite(at) && crossings < 1000; ++crossings)
    {
      at = this->Scene.Nearest(point, way, at * (1.0 + 1e-12) + 1e-12, HUGE_VAL);
    }
    return crossings % 2 == 1;
  }

private:
  ReferenceScene Scene;
};

/// Share of @p count random points of a body that see light.
inline double LitShare(const TriangleMeshView& mesh, const Light& light, const TriangleMeshView& surface,
  const Box& bounds, int count, int each, std::uint64_t seed = 3)
{
  const ReferenceScene scene(mesh);
  const ReferenceBody body(surface);
  ReferenceLightPoints points(light, each, seed);
  std::mt19937_64 random(seed + 1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vector3 size = bounds.Size();
  long long inside = 0;
  long long lit = 0;
  for (long long tries = 0; inside < count && tries < 1000LL * count; ++tries)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    const double z = uniform(random);
    const Vector3 place = bounds.Min + Vector3{ x * size.X, y * size.Y, z * size.Z };
    if (body.Contains(place))
    {
      ++inside;
      lit += points.Look(scene, place).first ? 1 : 0;
    }
  }
  return inside > 0 ? static_cast<double>(lit) / static_cast<double>(inside) : 0.0;
}

} // namespace shadowcones

#endif
