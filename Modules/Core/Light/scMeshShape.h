// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshShape.h
 * @brief The functions of the faces of a mesh: see scLightShapes.h. Internal to Core.
 */
#ifndef scMeshShape_h
#define scMeshShape_h

#include "scBox.h"
#include "scConcentricMap.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scShapeParts.h"
#include "scSphericalRectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace shadowcones
{

struct MeshShape
{
  using Triangle = std::array<Vector3, 3>;

  static const char* Prepare(Light& light)
  {
    light.CumulativeArea.clear();
    light.CumulativeArea.reserve(light.Triangles.size());
    double total = 0.0;
    for (const Triangle& t : light.Triangles)
    {
      const double area = 0.5 * Length(NormalOf(t));
      if (!std::isfinite(area))
      {
        return "A point of the light's mesh is not finite.";
      }
      total += area;
      light.CumulativeArea.push_back(total);
    }
    return total > 0.0 ? nullptr : "The light's mesh has zero area.";
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    for (const Triangle& t : light.Triangles)
    {
      for (const Vector3& corner : t)
      {
        AddVector(fingerprint, corner);
      }
    }
    for (const Vector3& vertex : light.Vertices)
    {
      AddVector(fingerprint, vertex);
    }
  }

  static double Area(const Light& light) { return light.CumulativeArea.empty() ? 0.0 : light.CumulativeArea.back(); }

  static void BoundingSphere(const Light& light, Vector3& center, double& radius)
  {
    Box box;
    for (const Triangle& t : light.Triangles)
    {
      for (const Vector3& corner : t)
      {
        box.Add(corner);
      }
    }
    center = box.Empty() ? Vector3{} : box.Center();
    radius = 0.5 * box.Diagonal();
  }

  /// Of many corners the sphere around them will do.
  static std::vector<Vector3> Hull(const Light& light)
  {
    constexpr std::size_t mostPoints = 256;
    std::vector<Vector3> points;
    if (3 * light.Triangles.size() <= 16 * mostPoints) // a corner is of some six triangles
    {
      points = DistinctCorners(light);
    }
    return points.size() <= mostPoints ? points : std::vector<Vector3>();
  }

  /// The corners, each once, in the order in which triangles first name them.
  static std::vector<Vector3> DistinctCorners(const Light& light)
  {
    std::vector<Vector3> points;
    std::set<std::array<double, 3>> known;
    for (const Triangle& t : light.Triangles)
    {
      std::copy_if(t.begin(), t.end(), std::back_inserter(points),
        [&known](const Vector3& p) { return known.insert({ p.X, p.Y, p.Z }).second; });
    }
    return points;
  }

  /// Flat where all triangles face the same way in one plane.
  static FlatFace Face(const Light& light)
  {
    FlatFace face;
    BoundingSphere(light, face.Center, face.Radius);
    Vector3 sum;
    double area = 0.0;
    for (const Triangle& t : light.Triangles)
    {
      const Vector3 normal = NormalOf(t);
      sum += normal;
      area += Length(normal);
    }
    // Triangles that face other ways take from the sum.
    if (!(Length(sum) > 0.999 * area))
    {
      return face;
    }
    face.Normal = Normalized(sum);
    const Vector3 corner = light.Triangles[0][0];
    face.Center = face.Center - Dot(face.Center - corner, face.Normal) * face.Normal;
    const auto isNear = [&face](const Vector3& p)
    { return std::fabs(Dot(p - face.Center, face.Normal)) <= 2.0 * FlushTolerance(face, p); };
    face.IsFlat = std::all_of(light.Triangles.begin(), light.Triangles.end(),
      [&isNear](const Triangle& t) { return std::all_of(t.begin(), t.end(), isNear); });
    return face;
  }

  static LightSurfaceSample SampleArea(const Light& light, double u, double v)
  {
    const double total = light.CumulativeArea.back();
    const double target = u * total;
    // The first running sum beyond the target: never a face without an area.
    const auto found = std::upper_bound(light.CumulativeArea.begin(), light.CumulativeArea.end() - 1, target);
    const std::size_t index = static_cast<std::size_t>(found - light.CumulativeArea.begin());
    const double before = index > 0 ? light.CumulativeArea[index - 1] : 0.0;
    const double fraction = (target - before) / (light.CumulativeArea[index] - before);
    const double root = std::sqrt(std::clamp(fraction, 0.0, 1.0));
    const Triangle& t = light.Triangles[index];
    return { t[0] + (root * (1.0 - v)) * (t[1] - t[0]) + (root * v) * (t[2] - t[0]), Normalized(NormalOf(t)),
      1.0 / total };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    double best = HUGE_VAL;
    std::array<double, 2> result{ 0.5, 0.5 };
    for (std::size_t i = 0; i < light.Triangles.size(); ++i)
    {
      double b1 = 0.0;
      double b2 = 0.0;
      const Triangle& t = light.Triangles[i];
      if (!Barycentric(t, position, b1, b2))
      {
        continue;
      }
      b1 = std::max(b1, 0.0);
      b2 = std::max(b2, 0.0);
      const double sum = b1 + b2;
      b1 = sum > 1.0 ? b1 / sum : b1;
      b2 = sum > 1.0 ? b2 / sum : b2;
      const double distance = Length(t[0] + b1 * (t[1] - t[0]) + b2 * (t[2] - t[0]) - position);
      if (distance < best)
      {
        best = distance;
        const double root = std::min(sum, 1.0);
        const double before = i > 0 ? light.CumulativeArea[i - 1] : 0.0;
        const double area = light.CumulativeArea[i] - before;
        result = { UnitInterval((before + root * root * area) / light.CumulativeArea.back()),
          root > 0.0 ? UnitInterval(b2 / (b1 + b2)) : 0.5 };
      }
    }
    return result;
  }

  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3& from, double u, double v)
  {
    return DirectionOf(SampleArea(light, u, v), from);
  }

  /// A direction that meets several faces is drawn from each of them.
  static double SolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
  {
    double distance = 0.0;
    double cosine = 0.0;
    double sum = 0.0;
    for (const Triangle& t : light.Triangles)
    {
      sum += HitFace(t, from, direction, distance, cosine) ? Square(distance) / cosine : 0.0;
    }
    return sum / Area(light);
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
  {
    double distance = 0.0;
    double cosine = 0.0;
    double nearest = HUGE_VAL;
    for (const Triangle& t : light.Triangles)
    {
      if (HitFace(t, from, direction, distance, cosine))
      {
        nearest = std::min(nearest, distance);
      }
    }
    return std::isfinite(nearest) ? InvertArea(light, from + nearest * direction) : std::array<double, 2>{ 0.5, 0.5 };
  }

  static double SolidAngle(const Light& light, const Vector3& from)
  {
    double sum = 0.0;
    for (const Triangle& t : light.Triangles)
    {
      const double volume = Dot(from - t[0], NormalOf(t));
      sum += volume > 0.0 ? TriangleSolidAngle(volume, t[0] - from, t[1] - from, t[2] - from) : 0.0;
    }
    return sum;
  }

  static IncidentSample SampleIncident(const Light& light, const Vector3& from, double u, double v, LightSampling)
  {
    return IncidentOf(SampleSolidAngle(light, from, u, v));
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return SampleSolidAngle(light, from, u, v);
  }

private:
  /// Twice the area long.
  static Vector3 NormalOf(const Triangle& t) { return Cross(t[1] - t[0], t[2] - t[0]); }

  /// Barycentric coordinates of the projection onto the triangle's plane.
  static bool Barycentric(const Triangle& t, const Vector3& position, double& b1, double& b2)
  {
    const Vector3 normal = NormalOf(t);
    const double squared = Dot(normal, normal);
    if (!(squared > 0.0))
    {
      return false;
    }
    const Vector3 offset = position - t[0];
    b1 = Dot(Cross(offset, t[2] - t[0]), normal) / squared;
    b2 = Dot(Cross(t[1] - t[0], offset), normal) / squared;
    return true;
  }

  /// Where a ray meets a face that faces it.
  static bool HitFace(
    const Triangle& t, const Vector3& from, const Vector3& direction, double& distance, double& cosine)
  {
    const Vector3 normal = Normalized(NormalOf(t));
    cosine = -Dot(direction, normal);
    if (!(cosine > 0.0))
    {
      return false;
    }
    distance = Dot(from - t[0], normal) / cosine;
    double b1 = 0.0;
    double b2 = 0.0;
    constexpr double tolerance = 1e-9;
    return distance > 0.0 && Barycentric(t, from + distance * direction, b1, b2) && b1 >= -tolerance &&
      b2 >= -tolerance && b1 + b2 <= 1.0 + tolerance;
  }
};

} // namespace shadowcones

#endif
