// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPointShape.h
 * @brief The functions of points without extent: a point, or the vertices of a mesh without faces. See scLightShapes.h. Internal to Core.
 */
#ifndef scPointShape_h
#define scPointShape_h

#include "scBox.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scShapeParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shadowcones
{

struct PointShape
{
  static const char* Prepare(Light& light)
  {
    if (light.Shape == LightShape::Point)
    {
      return CheckLightCenter(light);
    }
    light.CumulativeArea.clear();
    for (const Vector3& vertex : light.Vertices)
    {
      if (!IsFinite(vertex))
      {
        return "A vertex of the light is not finite.";
      }
    }
    return light.Vertices.empty() ? "The light has neither polygons nor vertices." : nullptr;
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    for (std::size_t i = 0; i < Count(light); ++i)
    {
      AddVector(fingerprint, At(light, i));
    }
  }

  static double Area(const Light&) { return 0.0; }

  static void BoundingSphere(const Light& light, Vector3& center, double& radius)
  {
    Box box;
    for (const Vector3& vertex : light.Vertices)
    {
      box.Add(vertex);
    }
    const bool isPoint = light.Shape == LightShape::Point;
    center = isPoint ? light.Center : (box.Empty() ? Vector3{} : box.Center());
    radius = isPoint ? 0.0 : 0.5 * box.Diagonal();
  }

  /// Of many vertices the sphere around them will do.
  static std::vector<Vector3> Hull(const Light& light)
  {
    constexpr std::size_t mostPoints = 256;
    return light.Shape == LightShape::Mesh && light.Vertices.size() <= mostPoints ? light.Vertices
                                                                                  : std::vector<Vector3>{};
  }

  static FlatFace Face(const Light&) { return {}; }

  static LightSurfaceSample SampleArea(const Light& light, double u, double)
  {
    return { At(light, IndexAt(light, u)), light.Normal, 1.0 / static_cast<double>(Count(light)) };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    std::size_t best = 0;
    for (std::size_t i = 1; i < Count(light); ++i)
    {
      best = Length(At(light, i) - position) < Length(At(light, best) - position) ? i : best;
    }
    return MiddleOf(light, best);
  }

  /// Pdf is the probability of the point.
  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3& from, double u, double)
  {
    const Vector3 to = At(light, IndexAt(light, u)) - from;
    const double distance = Length(to);
    const double pdf = distance > 0.0 ? 1.0 / static_cast<double>(Count(light)) : 0.0;
    return { distance > 0.0 ? (1.0 / distance) * to : light.Normal, distance, pdf };
  }

  static double SolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
  {
    std::size_t found = 0;
    for (std::size_t i = 0; i < Count(light); ++i)
    {
      found += SameDirection(Normalized(At(light, i) - from), direction) ? 1 : 0;
    }
    return static_cast<double>(found) / static_cast<double>(Count(light));
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
  {
    std::size_t best = 0;
    double bestDifference = HUGE_VAL;
    for (std::size_t i = 0; i < Count(light); ++i)
    {
      const double difference = Length(Normalized(At(light, i) - from) - direction);
      best = difference < bestDifference ? i : best;
      bestDifference = std::min(difference, bestDifference);
    }
    return MiddleOf(light, best);
  }

  static double SolidAngle(const Light&, const Vector3&) { return 0.0; }

  /// Its spectrum is an intensity.
  static IncidentSample SampleIncident(const Light& light, const Vector3& from, double u, double v, LightSampling)
  {
    const LightDirectionSample sample = SampleSolidAngle(light, from, u, v);
    return { sample.Direction, sample.Distance, sample.Pdf > 0.0 ? 1.0 / (sample.Pdf * Square(sample.Distance)) : 0.0 };
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return SampleSolidAngle(light, from, u, v);
  }

private:
  static std::size_t Count(const Light& light) { return light.Shape == LightShape::Mesh ? light.Vertices.size() : 1; }
  static const Vector3& At(const Light& light, std::size_t index)
  {
    return light.Shape == LightShape::Mesh ? light.Vertices[index] : light.Center;
  }
  static std::size_t IndexAt(const Light& light, double u)
  {
    const std::size_t count = Count(light);
    return std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
  }
  static std::array<double, 2> MiddleOf(const Light& light, std::size_t index)
  {
    return { (static_cast<double>(index) + 0.5) / static_cast<double>(Count(light)), 0.5 };
  }
};

} // namespace shadowcones

#endif
