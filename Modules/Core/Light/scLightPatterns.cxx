// SPDX-License-Identifier: BSD-3-Clause
#include "scLightPatterns.h"

#include "scBits.h"
#include "scFrame.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Patterns share this many samples, so that many samples a point do not need much memory.
constexpr int samplesOfAllPatterns = 16384;
constexpr int mostPatterns = 256;
constexpr int fewestPatterns = 4;

bool IsPlanar(const Light& light)
{
  return light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle;
}

/// Points without extent, and a Sun that is one direction.
bool IsPointlike(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Mesh && light.Triangles.empty()) ||
    (light.Shape == LightShape::Sun && !(light.Radius > 0.0));
}
} // anonymous namespace

LightPatterns::LightPatterns(const Light& light, const LightPatternOptions& options)
  : TheLight(light)
  , NumberOfSamples(options.NumberOfSamples)
  , Outline(options.Outline)
  , Seed(options.Seed)
{
  const int points =
    light.Shape == LightShape::Mesh ? static_cast<int>(std::min<std::size_t>(light.Vertices.size(), 1u << 30)) : 1;
  if (IsPointlike(light) && points <= this->NumberOfSamples)
  {
    this->NumberOfSamples = points;
    this->Exact = true;
  }
  else if (!options.Same && !options.Outline)
  {
    this->NumberOfPatterns =
      static_cast<std::size_t>(std::clamp(samplesOfAllPatterns / this->NumberOfSamples, fewestPatterns, mostPatterns));
  }
  const auto count = static_cast<std::size_t>(this->NumberOfSamples);
  this->Stride = (count + 63) / 64 * 64;
  this->Full.assign(this->Stride / 64, ~std::uint64_t(0));
  if (count % 64 != 0)
  {
    this->Full.back() = (std::uint64_t(1) << (count % 64)) - 1;
  }

  const Frame frame = FrameAround(light.Normal);
  this->U = light.Shape == LightShape::Rectangle ? light.AxisU : light.Radius * frame.U;
  this->V = light.Shape == LightShape::Rectangle ? light.AxisV : light.Radius * frame.V;
  const std::size_t all = this->NumberOfPatterns * this->Stride;
  if (IsPlanar(light) || light.Shape == LightShape::Sphere)
  {
    // Not initialised: memory that no point asks for is not touched.
    this->As.reset(new double[all]);
    this->Bs.reset(new double[all]);
  }
  else
  {
    this->Positions.resize(all);
    this->Normals.resize(light.Shape == LightShape::Mesh && !light.Triangles.empty() ? all : 0);
  }
  this->Drawn = std::make_unique<std::once_flag[]>(this->NumberOfPatterns);
}

void LightPatterns::DrawPattern(std::size_t pattern) const
{
  const std::size_t first = pattern * this->Stride;
  const std::uint64_t seed = HashSeed(this->Seed, pattern);
  for (std::size_t k = 0; k < this->Stride; ++k)
  {
    const bool padding = k >= static_cast<std::size_t>(this->NumberOfSamples);
    if (this->Exact && !padding)
    {
      this->DrawSample(first + k, (static_cast<double>(k) + 0.5) / this->NumberOfSamples, 0.5);
    }
    else if (this->Outline && !padding && k % 2 == 0)
    {
      this->DrawOutlineSample(first + k, static_cast<double>(k) / static_cast<double>(this->NumberOfSamples));
    }
    else
    {
      const auto uv = SobolPoint(seed, static_cast<std::uint32_t>(this->Outline ? k / 2 : k));
      this->DrawSample(first + k, padding ? 0.5 : uv[0], padding ? 0.5 : uv[1]);
    }
  }
}

void LightPatterns::DrawSample(std::size_t place, double u, double v) const
{
  const Light& light = this->TheLight;
  if (light.Shape == LightShape::Sphere)
  {
    Light disc;
    disc.Radius = 1.0;
    const Vector3 onDisc = SampleLightArea(disc, u, v).Position;
    this->As[place] = Dot(onDisc, FrameAround(disc.Normal).U);
    this->Bs[place] = Dot(onDisc, FrameAround(disc.Normal).V);
    return;
  }
  const LightSurfaceSample sample = SampleLightArea(light, u, v);
  if (IsPlanar(light))
  {
    const Vector3 offset = sample.Position - light.Center;
    this->As[place] = Dot(offset, this->U) / Dot(this->U, this->U);
    this->Bs[place] = Dot(offset, this->V) / Dot(this->V, this->V);
    return;
  }
  this->Positions[place] = sample.Position;
  if (!this->Normals.empty())
  {
    this->Normals[place] = sample.Normal;
  }
}

/// @param turn 0..1, around the outline; of a mesh through the corners of its triangles.
void LightPatterns::DrawOutlineSample(std::size_t place, double turn) const
{
  const Light& light = this->TheLight;
  if (light.Shape == LightShape::Mesh && !light.Triangles.empty())
  {
    const auto corner = static_cast<std::size_t>(turn * static_cast<double>(3 * light.Triangles.size()));
    const std::array<Vector3, 3>& t = light.Triangles[corner / 3];
    this->Positions[place] = t[corner % 3];
    this->Normals[place] = Normalized(Cross(t[1] - t[0], t[2] - t[0]));
    return;
  }
  // The edge of the unit square: the maps take it to the outline of every other shape.
  const double along = 4.0 * turn;
  const auto side = std::min(static_cast<int>(along), 3);
  const double rest = along - side;
  const double us[4] = { rest, 1.0, 1.0 - rest, 0.0 };
  const double vs[4] = { 0.0, rest, 1.0, 1.0 - rest };
  this->DrawSample(place, us[side], vs[side]);
}

double LightPatterns::WeightOf(const LightView& view, std::size_t k) const
{
  const Light& light = this->TheLight;
  if (light.Shape == LightShape::Sphere || light.Shape == LightShape::Sun)
  {
    return 1.0;
  }
  const Vector3 to{ view.X[k], view.Y[k], view.Z[k] };
  const double squared = Dot(to, to);
  if (IsPointlike(light))
  {
    return 1.0 / squared;
  }
  const Vector3& normal = IsPlanar(light) ? light.Normal : this->Normals[view.First + k];
  return -Dot(to, normal) / (squared * std::sqrt(squared));
}

std::size_t LightPatterns::PatternOf(const Vector3& point) const
{
  const std::uint64_t place = Mix64(BitsOf(point.X) + Mix64(BitsOf(point.Y) + Mix64(BitsOf(point.Z))));
  return static_cast<std::size_t>(HashSeed(this->Seed, place) % this->NumberOfPatterns);
}

bool LightPatterns::IsWholeFrom(const Vector3& point) const
{
  const Light& light = this->TheLight;
  const Vector3 toCenter = light.Center - point;
  switch (light.Shape)
  {
    case LightShape::Disc:
    case LightShape::Rectangle:
      return Dot(toCenter, light.Normal) < 0.0;
    case LightShape::Sphere:
      return Dot(toCenter, toCenter) > light.Radius * light.Radius;
    case LightShape::Point:
    case LightShape::Sun:
      return true;
    case LightShape::Mesh:
      break;
  }
  return this->Normals.empty();
}

void LightPatterns::LookAtSphere(const Vector3& point, std::size_t first, LightView& view) const
{
  // Uniform in the cap's solid angle: 1 - cos grows with the square of the place on the unit disc. No digits are lost
  // in small angles.
  const Vector3 toCenter = this->TheLight.Center - point;
  const double distance = Length(toCenter);
  const double radius = this->TheLight.Radius;
  if (!(distance > radius))
  {
    std::fill(view.Open.begin(), view.Open.end(), 0);
    return;
  }
  const double sine = radius / distance;
  const double cap = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
  const Vector3 axis = (1.0 / distance) * toCenter;
  const Frame frame = FrameAround(axis);
  for (std::size_t k = 0; k < this->Stride; ++k)
  {
    const double a = this->As[first + k];
    const double b = this->Bs[first + k];
    const double lift = cap * (a * a + b * b);
    const double across = std::sqrt(cap * (2.0 - lift));
    const double sineSquared = lift * (2.0 - lift);
    const double depth = std::sqrt(std::max(radius * radius - distance * distance * sineSquared, 0.0));
    const double length = distance * (1.0 - lift) - depth;
    view.X[k] = length * ((1.0 - lift) * axis.X + across * (a * frame.U.X + b * frame.V.X));
    view.Y[k] = length * ((1.0 - lift) * axis.Y + across * (a * frame.U.Y + b * frame.V.Y));
    view.Z[k] = length * ((1.0 - lift) * axis.Z + across * (a * frame.U.Z + b * frame.V.Z));
  }
}

void LightPatterns::LookFrom(const Vector3& point, LightView& view) const
{
  const Light& light = this->TheLight;
  const std::size_t pattern = this->PatternOf(point);
  std::call_once(this->Drawn[pattern], [&] { this->DrawPattern(pattern); });
  const std::size_t first = pattern * this->Stride;
  const auto count = static_cast<std::size_t>(this->NumberOfSamples);
  view.X.resize(this->Stride);
  view.Y.resize(this->Stride);
  view.Z.resize(this->Stride);
  view.Open = this->Full;
  view.First = first;
  view.A = nullptr;
  view.B = nullptr;
  const auto put = [&view](std::size_t k, const Vector3& to)
  {
    view.X[k] = to.X;
    view.Y[k] = to.Y;
    view.Z[k] = to.Z;
  };
  if (IsPlanar(light))
  {
    view.A = this->As.get() + first;
    view.B = this->Bs.get() + first;
    const Vector3 toCenter = light.Center - point;
    for (std::size_t k = 0; k < this->Stride; ++k)
    {
      view.X[k] = toCenter.X + view.A[k] * this->U.X + view.B[k] * this->V.X;
      view.Y[k] = toCenter.Y + view.A[k] * this->U.Y + view.B[k] * this->V.Y;
      view.Z[k] = toCenter.Z + view.A[k] * this->U.Z + view.B[k] * this->V.Z;
    }
    if (!(Dot(toCenter, light.Normal) < 0.0))
    {
      std::fill(view.Open.begin(), view.Open.end(), 0);
    }
    return;
  }
  if (light.Shape == LightShape::Sphere)
  {
    this->LookAtSphere(point, first, view);
    return;
  }
  for (std::size_t k = count; k < this->Stride; ++k)
  {
    put(k, {});
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector3& position = this->Positions[first + k];
    const Vector3 to = light.Shape == LightShape::Sun ? position : position - point;
    const bool open = this->Normals.empty() || Dot(to, this->Normals[first + k]) < 0.0;
    put(k, to);
    if (!open)
    {
      view.Open[k / 64] &= ~(std::uint64_t(1) << (k % 64));
    }
  }
}

} // namespace shadowcones
