// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConeAdversary.h
 * @brief A search for a point that is in shadow and outside every cone: what a proved set must not have.
 */
#ifndef ConeAdversary_h
#define ConeAdversary_h

#include "scLightSampling.h"
#include "scReference.h"

#include <algorithm>
#include <random>

namespace shadowcones
{

struct AdversaryResult
{
  long long Outside = 0; ///< points outside every cone that were looked at by rays
  long long Inside = 0;  ///< points that a cone holds
  long long Leaks = 0;   ///< points outside every cone from which a ray to the light is blocked
  Vector3 Leak;          ///< the last of them
};

/**
 * Each try picks a place on an occluder, mostly on an edge, and a point of the light, mostly near its rim, follows that light
 * behind the occluder, steps aside by a small distance, and asks double-precision rays from there whether any light is hidden
 * where no cone is. The first ray grazes, three go anywhere on the light.
 */
class ConeAdversary
{
public:
  ConeAdversary(const TriangleMeshView& mesh, const Light& light, const std::vector<Cone>& cones)
    : Mesh(mesh)
    , Source(light)
    , Cones(cones)
    , Scene(mesh)
  {
    for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
    {
      this->Bounds.Add(mesh.Point(mesh.Triangles[i]));
    }
  }

  AdversaryResult Search(long long tries, std::uint64_t seed) const
  {
    std::mt19937_64 random(seed);
    AdversaryResult result;
    for (long long i = 0; i < tries; ++i)
    {
      this->Try(random, result);
    }
    return result;
  }

private:
  using Random = std::mt19937_64;

  static double Uniform(Random& random) { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  static double NearEnds(Random& random)
  {
    const double u = Uniform(random);
    return random() % 4 == 0 ? u : random() % 2 == 0 ? u * u * u * u : 1.0 - u * u * u * u;
  }

  Vector3 PlaceOnOccluder(Random& random) const
  {
    const auto triangle = static_cast<vtkIdType>(random() % static_cast<std::uint64_t>(this->Mesh.NumberOfTriangles));
    double u = Uniform(random);
    double v = random() % 4 == 0 ? Uniform(random) : 0.0;
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const int first = static_cast<int>(random() % 3);
    const Vector3 a = this->Mesh.Corner(triangle, first);
    return a + u * (this->Mesh.Corner(triangle, (first + 1) % 3) - a) + v * (this->Mesh.Corner(triangle, (first + 2) % 3) - a);
  }

  LightSurfaceSample PlaceOnLight(Random& random) const
  {
    return SampleLightArea(this->Source, std::min(NearEnds(random), 1.0 - 1e-12), std::min(NearEnds(random), 1.0 - 1e-12));
  }

  /// The vector from @p from to the sample, whether it shines there, and how far a ray goes.
  bool Towards(const LightSurfaceSample& sample, const Vector3& from, Vector3& direction, double& end) const
  {
    if (IsAtInfinity(this->Source))
    {
      direction = Normalized(sample.Position);
      end = HUGE_VAL;
      return true;
    }
    const Vector3 to = sample.Position - from;
    const double distance = Length(to);
    direction = (1.0 / distance) * to;
    end = distance * (1.0 - 1e-9);
    const bool everyWay = this->Source.Shape == LightShape::Point ||
      (this->Source.Shape == LightShape::Mesh && this->Source.Triangles.empty());
    return distance > 0.0 && (everyWay || Dot(direction, sample.Normal) < -1e-9);
  }

  void Try(Random& random, AdversaryResult& result) const
  {
    const Vector3 t = this->PlaceOnOccluder(random);
    const LightSurfaceSample y = this->PlaceOnLight(random);
    Vector3 direction;
    double end = 0.0;
    if (!this->Towards(y, t, direction, end))
    {
      return;
    }
    const double size = this->Bounds.Diagonal();
    const double behind = size * std::pow(10.0, -4.0 + 5.0 * Uniform(random));
    const double aside = size * std::pow(10.0, -7.0 + 6.0 * Uniform(random));
    const Vector3 step{ Uniform(random) - 0.5, Uniform(random) - 0.5, Uniform(random) - 0.5 };
    const Vector3 x = t - behind * direction + (random() % 2 == 0 ? aside : 0.0) * step;
    if (std::any_of(this->Cones.begin(), this->Cones.end(),
          [&](const Cone& cone) { return ReferenceConeContains(cone, x, HUGE_VAL); }))
    {
      ++result.Inside;
      return;
    }
    ++result.Outside;
    for (int k = 0; k < 4; ++k)
    {
      if (this->Towards(k == 0 ? y : this->PlaceOnLight(random), x, direction, end) &&
        this->Scene.Blocked(x, direction, 1e-9 * size, end))
      {
        ++result.Leaks;
        result.Leak = x;
        return;
      }
    }
  }

  TriangleMeshView Mesh;
  const Light& Source;
  const std::vector<Cone>& Cones;
  ReferenceScene Scene;
  Box Bounds;
};

} // namespace shadowcones

#endif
