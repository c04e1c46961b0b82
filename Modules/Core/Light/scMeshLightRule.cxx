// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshLightRule.h"

#include "scBox.h"
#include "scSphericalRectangle.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Points over all triangles of a small mesh at level 0, and patches of a large one; twice as many at every level.
constexpr std::size_t fewestPoints = 64;
constexpr std::size_t fewestPatches = 256;
/// In radii of a triangle, at level 0: nearer than so much a Gauss rule of 1, 2, 3 points along a side does not do.
constexpr double farEnough[4] = { 5.0, 5.0, 3.0, 2.0 };
/// Nearer than so many radii no rule by area does.
constexpr double closest = 1.5;
/// Triangles under a smaller solid angle (sr) than this send next to nothing: their points by area do.
constexpr double smallestSolidAngle = 1e-4;

/// Faces that point to the same side of the cube.
int FacingOf(const Vector3& normal)
{
  int axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = std::fabs(normal[other]) > std::fabs(normal[axis]) ? other : axis;
  }
  return 2 * axis + (normal[axis] < 0.0 ? 1 : 0);
}

int SideOf(std::size_t triangles, int level)
{
  // Grown by one at least, so that two levels never agree by being the same.
  int side = 0;
  std::size_t patches = fewestPatches;
  for (int k = 0; k <= level; ++k)
  {
    if (side == 0 && patches < triangles)
    {
      patches *= 2;
      continue;
    }
    const double wanted = std::sqrt(static_cast<double>(fewestPoints << k) / static_cast<double>(triangles));
    side = std::max(side + 1, static_cast<int>(std::lround(wanted)));
  }
  return side;
}

/// The point of a triangle that is nearest to another one (Ericson, Real-Time Collision Detection, 5.1.5).
Vector3 NearestOf(const std::array<Vector3, 3>& t, const Vector3& p)
{
  const Vector3 ab = t[1] - t[0];
  const Vector3 ac = t[2] - t[0];
  const auto alongEdge = [&p](const Vector3& a, const Vector3& b)
  {
    const Vector3 edge = b - a;
    return a + std::clamp(Dot(p - a, edge) / Dot(edge, edge), 0.0, 1.0) * edge;
  };
  const Vector3 normal = Cross(ab, ac);
  const double squared = Dot(normal, normal);
  const double v = Dot(Cross(p - t[0], ac), normal) / squared;
  const double w = Dot(Cross(ab, p - t[0]), normal) / squared;
  if (v >= 0.0 && w >= 0.0 && v + w <= 1.0)
  {
    return t[0] + v * ab + w * ac;
  }
  Vector3 best;
  double least = HUGE_VAL;
  for (std::size_t edge = 0; edge < 3; ++edge)
  {
    const Vector3 q = alongEdge(t[edge], t[(edge + 1) % 3]);
    if (Dot(q - p, q - p) < least)
    {
      least = Dot(q - p, q - p);
      best = q;
    }
  }
  return best;
}
} // anonymous namespace

MeshLightRule::MeshLightRule(const Light& light, int level)
  : FarEnough(1.0 + 0.5 * level)
  , NearRule(4 + level)
  , TurnRule(3 + 2 * level)
  , TiltRule(3 + level)
{
  std::array<std::size_t, 7> firstFacing{};
  for (int facing = 0; facing < 6; ++facing)
  {
    for (std::size_t k = 0; k < light.Triangles.size(); ++k)
    {
      const auto& t = light.Triangles[k];
      Triangle triangle{ t, (1.0 / 3.0) * (t[0] + t[1] + t[2]), 0.5 * Cross(t[1] - t[0], t[2] - t[0]), 0.0, k };
      if (FacingOf(triangle.AreaVector) == facing && Dot(triangle.AreaVector, triangle.AreaVector) > 0.0)
      {
        for (const Vector3& corner : t)
        {
          triangle.Radius = std::max(triangle.Radius, Length(corner - triangle.Middle));
        }
        this->Ordered.push_back(triangle);
      }
    }
    firstFacing[static_cast<std::size_t>(facing) + 1] = this->Ordered.size();
  }
  const std::size_t count = this->Ordered.size();
  this->Side = SideOf(count, level);
  for (std::size_t facing = 0; facing < 6; ++facing)
  {
    const std::size_t begin = firstFacing[facing];
    const std::size_t end = firstFacing[facing + 1];
    const std::size_t all = this->Side > 0 ? count : fewestPatches << level;
    const auto patches = static_cast<double>(all) * static_cast<double>(end - begin) / static_cast<double>(count);
    if (end > begin)
    {
      this->CutIntoPatches(begin, end, std::clamp<std::size_t>(std::lround(patches), 1, end - begin));
    }
  }
}

void MeshLightRule::CutIntoPatches(std::size_t begin, std::size_t end, std::size_t patches)
{
  if (patches == 1)
  {
    this->AddPatch(begin, end);
    return;
  }
  Box middles;
  for (std::size_t k = begin; k < end; ++k)
  {
    middles.Add(this->Ordered[k].Middle);
  }
  const Vector3 size = middles.Size();
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : (size.Y >= size.Z ? 1 : 2);
  const std::size_t left = patches / 2;
  const std::size_t middle = begin + std::max<std::size_t>(left, (end - begin) * left / patches);
  const auto at = this->Ordered.begin();
  const auto step = [](std::size_t k) { return static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at + step(begin), at + step(middle), at + step(end),
    [axis](const Triangle& a, const Triangle& b)
    { return a.Middle[axis] != b.Middle[axis] ? a.Middle[axis] < b.Middle[axis] : a.Index < b.Index; });
  this->CutIntoPatches(begin, middle, left);
  this->CutIntoPatches(middle, end, patches - left);
}

void MeshLightRule::AddPatch(std::size_t begin, std::size_t end)
{
  Patch patch;
  patch.FirstTriangle = begin;
  patch.EndOfTriangles = end;
  patch.FirstPoint = this->AllPoints.size();
  Vector3 areaVector;
  double area = 0.0;
  for (std::size_t k = begin; k < end; ++k)
  {
    const Triangle& triangle = this->Ordered[k];
    areaVector += triangle.AreaVector;
    patch.Middle += Length(triangle.AreaVector) * triangle.Middle;
    area += Length(triangle.AreaVector);
  }
  patch.Middle = (1.0 / area) * patch.Middle;
  double radius = 0.0;
  for (std::size_t k = begin; k < end; ++k)
  {
    radius = std::max(radius, Length(this->Ordered[k].Middle - patch.Middle) + this->Ordered[k].Radius);
  }
  if (this->Side > 0)
  {
    this->AddGaussPoints(this->Ordered[begin], GaussLegendre(this->Side));
  }
  else
  {
    // What a group sends is that of its vector area, as long as all of it faces the point.
    this->AllPoints.push_back({ patch.Middle, Normalized(areaVector), Length(areaVector) });
  }
  patch.EndOfPoints = this->AllPoints.size();
  const double near = radius * (this->Side < 4 ? this->FarEnough * farEnough[this->Side] : closest);
  patch.NearSquared = near * near;
  this->AllPatches.push_back(patch);
  this->NearBounds.Add(patch.Middle - Vector3{ near, near, near });
  this->NearBounds.Add(patch.Middle + Vector3{ near, near, near });
}

void MeshLightRule::AddGaussPoints(const Triangle& triangle, const GaussLegendre& rule)
{
  // A product of two Gauss rules on the square, one side of which is drawn together to a corner (Duffy 1982).
  const auto& t = triangle.Corners;
  const Vector3 u = t[1] - t[0];
  const Vector3 v = t[2] - t[1];
  const double area = Length(triangle.AreaVector);
  const Vector3 normal = (1.0 / area) * triangle.AreaVector;
  if (rule.Nodes.size() == 1)
  {
    this->AllPoints.push_back({ triangle.Middle, normal, area });
    return;
  }
  for (std::size_t i = 0; i < rule.Nodes.size(); ++i)
  {
    for (std::size_t j = 0; j < rule.Nodes.size(); ++j)
    {
      const double x = rule.Nodes[i];
      this->AllPoints.push_back(
        { t[0] + x * u + x * rule.Nodes[j] * v, normal, 2.0 * area * x * rule.Weights[i] * rule.Weights[j] });
    }
  }
}

void MeshLightRule::LookAt(const Patch& patch, const Vector3& from, std::vector<IncidentSample>& samples) const
{
  for (std::size_t k = patch.FirstTriangle; k < patch.EndOfTriangles; ++k)
  {
    const Triangle& triangle = this->Ordered[k];
    if (Dot(from - triangle.Corners[0], triangle.AreaVector) > 0.0)
    {
      this->LookAtTriangle(triangle, from, samples);
    }
  }
}

void MeshLightRule::LookAtTriangle(
  const Triangle& triangle, const Vector3& from, std::vector<IncidentSample>& samples) const
{
  const auto& t = triangle.Corners;
  const double area = Length(triangle.AreaVector);
  const Vector3 normal = (1.0 / area) * triangle.AreaVector;
  const Vector3 offset = triangle.Middle - from;
  const double radii = Length(offset) / triangle.Radius;
  const auto byArea = [&](const Vector3& position, double share)
  {
    const Vector3 to = position - from;
    const double squared = Dot(to, to);
    const double inverse = 1.0 / std::sqrt(squared);
    samples.push_back({ inverse * to, squared * inverse, -Dot(to, normal) * inverse * share / squared });
  };
  if (radii > this->FarEnough * farEnough[1])
  {
    byArea(triangle.Middle, area);
    return;
  }
  const double volume = Dot(from - t[0], 2.0 * triangle.AreaVector);
  if (radii < closest &&
    TriangleSolidAngle(volume, t[0] - from, t[1] - from, t[2] - from) > smallestSolidAngle)
  {
    this->LookAround(triangle, from, samples);
    return;
  }
  const GaussLegendre& rule = this->NearRule;
  const Vector3 u = t[1] - t[0];
  const Vector3 v = t[2] - t[1];
  for (std::size_t i = 0; i < rule.Nodes.size(); ++i)
  {
    for (std::size_t j = 0; j < rule.Nodes.size(); ++j)
    {
      const double x = rule.Nodes[i];
      byArea(t[0] + x * u + x * rule.Nodes[j] * v, 2.0 * area * x * rule.Weights[i] * rule.Weights[j]);
    }
  }
}

void MeshLightRule::LookAround(
  const Triangle& triangle, const Vector3& from, std::vector<IncidentSample>& samples) const
{
  const auto& t = triangle.Corners;
  const Vector3 axis = Normalized(NearestOf(t, from) - from);
  const std::size_t first = samples.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += this->AddSector(triangle, from, axis, t[k] - from, t[(k + 1) % 3] - from, samples);
  }
  const double volume = Dot(from - t[0], 2.0 * triangle.AreaVector);
  const double exact = TriangleSolidAngle(volume, t[0] - from, t[1] - from, t[2] - from);
  for (std::size_t k = first; k < samples.size(); ++k)
  {
    samples[k].Weight *= exact / sum;
  }
}

/// The part between the axis and the edge from b to c: evenly in its turn about the axis and in the cosine of its tilt.
double MeshLightRule::AddSector(const Triangle& triangle, const Vector3& from, const Vector3& axis, const Vector3& b,
  const Vector3& c, std::vector<IncidentSample>& samples) const
{
  const Vector3 acrossB = b - Dot(b, axis) * axis;
  const Vector3 acrossC = c - Dot(c, axis) * axis;
  const double turn = std::atan2(std::fabs(Dot(axis, Cross(acrossB, acrossC))), Dot(acrossB, acrossC));
  const Vector3 edge = Cross(b, c);
  const double towards = std::fabs(Dot(edge, axis));
  if (!(turn > 0.0 && towards > 1e-7 * Length(edge)))
  {
    return 0.0; // the axis meets the edge, up to rounding: nothing lies between them
  }
  const Vector3 u = Normalized(acrossB);
  const Vector3 v = Normalized(acrossC - Dot(acrossC, u) * u);
  const double sign = Dot(edge, axis) < 0.0 ? -1.0 : 1.0;
  const double height = Dot(triangle.Corners[0] - from, triangle.AreaVector); // below 0, as its normal faces the point
  const double farthest = std::sqrt(std::max({ Dot(triangle.Corners[0] - from, triangle.Corners[0] - from),
    Dot(triangle.Corners[1] - from, triangle.Corners[1] - from),
    Dot(triangle.Corners[2] - from, triangle.Corners[2] - from) }));
  // In two parts where the way to the edge is shortest in between.
  const double shortest = std::atan2(-sign * Dot(edge, v), -sign * Dot(edge, u));
  const double cuts[3] = { 0.0, std::clamp(shortest, 0.0, turn), turn };
  double sum = 0.0;
  const std::size_t turns = this->TurnRule.Nodes.size();
  for (std::size_t i = 0; i < 2 * turns; ++i)
  {
    const double width = cuts[i / turns + 1] - cuts[i / turns];
    const double angle = cuts[i / turns] + width * this->TurnRule.Nodes[i % turns];
    const Vector3 across = std::cos(angle) * u + std::sin(angle) * v;
    const double tilt = std::atan2(towards, -sign * Dot(edge, across));
    const double half = std::sin(0.5 * tilt);
    const double lift = 2.0 * half * half; // 1 - cos(tilt)
    for (std::size_t j = 0; j < this->TiltRule.Nodes.size() && width > 0.0; ++j)
    {
      // The square makes what depends on the tilt smooth at the axis.
      const double s = this->TiltRule.Nodes[j];
      const double cosine = 1.0 - lift * s * s;
      const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      const Vector3 direction = cosine * axis + sine * across;
      const double slope = Dot(direction, triangle.AreaVector);
      const double weight = width * this->TurnRule.Weights[i % turns] * lift * 2.0 * s * this->TiltRule.Weights[j];
      samples.push_back({ direction, slope < 0.0 ? std::min(height / slope, farthest) : farthest, weight });
      sum += weight;
    }
  }
  return sum;
}

} // namespace shadowcones
