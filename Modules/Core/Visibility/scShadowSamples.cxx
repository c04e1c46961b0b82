// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowSamples.h"

#include "scBits.h"
#include "scConstants.h"
#include "scFrame.h"
#include "scLampPlane.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace shadowcones
{
namespace
{
constexpr int rimPoints = 32;
constexpr int blockSize = 64;
constexpr std::uint64_t patternSeed = 1;
/// Of a mesh light of more corners those alone are asked for that are the farthest along one of so many directions.
constexpr std::size_t mostCorners = 192;

bool IsOfPoints(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Mesh && light.Triangles.empty());
}
/// Corners of a mesh light that span it: directions cover the sphere evenly, or the plane of a flat light.
std::set<std::array<double, 3>> ExtremeCorners(const Light& light)
{
  const FlatFace face = FlatFaceOf(light);
  std::set<std::array<double, 3>> extremes;
  for (std::size_t k = 0; k < mostCorners; ++k)
  {
    const double height = (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(mostCorners) - 1.0;
    const double angle = Pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(k);
    const double radius = std::sqrt(1.0 - height * height);
    const Vector3 direction{ radius * std::cos(angle), radius * std::sin(angle), height };
    const Vector3 along = face.IsFlat ? direction - Dot(direction, face.Normal) * face.Normal : direction;
    Vector3 farthest = light.Triangles[0][0];
    for (const auto& t : light.Triangles)
    {
      for (const Vector3& corner : t)
      {
        farthest = Dot(corner, along) > Dot(farthest, along) ? corner : farthest;
      }
    }
    extremes.insert({ farthest.X, farthest.Y, farthest.Z });
  }
  return extremes;
}
} // anonymous namespace

ShadowSamples::ShadowSamples(const Light& light, int inside, const OccluderScene& scene)
  : Scene(scene)
  , Rules(scene.RulesFor(FlatFaceOf(light)))
  , AtInfinity(shadowcones::IsAtInfinity(light))
  , OfBall(light.Shape == LightShape::Sphere)
  , Center(light.Center)
  , Radius(light.Radius)
{
  this->AddSpan(light);
  const bool whole = IsOfPoints(light) || (this->AtInfinity && light.Radius == 0.0);
  const bool oneSided =
    light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle || light.Shape == LightShape::Mesh;
  Light disc; // a ball is seen as one
  disc.Radius = 1.0;
  for (int k = 0; k < (whole ? 0 : inside); ++k)
  {
    const auto uv = SobolPoint(patternSeed, static_cast<std::uint32_t>(k));
    const LightSurfaceSample sample = SampleLightArea(this->OfBall ? disc : light, uv[0], uv[1]);
    this->Add(sample.Position, oneSided ? sample.Normal : Vector3{});
  }
  this->NumberOfSamples = static_cast<int>(this->Positions.size());
}

void ShadowSamples::Add(const Vector3& position, const Vector3& normal)
{
  this->Positions.push_back(position);
  this->Normals.push_back(normal);
}

void ShadowSamples::AddCorners(const Light& light)
{
  for (std::size_t k = 0; light.Triangles.empty() && k < light.Vertices.size(); ++k)
  {
    this->Add(light.Vertices[k], {});
  }
  const bool many = 3 * light.Triangles.size() > mostCorners;
  const std::set<std::array<double, 3>> extremes = many ? ExtremeCorners(light) : std::set<std::array<double, 3>>();
  for (const auto& t : light.Triangles)
  {
    for (const Vector3& corner : t)
    {
      if (!many || extremes.count({ corner.X, corner.Y, corner.Z }) > 0)
      {
        this->Add(corner, Normalized(Cross(t[1] - t[0], t[2] - t[0])));
      }
    }
  }
}

void ShadowSamples::AddSpan(const Light& light)
{
  const Frame frame = FrameAround(light.Normal);
  const auto onRim = [&](int k) // of a polygon around the unit circle
  {
    const double angle = TwoPi * k / rimPoints;
    const double radius = 1.0 / std::cos(Pi / rimPoints);
    return Vector3{ radius * std::cos(angle), radius * std::sin(angle), 0.0 };
  };
  const auto across = [&frame](const Vector3& p) { return p.X * frame.U + p.Y * frame.V; };
  if (light.Shape == LightShape::Point || (this->AtInfinity && light.Radius == 0.0))
  {
    this->Add(this->AtInfinity ? -light.Normal : light.Center, {});
    return;
  }
  if (light.Shape == LightShape::Mesh)
  {
    this->AddCorners(light);
    return;
  }
  for (int k = 0; k < rimPoints; ++k)
  {
    const Vector3 p = onRim(k);
    switch (light.Shape)
    {
      case LightShape::Disc:
        this->Add(light.Center + light.Radius * across(p), light.Normal);
        break;
      case LightShape::Sun:
        this->Add(Normalized(std::tan(std::min(light.Radius, widestSun)) * across(p) - light.Normal), {});
        break;
      case LightShape::Sphere:
        this->Add(p, {});
        break;
      default: // along the edges of a rectangle, corners among them
      {
        const double t = 2.0 * (k % 8) / 8.0 - 1.0;
        const double a[4] = { t, 1.0, -t, -1.0 };
        const double b[4] = { -1.0, t, 1.0, -t };
        this->Add(light.Center + a[k / 8] * light.AxisU + b[k / 8] * light.AxisV, light.Normal);
      }
    }
  }
}

/// From the place to the sample; unit where it is at infinity.
Vector3 ShadowSamples::Way(const Vector3& place, int sample) const
{
  const Vector3& position = this->Positions[sample];
  if (this->AtInfinity)
  {
    return position;
  }
  if (!this->OfBall)
  {
    return position - place;
  }
  // Up to the disc in which the ball ends for who looks at it: what hides it hides that disc.
  const Vector3 toCenter = this->Center - place;
  const double distance = Length(toCenter);
  const double sine = std::min(this->Radius / distance, 1.0);
  const Vector3 axis = (1.0 / distance) * toCenter;
  const Frame frame = FrameAround(axis);
  const double cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  return distance * cosine * (cosine * axis + sine * (position.X * frame.U + position.Y * frame.V));
}

std::uint64_t ShadowSamples::LookAt(const Vector3& place, int block, double* x, double* y, double* z) const
{
  std::uint64_t open = 0;
  const int first = block * blockSize;
  for (int k = 0; k < blockSize; ++k)
  {
    const int sample = first + k;
    const Vector3 way = sample < this->NumberOfSamples ? this->Way(place, sample) : Vector3{};
    x[k] = way.X;
    y[k] = way.Y;
    z[k] = way.Z;
    const bool shines = sample < this->NumberOfSamples && Dot(way, way) > 0.0 &&
      (Dot(this->Normals[sample], this->Normals[sample]) == 0.0 || Dot(this->Normals[sample], way) < 0.0);
    open |= static_cast<std::uint64_t>(shines) << k;
  }
  return open;
}

ShadowSamples::Answer ShadowSamples::Ask(const Vector3& place, bool whole) const
{
  Answer answer;
  alignas(64) double x[blockSize];
  alignas(64) double y[blockSize];
  alignas(64) double z[blockSize];
  for (int block = 0; block * blockSize < this->NumberOfSamples; ++block)
  {
    const std::uint64_t open = this->LookAt(place, block, x, y, z);
    const std::uint64_t hidden =
      open ? open & this->Scene.OccludedFrom(place, x, y, z, open, this->AtInfinity, this->Rules) : 0;
    answer.AnyHidden = answer.AnyHidden || hidden != 0;
    if (open != hidden && !answer.AnyVisible)
    {
      answer.AnyVisible = true;
      answer.FirstVisible = block * blockSize + LowestBit(open & ~hidden);
    }
    if (answer.AnyVisible && (!whole || answer.AnyHidden))
    {
      break;
    }
  }
  return answer;
}

bool ShadowSamples::HidesRay(const Vector3& place, const Vector3& to) const
{
  const double distance = Length(to);
  return distance > 0.0 &&
    this->Scene.Occluded(place, (1.0 / distance) * to, 0.0, this->AtInfinity ? HUGE_VAL : distance, this->Rules);
}

bool ShadowSamples::IsHidden(const Vector3& place, int sample) const
{
  const Vector3 way = this->Way(place, sample);
  return Dot(this->Normals[sample], way) > 0.0 || this->HidesRay(place, way);
}

bool ShadowSamples::IsHidden(const Vector3& place, const LightBody& part) const
{
  return this->HidesRay(place, part.AtInfinity() ? part.Center : part.Middle() - place);
}

} // namespace shadowcones
