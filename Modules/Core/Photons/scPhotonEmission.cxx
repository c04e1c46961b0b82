// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonEmission.h"

#include "scConstants.h"
#include "scFrame.h"
#include "scRandom.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{

/// Choose among weights with u, and leave in u what can be used again. @return -1 where all weights are 0.
int ChooseAndReuse(const double (&weights)[6], double total, double& u)
{
  double target = u * total;
  int last = -1;
  for (int i = 0; i < 6; ++i)
  {
    if (weights[i] <= 0.0)
    {
      continue;
    }
    last = i;
    if (target < weights[i])
    {
      u = target / weights[i];
      return i;
    }
    target -= weights[i];
  }
  u = 0.5;
  return last;
}

double Sum(const double (&weights)[6])
{
  return std::accumulate(std::begin(weights), std::end(weights), 0.0);
}
} // anonymous namespace

PhotonEmission::PhotonEmission(const Light& light, const TriangleMeshView& mesh)
  : PhotonEmission(light, CasterBounds(mesh), MeshBounds(mesh).Diagonal())
{
}

PhotonEmission::PhotonEmission(const Light& light, const Box& target, double whole)
  : Lamp(light)
  , Bounds(target)
  , Whole(whole)
{
  const auto count = static_cast<double>(std::max<std::size_t>(light.Spectrum.size(), 1));
  this->MeanRadiance = std::accumulate(light.Spectrum.begin(), light.Spectrum.end(), 0.0) / count;
  this->Area = LightArea(light);
  this->IsPoint = !IsAtInfinity(light) && !(this->Area > 0.0);
  if (target.Empty())
  {
    return;
  }
  // A margin keeps flat occluders from being aimed at edge on.
  const double margin = 1e-4 * this->Bounds.Diagonal();
  this->Bounds.Min = this->Bounds.Min - Vector3{ margin, margin, margin };
  this->Bounds.Max = this->Bounds.Max + Vector3{ margin, margin, margin };

  const Vector3 half = 0.5 * this->Bounds.Size();
  const Vector3 axes[3] = { { half.X, 0.0, 0.0 }, { 0.0, half.Y, 0.0 }, { 0.0, 0.0, half.Z } };
  for (int i = 0; i < 6; ++i)
  {
    const int axis = i / 2;
    const double sign = i % 2 ? 1.0 : -1.0;
    Light& face = this->Faces[i];
    face.Shape = LightShape::Rectangle;
    face.Center = this->Bounds.Center() + sign * axes[axis];
    face.Normal = Normalized(sign * axes[axis]);
    face.AxisU = axes[(axis + 1) % 3];
    face.AxisV = axes[(axis + 2) % 3];
  }
}

EmittedPhoton PhotonEmission::Emit(std::uint64_t seed, vtkIdType index) const
{
  // Indices of the sequence have 32 bits: later photons take another one.
  const auto sequence = static_cast<std::uint64_t>(index) >> 32;
  const auto point = SobolPoint(sequence ? HashSeed(seed, sequence) : seed, static_cast<std::uint32_t>(index));
  double u[4] = { point[0], point[1], point[2], point[3] };
  if (this->Bounds.Empty())
  {
    return {};
  }
  if (IsAtInfinity(this->Lamp))
  {
    return this->EmitFromSun(u);
  }

  const LightSurfaceSample start = SampleLightArea(this->Lamp, u[0], u[1]);
  if (this->Bounds.Contains(start.Position))
  {
    return this->EmitOverHemisphere(start, u[2], u[3]);
  }
  double angles[6];
  for (int i = 0; i < 6; ++i)
  {
    angles[i] = LightSolidAngle(this->Faces[i], start.Position);
  }
  EmittedPhoton photon;
  photon.Origin = start.Position;
  photon.SolidAngle = Sum(angles);
  const int face = ChooseAndReuse(angles, photon.SolidAngle, u[2]);
  if (face < 0)
  {
    return photon;
  }
  photon.Direction = SampleLightSolidAngle(this->Faces[face], start.Position, u[2], u[3]).Direction;
  const double emitted = this->IsPoint ? 1.0 : std::max(0.0, Dot(photon.Direction, start.Normal));
  photon.Power = this->MeanRadiance * emitted * photon.SolidAngle / start.Pdf;
  return photon;
}

double PhotonEmission::Power() const
{
  if (IsAtInfinity(this->Lamp))
  {
    const Vector3 size = this->Bounds.Empty() ? Vector3() : this->Bounds.Size();
    const Vector3& normal = this->Lamp.Normal;
    return this->MeanRadiance *
      (std::fabs(normal.X) * size.Y * size.Z + std::fabs(normal.Y) * size.Z * size.X +
        std::fabs(normal.Z) * size.X * size.Y);
  }
  const auto points = static_cast<double>(std::max<std::size_t>(this->Lamp.Vertices.size(), 1));
  return Pi * this->MeanRadiance * (this->IsPoint ? 4.0 * points : this->Area);
}

EmittedPhoton PhotonEmission::EmitFromSun(const double (&u)[4]) const
{
  // The Sun's "position" is the direction towards the sampled point of its face.
  const Vector3 towards = SampleLightArea(this->Lamp, u[0], u[1]).Position;
  EmittedPhoton photon;
  photon.Direction = -towards;
  photon.SolidAngle = 4.0 * Pi * std::pow(std::sin(0.5 * this->Lamp.Radius), 2);

  double shadows[6]; // areas of the faces that are lit, projected along the light
  for (int i = 0; i < 6; ++i)
  {
    const Light& face = this->Faces[i];
    shadows[i] = 4.0 * Length(face.AxisU) * Length(face.AxisV) * std::max(0.0, Dot(face.Normal, towards));
  }
  const double total = Sum(shadows);
  double along = u[2];
  const int face = ChooseAndReuse(shadows, total, along);
  if (face < 0)
  {
    return photon;
  }
  const Vector3 entry = SampleLightArea(this->Faces[face], along, u[3]).Position;
  photon.Origin = entry + std::max(this->Whole, this->Bounds.Diagonal()) * towards;
  photon.Power = this->MeanRadiance * total;
  return photon;
}

EmittedPhoton PhotonEmission::EmitOverHemisphere(const LightSurfaceSample& start, double u, double v) const
{
  EmittedPhoton photon;
  photon.Origin = start.Position;
  const double azimuth = 2.0 * Pi * v;
  if (this->IsPoint)
  {
    const double z = 1.0 - 2.0 * u;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    photon.Direction = { r * std::cos(azimuth), r * std::sin(azimuth), z };
    photon.SolidAngle = 4.0 * Pi;
    photon.Power = this->MeanRadiance * photon.SolidAngle / start.Pdf;
    return photon;
  }
  // Directions in proportion to the cosine: every photon carries the same flux.
  const Frame frame = FrameAround(start.Normal);
  const double r = std::sqrt(u);
  photon.Direction = Normalized(r * std::cos(azimuth) * frame.U + r * std::sin(azimuth) * frame.V +
    std::sqrt(std::max(0.0, 1.0 - u)) * start.Normal);
  photon.SolidAngle = 2.0 * Pi;
  photon.Power = this->MeanRadiance * Pi / start.Pdf;
  return photon;
}

} // namespace shadowcones
