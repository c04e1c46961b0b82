// SPDX-License-Identifier: BSD-3-Clause
#include "scConeProofCheck.h"

#include "scLampPlane.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace shadowcones
{
namespace
{
using Points = std::vector<Vector3>;
constexpr int rimPoints = 64;
constexpr double shortestEdge = 1.0 / 16384.0; ///< of the mesh's diagonal

/// A face of the light, or all of it: the hull of points, with a ball around each of them.
struct Hull
{
  Points Extremes;
  double Ball = 0.0; ///< a sphere's radius
  bool Flat = false; ///< shines to one side
  Vector3 Normal;
};

Points Rim(const Light& light)
{
  const Vector3 helper = std::abs(light.Normal.X) < 0.5 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
  const Vector3 u = Normalized(Cross(light.Normal, helper));
  const Vector3 v = Cross(light.Normal, u);
  const double step = 2.0 * std::acos(-1.0) / rimPoints;
  const double radius = light.Radius / std::cos(0.5 * step);
  Points rim;
  for (int i = 0; i < rimPoints; ++i)
  {
    rim.push_back(light.Center + radius * (std::cos(i * step) * u + std::sin(i * step) * v));
  }
  return rim;
}

/// The whole light first, then its faces where it has several.
std::vector<Hull> HullsOf(const Light& light)
{
  Hull whole{ { light.Center }, 0.0, false, light.Normal };
  std::vector<Hull> faces;
  whole.Ball = light.Shape == LightShape::Sphere ? light.Radius : 0.0;
  whole.Flat = light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle;
  if (light.Shape == LightShape::Disc)
  {
    whole.Extremes = Rim(light);
  }
  if (light.Shape == LightShape::Rectangle)
  {
    const Vector3 u = light.AxisU;
    const Vector3 v = light.AxisV;
    whole.Extremes = { light.Center + u + v, light.Center + u - v, light.Center - u + v, light.Center - u - v };
  }
  if (light.Shape == LightShape::Mesh)
  {
    whole.Extremes = light.Triangles.empty() ? light.Vertices : Points();
    for (const auto& t : light.Triangles)
    {
      whole.Extremes.insert(whole.Extremes.end(), t.begin(), t.end());
      faces.push_back({ { t[0], t[1], t[2] }, 0.0, true, Normalized(Cross(t[1] - t[0], t[2] - t[0])) });
    }
    for (std::size_t i = 0; light.Triangles.empty() && i < light.Vertices.size(); ++i)
    {
      faces.push_back({ { light.Vertices[i] }, 0.0, false, {} });
    }
  }
  faces.insert(faces.begin(), whole);
  return faces;
}

Box CastersBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    if (mesh.OccluderId(i / 3) >= 0)
    {
      bounds.Add(mesh.Corner(i / 3, static_cast<int>(i % 3)));
    }
  }
  return bounds;
}

class Checker
{
public:
  /// @param casters the bounds of the casting triangles
  Checker(const Box& casters, const Light& light, const std::vector<Cone>& cones)
    : Lamp(light)
    , Cones(cones)
    , Hulls(HullsOf(light))
    , Middle(casters.Empty() ? Vector3{} : casters.Center())
    , Diagonal(casters.Diagonal())
  {
  }

  ConeProofCheck Answer;

  /// Every point of the part has shadow in a cone, of the light of hull @p h (0: all of the light).
  bool PartIsHeld(const std::array<Vector3, 3>& part, std::size_t h)
  {
    ++this->Answer.NumberOfPairs;
    const Points lit = this->LitOf(part, this->Hulls[h]);
    if (lit.empty() || this->OneConeHolds(lit, this->Hulls[h]))
    {
      return true;
    }
    if (h == 0 && this->Hulls.size() > 1)
    {
      for (std::size_t face = 1; face < this->Hulls.size(); ++face)
      {
        if (!this->PartIsHeld(part, face))
        {
          return false;
        }
      }
      return true;
    }
    const std::array<Vector3, 3> edges{ part[1] - part[0], part[2] - part[1], part[0] - part[2] };
    std::size_t e = 0;
    for (std::size_t i = 1; i < 3; ++i)
    {
      e = Dot(edges[i], edges[i]) > Dot(edges[e], edges[e]) ? i : e;
    }
    if (Length(edges[e]) < shortestEdge * this->Diagonal)
    {
      this->Answer.LightFace = static_cast<int>(h) - 1;
      this->Answer.Part = part;
      return false;
    }
    const Vector3 middle = 0.5 * (part[e] + part[(e + 1) % 3]);
    std::array<Vector3, 3> first = part;
    std::array<Vector3, 3> second = part;
    first[(e + 1) % 3] = middle;
    second[e] = middle;
    return this->PartIsHeld(first, h) && this->PartIsHeld(second, h);
  }

private:
  /// Corners of what the light shines on; all of a part that is not cut by a plane.
  Points LitOf(const std::array<Vector3, 3>& part, const Hull& hull) const
  {
    Points lit;
    if (hull.Ball > 0.0 && std::all_of(part.begin(), part.end(), [&](const Vector3& p) {
          return Length(p - hull.Extremes[0]) <= hull.Ball;
        }))
    {
      return lit;
    }
    const auto height = [&](const Vector3& p) {
      return hull.Flat ? Dot(p - hull.Extremes[0], hull.Normal) : 1.0;
    };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& a = part[i];
      const Vector3& b = part[(i + 1) % 3];
      if (height(a) > 0.0)
      {
        lit.push_back(a);
      }
      if (height(a) * height(b) < 0.0)
      {
        lit.push_back(a + height(a) / (height(a) - height(b)) * (b - a));
      }
    }
    return lit;
  }

  bool OneConeHolds(const Points& lit, const Hull& hull)
  {
    const auto holds = [&](const Cone& cone) {
      return std::all_of(lit.begin(), lit.end(), [&](const Vector3& t) { return this->Holds(cone, t, hull); });
    };
    // The cone that held the last part comes first.
    if (this->Last < this->Cones.size() && holds(this->Cones[this->Last]))
    {
      return true;
    }
    const auto found = std::find_if(this->Cones.begin(), this->Cones.end(), holds);
    this->Last = static_cast<std::size_t>(found - this->Cones.begin());
    return found != this->Cones.end();
  }

  /// Does the cone hold the point t, and t + s (t - y) for all y of the hull and s >= 0, each with the margin of the place?
  bool Holds(const Cone& cone, const Vector3& t, const Hull& hull) const
  {
    const Vector3 place = t - this->Middle;
    const double margin = 0.999 * (1.5e-7 * this->Diagonal +
      5e-7 * std::max(std::abs(place.X), std::max(std::abs(place.Y), std::abs(place.Z))));
    const double sine = std::sin(cone.HalfAngle);
    const double cosine = std::cos(cone.HalfAngle);
    // How far a vector reaches into the cone of directions around the axis.
    const auto depth = [&](const Vector3& v) { return Dot(v, cone.Axis) * sine - Length(Cross(v, cone.Axis)) * cosine; };
    const Vector3 offset = t - cone.Center;
    if (!(cone.HalfAngle >= 0.0) || Dot(offset, cone.Axis) < margin ||
      depth(offset) + cone.BaseRadius * cosine < margin)
    {
      return false;
    }
    if (this->Lamp.Shape == LightShape::Sun)
    {
      const double turned = std::atan2(Length(Cross(hull.Normal, cone.Axis)), Dot(hull.Normal, cone.Axis));
      return turned + this->Lamp.Radius + 0.999e-6 <= cone.HalfAngle;
    }
    return std::all_of(hull.Extremes.begin(), hull.Extremes.end(),
      [&](const Vector3& y) { return depth(t - y) - hull.Ball >= margin; });
  }

  const Light& Lamp;
  const std::vector<Cone>& Cones;
  std::vector<Hull> Hulls;
  Vector3 Middle;
  double Diagonal;
  std::size_t Last = 0;
};

/// Does one cone hold a box, which it does where it holds its corners?
bool BoxIsHeld(const Box& box, const TriangleMeshView& mesh, const std::vector<Cone>& cones)
{
  const Box casters = CastersBounds(mesh);
  return box.Contains(casters.Min) && box.Contains(casters.Max) &&
    std::any_of(cones.begin(), cones.end(), [&box](const Cone& cone) {
      bool held = cone.HalfAngle >= 0.0;
      for (int i = 0; i < 8; ++i)
      {
        const Vector3 p{ i & 1 ? box.Max.X : box.Min.X, i & 2 ? box.Max.Y : box.Min.Y, i & 4 ? box.Max.Z : box.Min.Z };
        const double height = Dot(p - cone.Center, cone.Axis);
        const double across = Length(Cross(p - cone.Center, cone.Axis));
        held = held && height >= 0.0 && across <= cone.BaseRadius + height * std::tan(cone.HalfAngle);
      }
      return held;
    });
}
} // anonymous namespace

bool CheckConeProof(const TriangleMeshView& mesh, const Light& light, const std::vector<Cone>& cones, const Box& heldBox,
  const Monitor& monitor, ConeProofCheck& check)
{
  check = {};
  if (!heldBox.Empty())
  {
    check.Proved = BoxIsHeld(heldBox, mesh, cones);
    return true;
  }
  const FlatFace face = FlatFaceOf(light); // what the ray engine passes by
  const Box casters = CastersBounds(mesh);
  constexpr vtkIdType chunk = 64;
  const vtkIdType chunks = (mesh.NumberOfTriangles + chunk - 1) / chunk;
  std::vector<ConeProofCheck> answers(static_cast<std::size_t>(chunks));
  std::atomic<vtkIdType> firstFault{ std::numeric_limits<vtkIdType>::max() };
  const bool finished = ParallelFor(chunks, monitor, [&](vtkIdType first, vtkIdType last) {
    Checker checker(casters, light, cones);
    for (vtkIdType c = first; c < last && c <= firstFault; ++c)
    {
      checker.Answer = {};
      for (vtkIdType i = c * chunk; i < std::min(mesh.NumberOfTriangles, (c + 1) * chunk); ++i)
      {
        if (mesh.OccluderId(i) >= 0 &&
          !IsFlush(face, mesh.Corner(i, 0), mesh.Corner(i, 1), mesh.Corner(i, 2)) &&
          !checker.PartIsHeld({ mesh.Corner(i, 0), mesh.Corner(i, 1), mesh.Corner(i, 2) }, 0))
        {
          checker.Answer.Triangle = i;
          vtkIdType known = firstFault;
          while (c < known && !firstFault.compare_exchange_weak(known, c))
          {
          }
          break;
        }
      }
      answers[c] = checker.Answer;
    }
  });
  check.Proved = finished;
  for (const ConeProofCheck& answer : answers)
  {
    const vtkIdType pairs = check.NumberOfPairs + answer.NumberOfPairs;
    if (answer.Triangle >= 0)
    {
      check = answer;
    }
    check.NumberOfPairs = pairs;
    if (answer.Triangle >= 0)
    {
      check.Proved = false;
      break;
    }
  }
  return finished;
}

} // namespace shadowcones
