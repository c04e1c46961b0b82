// SPDX-License-Identifier: BSD-3-Clause
// One file because the slow truth is to be read as one text, without a look at any fast path.
#include "scReference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace shadowcones
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Independent uniform numbers in [0, 1).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }
  double Next() { return std::generate_canonical<double, 53>(this->Engine); }

private:
  std::mt19937_64 Engine;
};

/// Moller and Trumbore (1997); infinity where the line misses.
double HitTriangle(const std::array<Vector3, 3>& triangle, const Vector3& origin, const Vector3& direction)
{
  const Vector3 e1 = triangle[1] - triangle[0];
  const Vector3 e2 = triangle[2] - triangle[0];
  const Vector3 p = Cross(direction, e2);
  const double determinant = Dot(e1, p);
  if (determinant == 0.0)
  {
    return Infinity;
  }
  const Vector3 s = origin - triangle[0];
  const double u = Dot(s, p) / determinant;
  const Vector3 q = Cross(s, e1);
  const double v = Dot(direction, q) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0))
  {
    return Infinity;
  }
  return Dot(e2, q) / determinant;
}

/// The part of [tMin, tMax] in a box; false where nothing is left.
bool ClipToBox(const double* boxMin, const double* boxMax, const Vector3& origin, const Vector3& direction,
  double& tMin, double& tMax)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (direction[axis] == 0.0)
    {
      if (origin[axis] < boxMin[axis] || origin[axis] > boxMax[axis])
      {
        return false;
      }
      continue;
    }
    double near = (boxMin[axis] - origin[axis]) / direction[axis];
    double far = (boxMax[axis] - origin[axis]) / direction[axis];
    if (near > far)
    {
      std::swap(near, far);
    }
    tMin = std::max(tMin, near);
    tMax = std::min(tMax, far);
  }
  return tMin <= tMax;
}

bool ClipToMedium(const Box& box, const Vector3& origin, const Vector3& direction, double& tMin, double& tMax)
{
  const double boxMin[3] = { box.Min.X, box.Min.Y, box.Min.Z };
  const double boxMax[3] = { box.Max.X, box.Max.Y, box.Max.Z };
  return ClipToBox(boxMin, boxMax, origin, direction, tMin, tMax);
}

/// A vector that is not parallel to @p axis, made orthogonal to it.
Vector3 AnyOrthogonal(const Vector3& axis)
{
  const Vector3 other = std::abs(axis.X) < 0.6 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
  const Vector3 cross = Cross(axis, other);
  return (1.0 / Length(cross)) * cross;
}

Vector3 RandomDirection(Random& random)
{
  for (;;)
  {
    const Vector3 v{ 2.0 * random.Next() - 1.0, 2.0 * random.Next() - 1.0, 2.0 * random.Next() - 1.0 };
    const double square = Dot(v, v);
    if (square > 1e-6 && square <= 1.0)
    {
      return (1.0 / std::sqrt(square)) * v;
    }
  }
}

/// Uniform over the directions around an axis whose cosine is at least @p least: the cosine is uniform.
Vector3 DirectionInCone(const Vector3& axis, double least, Random& random)
{
  const Vector3 u = AnyOrthogonal(axis);
  const Vector3 v = Cross(axis, u);
  const double cosine = least + (1.0 - least) * random.Next();
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double turn = 2.0 * Pi * random.Next();
  return cosine * axis + sine * (std::cos(turn) * u + std::sin(turn) * v);
}

/// A point of a light.
struct LightPoint
{
  Vector3 Position;
  Vector3 Normal;
};

/// The random light rule: independent points by area, found by rejection where the shape is round.
class RandomLight
{
public:
  explicit RandomLight(const Light& light)
    : Source(light)
  {
    switch (light.Shape)
    {
      case LightShape::Disc:
        this->Area = Pi * light.Radius * light.Radius;
        this->Reach = light.Radius;
        break;
      case LightShape::Rectangle:
        this->Area = 4.0 * Length(Cross(light.AxisU, light.AxisV));
        this->Reach = Length(light.AxisU) + Length(light.AxisV);
        break;
      case LightShape::Sphere:
        this->Area = 4.0 * Pi * light.Radius * light.Radius;
        this->Reach = light.Radius;
        break;
      case LightShape::Mesh:
        for (const auto& triangle : light.Triangles)
        {
          this->Area += 0.5 * Length(Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
          this->Sums.push_back(this->Area);
        }
        break;
      default:
        break;
    }
    this->Middle = light.Center;
    if (light.Shape == LightShape::Mesh)
    {
      Vector3 sum;
      double count = 0.0;
      for (const auto& triangle : light.Triangles)
      {
        sum += triangle[0] + triangle[1] + triangle[2];
        count += 3.0;
      }
      for (const Vector3& vertex : light.Vertices)
      {
        sum += vertex;
        count += 1.0;
      }
      this->Middle = (1.0 / std::max(count, 1.0)) * sum;
    }
  }

  /// What one random sample brings to a point: a direction, how far, and its share of the incident light.
  struct Draw
  {
    Vector3 Direction;
    double Distance = Infinity;
    double Weight = 0.0;
  };

  bool IsVertices() const { return this->Source.Shape == LightShape::Mesh && this->Source.Triangles.empty(); }

  LightPoint ByArea(Random& random) const
  {
    const Light& light = this->Source;
    switch (light.Shape)
    {
      case LightShape::Disc:
      {
        const Vector3 u = AnyOrthogonal(light.Normal);
        const Vector3 v = Cross(light.Normal, u);
        double a;
        double b;
        do
        {
          a = 2.0 * random.Next() - 1.0;
          b = 2.0 * random.Next() - 1.0;
        } while (a * a + b * b > 1.0);
        return { light.Center + light.Radius * (a * u + b * v), light.Normal };
      }
      case LightShape::Rectangle:
      {
        const double a = 2.0 * random.Next() - 1.0;
        const double b = 2.0 * random.Next() - 1.0;
        return { light.Center + a * light.AxisU + b * light.AxisV, light.Normal };
      }
      case LightShape::Sphere:
      {
        const Vector3 n = RandomDirection(random);
        return { light.Center + light.Radius * n, n };
      }
      default:
      {
        const double pick = random.Next() * this->Area;
        const auto found = std::upper_bound(this->Sums.begin(), this->Sums.end(), pick);
        const auto index = std::min<std::size_t>(found - this->Sums.begin(), this->Sums.size() - 1);
        const auto& t = light.Triangles[index];
        double a = random.Next();
        double b = random.Next();
        if (a + b > 1.0)
        {
          a = 1.0 - a;
          b = 1.0 - b;
        }
        const Vector3 e1 = t[1] - t[0];
        const Vector3 e2 = t[2] - t[0];
        const Vector3 normal = Cross(e1, e2);
        return { t[0] + a * e1 + b * e2, (1.0 / Length(normal)) * normal };
      }
    }
  }

  /// Mean over draws of Weight * Spectrum = integral of the incident radiance, nothing in the way.
  Draw Incident(const Vector3& x, Random& random) const
  {
    const Light& light = this->Source;
    if (light.Shape == LightShape::Point || this->IsVertices())
    {
      const std::size_t count = this->IsVertices() ? light.Vertices.size() : 1;
      const auto index = std::min<std::size_t>(static_cast<std::size_t>(random.Next() * count), count - 1);
      Draw draw = Towards(x, this->IsVertices() ? light.Vertices[index] : light.Center);
      draw.Weight = count / (draw.Distance * draw.Distance);
      return draw;
    }
    if (light.Shape == LightShape::Sun)
    {
      return this->OfSun(random);
    }
    // Near the light a share of random directions keeps the 1/d^2 of points by area bounded.
    const double away = Length(x - this->Middle);
    const double share = light.Shape != LightShape::Mesh && away < 1.5 * this->Reach ? 0.5 : 0.0;
    const double coneCosine = away > this->Reach ? std::sqrt(1.0 - this->Reach * this->Reach / (away * away)) : -1.0;
    LightPoint point;
    if (random.Next() < share)
    {
      const Vector3 axis = away > 0.0 ? (1.0 / away) * (this->Middle - x) : Vector3{ 0.0, 0.0, 1.0 };
      if (!this->Meet(x, DirectionInCone(axis, coneCosine, random), point))
      {
        return {};
      }
    }
    else
    {
      point = this->ByArea(random);
    }
    Draw draw = Towards(x, point.Position);
    const double cosine = -Dot(draw.Direction, point.Normal);
    if (!(cosine > 0.0) || !(draw.Distance > 0.0))
    {
      return {};
    }
    const double byArea = draw.Distance * draw.Distance / (cosine * this->Area);
    const double bySolidAngle = share > 0.0 ? share / (2.0 * Pi * (1.0 - coneCosine)) : 0.0;
    draw.Weight = 1.0 / ((1.0 - share) * byArea + bySolidAngle);
    return draw;
  }

  /// Weights whose mean is 1 over what the point sees of the light.
  Draw Visible(const Vector3& x, Random& random) const
  {
    const Light& light = this->Source;
    if (light.Shape == LightShape::Sun)
    {
      return this->OfSun(random);
    }
    if (light.Shape == LightShape::Point)
    {
      Draw draw = Towards(x, light.Center);
      draw.Weight = 1.0;
      return draw;
    }
    if (this->IsVertices())
    {
      const std::size_t count = light.Vertices.size();
      Draw draw =
        Towards(x, light.Vertices[std::min<std::size_t>(static_cast<std::size_t>(random.Next() * count), count - 1)]);
      draw.Weight = 1.0;
      return draw;
    }
    const LightPoint point = this->ByArea(random);
    Draw draw = Towards(x, point.Position);
    const double cosine = -Dot(draw.Direction, point.Normal);
    if (cosine > 0.0)
    {
      draw.Weight = light.Shape == LightShape::Sphere ? cosine / (draw.Distance * draw.Distance) : 1.0;
    }
    return draw;
  }

  Vector3 Middle;

private:
  static Draw Towards(const Vector3& x, const Vector3& y)
  {
    Draw draw;
    draw.Direction = y - x;
    draw.Distance = Length(draw.Direction);
    draw.Direction = (1.0 / draw.Distance) * draw.Direction;
    return draw;
  }

  /// Uniform over the solid angle of the sun's face: 1 - cos is uniform.
  Draw OfSun(Random& random) const
  {
    const Vector3 axis = -this->Source.Normal;
    const Vector3 u = AnyOrthogonal(axis);
    const Vector3 v = Cross(axis, u);
    const double sineOfHalf = std::sqrt(random.Next()) * std::sin(0.5 * this->Source.Radius);
    const double angle = 2.0 * std::asin(sineOfHalf);
    const double turn = 2.0 * Pi * random.Next();
    Draw draw;
    draw.Direction = std::cos(angle) * axis + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
    draw.Weight = 1.0;
    return draw;
  }

  /// The point of a disc, rectangle or sphere that a ray meets first; false where it misses.
  bool Meet(const Vector3& x, const Vector3& direction, LightPoint& point) const
  {
    const Light& light = this->Source;
    if (light.Shape == LightShape::Sphere)
    {
      const Vector3 s = light.Center - x;
      const double along = Dot(s, direction);
      const double square = light.Radius * light.Radius - (Dot(s, s) - along * along);
      if (square < 0.0 || along <= std::sqrt(square))
      {
        return false;
      }
      point.Position = x + (along - std::sqrt(square)) * direction;
      point.Normal = (1.0 / light.Radius) * (point.Position - light.Center);
      return true;
    }
    const double slope = Dot(direction, light.Normal);
    if (slope >= 0.0)
    {
      return false;
    }
    const double t = Dot(light.Center - x, light.Normal) / slope;
    if (t <= 0.0)
    {
      return false;
    }
    point.Position = x + t * direction;
    point.Normal = light.Normal;
    const Vector3 s = point.Position - light.Center;
    if (light.Shape == LightShape::Disc)
    {
      return Dot(s, s) <= light.Radius * light.Radius;
    }
    return std::abs(Dot(s, light.AxisU)) <= Dot(light.AxisU, light.AxisU) &&
      std::abs(Dot(s, light.AxisV)) <= Dot(light.AxisV, light.AxisV);
  }

  const Light& Source;
  double Area = 0.0;
  double Reach = 0.0;
  std::vector<double> Sums;
};

/// Shadow rays end just before the light, which may itself lie on a surface.
constexpr double BeforeTheLight = 1.0 - 1e-9;

} // namespace

//------------------------------------------------------------------------------
ReferenceScene::ReferenceScene(const TriangleMeshView& mesh)
{
  for (vtkIdType triangle = 0; triangle < mesh.NumberOfTriangles; ++triangle)
  {
    this->Triangles.push_back({ mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2) });
  }
  if (!this->Triangles.empty())
  {
    this->Build(0, static_cast<int>(this->Triangles.size()));
  }
}

//------------------------------------------------------------------------------
int ReferenceScene::Build(int begin, int end)
{
  const int index = static_cast<int>(this->Nodes.size());
  this->Nodes.emplace_back();
  Node node;
  node.Min.fill(Infinity);
  node.Max.fill(-Infinity);
  for (int triangle = begin; triangle < end; ++triangle)
  {
    for (const Vector3& corner : this->Triangles[triangle])
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        node.Min[axis] = std::min(node.Min[axis], corner[axis]);
        node.Max[axis] = std::max(node.Max[axis], corner[axis]);
      }
    }
  }
  int widest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (node.Max[axis] - node.Min[axis] > node.Max[widest] - node.Min[widest])
    {
      widest = axis;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // A ray in the plane of a flat box must not miss it by rounding.
    const double pad =
      1e-12 * (std::abs(node.Min[axis]) + std::abs(node.Max[axis])) + 1e-12 * (node.Max[widest] - node.Min[widest]);
    node.Min[axis] -= pad;
    node.Max[axis] += pad;
  }
  if (end - begin <= 4)
  {
    node.Begin = begin;
    node.End = end;
  }
  else
  {
    const int middle = (begin + end) / 2;
    const auto at = this->Triangles.begin();
    std::nth_element(at + begin, at + middle, at + end,
      [widest](const auto& a, const auto& b)
      { return a[0][widest] + a[1][widest] + a[2][widest] < b[0][widest] + b[1][widest] + b[2][widest]; });
    this->Build(begin, middle);
    node.Second = this->Build(middle, end);
  }
  this->Nodes[index] = node;
  return index;
}

//------------------------------------------------------------------------------
double ReferenceScene::Search(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, bool any, int& found) const
{
  double nearest = Infinity;
  found = -1;
  if (this->Nodes.empty())
  {
    return nearest;
  }
  int stack[128];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0)
  {
    const int index = stack[--depth];
    const Node& node = this->Nodes[index];
    double near = tMin;
    double far = std::min(tMax, nearest);
    if (!ClipToBox(node.Min.data(), node.Max.data(), origin, direction, near, far))
    {
      continue;
    }
    if (node.End == 0)
    {
      stack[depth++] = node.Second;
      stack[depth++] = index + 1;
      continue;
    }
    for (int triangle = node.Begin; triangle < node.End; ++triangle)
    {
      const double t = HitTriangle(this->Triangles[triangle], origin, direction);
      if (t > tMin && t < tMax && t < nearest)
      {
        nearest = t;
        found = triangle;
        if (any)
        {
          return nearest;
        }
      }
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
double ReferenceScene::Nearest(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, Vector3* normal) const
{
  int found = -1;
  const double t = this->Search(origin, direction, tMin, tMax, false, found);
  if (normal && found >= 0)
  {
    const auto& triangle = this->Triangles[found];
    const Vector3 cross = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    *normal = ((Dot(cross, direction) > 0.0 ? -1.0 : 1.0) / Length(cross)) * cross;
  }
  return t;
}

//------------------------------------------------------------------------------
bool ReferenceScene::Blocked(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const
{
  int found = -1;
  return this->Search(origin, direction, tMin, tMax, true, found) < Infinity;
}

//------------------------------------------------------------------------------
int ReferenceScene::CountHits(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const
{
  int count = 0;
  for (const auto& triangle : this->Triangles)
  {
    const double t = HitTriangle(triangle, origin, direction);
    count += t > tMin && t < tMax;
  }
  return count;
}

//------------------------------------------------------------------------------
double ReferenceVisibility(
  const ReferenceScene& scene, const Light& light, const Vector3& x, int samples, std::uint64_t seed)
{
  const RandomLight source(light);
  Random random(seed);
  double seen = 0.0;
  double all = 0.0;
  for (int sample = 0; sample < samples; ++sample)
  {
    const RandomLight::Draw draw = source.Visible(x, random);
    all += draw.Weight;
    if (draw.Weight > 0.0 && !scene.Blocked(x, draw.Direction, 0.0, draw.Distance * BeforeTheLight))
    {
      seen += draw.Weight;
    }
  }
  return all > 0.0 ? seen / all : 0.0;
}

//------------------------------------------------------------------------------
double ReferencePhaseFunction(const PhaseFunction& phase, double cosine)
{
  const auto schlick = [cosine](double k)
  { return (1.0 - k * k) / (4.0 * Pi * (1.0 - k * cosine) * (1.0 - k * cosine)); };
  const double g = phase.Asymmetry;
  switch (phase.Kind)
  {
    case PhaseFunctionKind::BlasiSchlick:
      return phase.Lobes.Weight * schlick(phase.Lobes.K1) + (1.0 - phase.Lobes.Weight) * schlick(phase.Lobes.K2);
    case PhaseFunctionKind::HenyeyGreenstein:
      return (1.0 - g * g) / (4.0 * Pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
    case PhaseFunctionKind::Rayleigh:
      return 3.0 / (16.0 * Pi) * (1.0 + cosine * cosine);
    default:
      return 1.0 / (4.0 * Pi);
  }
}

//------------------------------------------------------------------------------
namespace
{
/// Trilinear between the points of a grid, 0 outside; constant along an axis with a single point.
double DensityAt(const DensityGrid& grid, const Vector3& x)
{
  const Vector3 s = x - grid.Origin;
  const Vector3 cross[3] = { Cross(grid.Axes[1], grid.Axes[2]), Cross(grid.Axes[2], grid.Axes[0]),
    Cross(grid.Axes[0], grid.Axes[1]) };
  const double volume = Dot(grid.Axes[0], cross[0]);
  int low[3];
  double share[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = grid.Dimensions[axis] - 1;
    const double place = last > 0 ? Dot(cross[axis], s) / volume : 0.0;
    if (!(place >= -1e-9 && place <= last + 1e-9))
    {
      return 0.0;
    }
    low[axis] = std::clamp(static_cast<int>(std::floor(place)), 0, std::max(last - 1, 0));
    share[axis] = place - low[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int up = corner >> axis & 1;
      weight *= up ? share[axis] : 1.0 - share[axis];
      index = index * grid.Dimensions[axis] + std::min(low[axis] + up, grid.Dimensions[axis] - 1);
    }
    sum += weight * static_cast<double>(grid.Values[index]);
  }
  return sum;
}

double SmallestStep(const DensityGrid& grid)
{
  return std::min({ Length(grid.Axes[0]), Length(grid.Axes[1]), Length(grid.Axes[2]) });
}

/// What a pixel's centre looks along.
void CameraRay(const Camera& camera, int i, int j, int width, int height, Vector3& origin, Vector3& direction)
{
  const double right = ((i + 0.5) / width * 2.0 - 1.0) * camera.HalfHeight * width / height;
  const double up = ((j + 0.5) / height * 2.0 - 1.0) * camera.HalfHeight;
  const Vector3 aside = right * camera.Right + up * camera.Up;
  origin = camera.Parallel ? camera.Position + aside : camera.Position;
  direction = camera.Parallel ? camera.Forward : camera.Forward + aside;
  direction = (1.0 / Length(direction)) * direction;
}

/// Mean and standard error of independent estimates.
ReferenceEstimate Summarise(const std::vector<std::vector<double>>& estimates)
{
  const auto count = static_cast<double>(estimates.size());
  ReferenceEstimate result;
  for (std::size_t k = 0; k < estimates[0].size(); ++k)
  {
    double mean = 0.0;
    double squares = 0.0;
    for (const auto& estimate : estimates)
    {
      mean += estimate[k] / count;
    }
    for (const auto& estimate : estimates)
    {
      squares += (estimate[k] - mean) * (estimate[k] - mean);
    }
    result.Mean.push_back(mean);
    result.StandardError.push_back(std::sqrt(squares / (count * (count - 1.0))));
  }
  return result;
}

/// The far end of a way to a light: infinitely far ones leave every medium before.
Vector3 EndOf(const Vector3& from, const RandomLight::Draw& draw, const Medium& medium)
{
  const double reach = Length(medium.Bounds.Max - medium.Bounds.Min) + Length(medium.Bounds.Min - from);
  return from + std::min(draw.Distance, reach) * draw.Direction;
}
} // namespace

//------------------------------------------------------------------------------
double ReferenceDepth(const Medium& medium, const Vector3& a, const Vector3& b)
{
  const double length = Length(b - a);
  double begin = 0.0;
  double end = length;
  if (!(length > 0.0) || !ClipToMedium(medium.Bounds, a, (1.0 / length) * (b - a), begin, end))
  {
    return 0.0;
  }
  if (!medium.Density)
  {
    return end - begin;
  }
  const Vector3 direction = (1.0 / length) * (b - a);
  const int steps = static_cast<int>(std::ceil(4.0 * (end - begin) / SmallestStep(*medium.Density))) + 1;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    sum += DensityAt(*medium.Density, a + (begin + (k + 0.5) / steps * (end - begin)) * direction);
  }
  return sum * (end - begin) / steps;
}

//------------------------------------------------------------------------------
ReferenceEstimate operator+(const ReferenceEstimate& a, const ReferenceEstimate& b)
{
  ReferenceEstimate sum = a;
  for (std::size_t k = 0; k < a.Mean.size(); ++k)
  {
    sum.Mean[k] += b.Mean[k];
    sum.StandardError[k] = std::hypot(a.StandardError[k], b.StandardError[k]);
  }
  return sum;
}

//------------------------------------------------------------------------------
ReferenceEstimate ReferenceSurface(const ReferenceScene& scene, const Light& light, const Medium& medium,
  const Camera& camera, int i, int j, int width, int height, double reflectance, int samples, std::uint64_t seed)
{
  constexpr int estimates = 16;
  const std::size_t wavelengths = light.Spectrum.size();
  std::vector<std::vector<double>> sums(estimates, std::vector<double>(wavelengths, 0.0));
  Vector3 origin;
  Vector3 direction;
  CameraRay(camera, i, j, width, height, origin, direction);
  Vector3 normal;
  const double t = scene.Nearest(origin, direction, 0.0, Infinity, &normal);
  if (!(t < Infinity))
  {
    return Summarise(sums);
  }
  const Vector3 hit = origin + t * direction;
  const Vector3 x = hit + 1e-9 * t * normal;
  const double cameraDepth = ReferenceDepth(medium, origin, hit);
  const RandomLight source(light);
  Random random(seed + 7000003ull * (static_cast<std::uint64_t>(j) * width + i));
  const int count = std::max(1, samples / estimates);
  for (auto& sum : sums)
  {
    for (int sample = 0; sample < count; ++sample)
    {
      const RandomLight::Draw draw = source.Incident(x, random);
      const double cosine = Dot(draw.Direction, normal);
      if (!(draw.Weight > 0.0 && cosine > 0.0) ||
        scene.Blocked(x, draw.Direction, 0.0, draw.Distance * BeforeTheLight))
      {
        continue;
      }
      const double depth = cameraDepth + ReferenceDepth(medium, x, EndOf(x, draw, medium));
      for (std::size_t k = 0; k < wavelengths; ++k)
      {
        sum[k] += reflectance / Pi * draw.Weight * cosine * light.Spectrum[k] *
          std::exp(-(medium.SigmaS[k] + medium.SigmaA[k]) * depth) / count;
      }
    }
  }
  return Summarise(sums);
}

//------------------------------------------------------------------------------
ReferenceEstimate ReferenceInScattering(const ReferenceScene& scene, const Light& light, const Medium& medium,
  const Camera& camera, int i, int j, int width, int height, int samples, std::uint64_t seed)
{
  constexpr int estimates = 16;
  const std::size_t wavelengths = light.Spectrum.size();
  ReferenceEstimate result;
  result.Mean.assign(wavelengths, 0.0);
  result.StandardError.assign(wavelengths, 0.0);

  Vector3 origin;
  Vector3 direction;
  CameraRay(camera, i, j, width, height, origin, direction);

  double begin = 0.0;
  double end = Infinity;
  if (!ClipToMedium(medium.Bounds, origin, direction, begin, end))
  {
    return result;
  }
  end = std::min(end, scene.Nearest(origin, direction, 0.0, end));
  if (!(end > begin))
  {
    return result;
  }

  const RandomLight source(light);
  Random random(seed + 1000003ull * (static_cast<std::uint64_t>(j) * width + i));
  const bool equiAngular = light.Shape != LightShape::Sun;
  const double foot = Dot(source.Middle - origin, direction);
  const double distance = std::max(Length(source.Middle - (origin + foot * direction)), 1e-3 * (end - begin));
  const double fromAngle = std::atan((begin - foot) / distance);
  const double toAngle = std::atan((end - foot) / distance);

  const int count = std::max(1, samples / estimates);
  std::vector<std::vector<double>> sums(estimates, std::vector<double>(wavelengths, 0.0));
  for (auto& sum : sums)
  {
    for (int sample = 0; sample < count; ++sample)
    {
      // Each estimate strikes every part of the ray once; the place within the part is random.
      const double r = (sample + random.Next()) / count;
      const bool uniform = !equiAngular || random.Next() < 0.25;
      const double t = std::clamp(
        uniform ? begin + r * (end - begin) : foot + distance * std::tan(fromAngle + r * (toAngle - fromAngle)), begin,
        end);
      double density = 1.0 / (end - begin);
      if (equiAngular)
      {
        const double s = t - foot;
        density = 0.25 * density + 0.75 * distance / ((toAngle - fromAngle) * (distance * distance + s * s));
      }
      const Vector3 x = origin + t * direction;
      const RandomLight::Draw draw = source.Incident(x, random);
      if (!(draw.Weight > 0.0) || scene.Blocked(x, draw.Direction, 0.0, draw.Distance * BeforeTheLight))
      {
        continue;
      }
      const double path =
        ReferenceDepth(medium, origin + begin * direction, x) + ReferenceDepth(medium, x, EndOf(x, draw, medium));
      const double scale = draw.Weight * ReferencePhaseFunction(medium.Phase, Dot(draw.Direction, direction)) *
        (medium.Density ? DensityAt(*medium.Density, x) : 1.0) / density;
      for (std::size_t k = 0; k < wavelengths; ++k)
      {
        sum[k] += scale * light.Spectrum[k] * medium.SigmaS[k] *
          std::exp(-(medium.SigmaS[k] + medium.SigmaA[k]) * path) / count;
      }
    }
  }
  return Summarise(sums);
}

//------------------------------------------------------------------------------
bool ReferenceConeContains(const Cone& cone, const Vector3& point, double length)
{
  const Vector3 s = point - cone.Center;
  const double along = Dot(s, cone.Axis);
  const double radius = cone.BaseRadius + along * std::tan(cone.HalfAngle);
  return along >= 0.0 && along <= length && radius >= 0.0 && Length(s - along * cone.Axis) <= radius;
}

//------------------------------------------------------------------------------
bool ReferenceConeInterval(const Cone& cone, double length, const Vector3& origin, const Vector3& direction,
  double tMin, double tMax, double& begin, double& end, int samples)
{
  const auto inside = [&](double t) { return ReferenceConeContains(cone, origin + t * direction, length); };
  const auto edge = [&](double out, double in)
  {
    for (int step = 0; step < 60; ++step)
    {
      const double middle = 0.5 * (out + in);
      (inside(middle) ? in : out) = middle;
    }
    return in;
  };
  int first = -1;
  int last = -1;
  const auto place = [&](int k) { return tMin + (tMax - tMin) * k / samples; };
  for (int k = 0; k <= samples; ++k)
  {
    if (inside(place(k)))
    {
      first = first < 0 ? k : first;
      last = k;
    }
  }
  if (first < 0)
  {
    return false;
  }
  begin = first == 0 ? tMin : edge(place(first - 1), place(first));
  end = last == samples ? tMax : edge(place(last + 1), place(last));
  return true;
}

} // namespace shadowcones
