// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonDiscs.h"

#include "scBoxRay.h"
#include "scConstants.h"
#include "scPhaseFunction.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace shadowcones
{
namespace
{
constexpr std::size_t lanes = 8;
/// Of the optical depth along a ray through a density, linear between them.
constexpr std::size_t knots = 256;
constexpr double noEnd = 1e30;
constexpr float threeOverPi = 0.954929658551372f;

/// exp(-x) for x from 0 up, to 3e-7 of it, and up to 87: there it ends. A plain loop around it is made wide by the compiler.
inline float FallingExp(float x)
{
  const float y = (x < 87.0f ? x : 87.0f) * -1.44269504f;
  const int whole = static_cast<int>(y - 0.5f);
  const float u = 0.693147181f * (y - static_cast<float>(whole)); // within half of log 2
  const float p = 1.0f +
    u * (1.0f + u * (0.5f + u * (0.166666667f + u * (0.0416666667f + u * (0.00833333333f + u * 0.00138888889f)))));
  const int bits = (whole + 127) << 23;
  float power;
  std::memcpy(&power, &bits, sizeof(power));
  return p * power;
}

double LengthOf(const RayInterval& part)
{
  return part.End - part.Begin;
}

float TangentOfSlant(const GatheringRay& ray)
{
  const double cosine = std::clamp(std::fabs(Dot(ray.Line.Direction, ray.Facet)), 0.1, 1.0);
  return static_cast<float>(std::sqrt(1.0 - cosine * cosine) / cosine);
}

bool EndsAtSurface(const GatheringRay& ray)
{
  return Dot(ray.Facet, ray.Facet) > 0.0;
}
} // anonymous namespace

DiscPacket::DiscPacket(const shadowcones::Medium& medium)
  : Medium(medium)
{
  for (std::size_t k = 0; k < medium.SigmaS.size(); ++k)
  {
    const auto sigmaT = static_cast<float>(medium.SigmaS[k] + medium.SigmaA[k]);
    const auto group = std::find(this->SigmaT.begin(), this->SigmaT.end(), sigmaT);
    this->GroupOf.push_back(static_cast<std::size_t>(group - this->SigmaT.begin()));
    if (group == this->SigmaT.end())
    {
      this->SigmaT.push_back(sigmaT);
    }
  }
  this->Wavelengths.resize(this->GroupOf.size());
  std::iota(this->Wavelengths.begin(), this->Wavelengths.end(), std::size_t(0));
  std::stable_sort(this->Wavelengths.begin(), this->Wavelengths.end(),
    [this](std::size_t a, std::size_t b) { return this->GroupOf[a] < this->GroupOf[b]; });
}

void DiscPacket::Clear(const Vector3& origin)
{
  this->From = origin;
  this->Rays.clear();
  this->Depths.clear();
  this->Steps.clear();
}

void DiscPacket::Add(const GatheringRay& ray, const std::function<double(double)>& depthAlong)
{
  this->Rays.push_back(ray);
  if (this->Medium.Density)
  {
    const double step = LengthOf(ray.Part) / (knots - 1);
    this->Steps.push_back(static_cast<float>(step));
    for (std::size_t k = 0; k < knots; ++k)
    {
      this->Depths.push_back(static_cast<float>(depthAlong(ray.Part.Begin + static_cast<double>(k) * step)));
    }
  }
}

/// Rays start where they enter the medium: there single precision is fine, wherever the camera is.
void DiscPacket::LayOut()
{
  this->Width = (this->Rays.size() + lanes - 1) / lanes * lanes;
  this->Lanes.assign(this->Width * NumberOfValues, 0.0f);
  std::fill_n(this->Values(End), this->Width, -1.0f); // lanes without a ray
  this->Sums.assign(this->Width * this->GroupOf.size(), 0.0f);
  this->Squares.assign(this->Width, 0.0f);
  this->All = {};
  const double share = 1.0 / static_cast<double>(this->Rays.size());
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const GatheringRay& ray = this->Rays[k];
    const Vector3 start = ray.Line.Origin + ray.Part.Begin * ray.Line.Direction - this->From;
    const Vector3 end = ray.Line.Origin + ray.Part.End * ray.Line.Direction - this->From;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Values(OriginX + axis)[k] = static_cast<float>(start[axis]);
      this->Values(AlongX + axis)[k] = static_cast<float>(ray.Line.Direction[axis]);
      this->Values(FacetX + axis)[k] = static_cast<float>(ray.Facet[axis]);
    }
    const bool ends = EndsAtSurface(ray);
    this->Values(Begin)[k] = static_cast<float>(-ray.Part.Begin);
    this->Values(End)[k] = static_cast<float>(ends ? LengthOf(ray.Part) : noEnd);
    this->Values(Beyond)[k] = ends ? TangentOfSlant(ray) : 0.0f;
    this->Values(FacetOffset)[k] = static_cast<float>(Dot(end, ray.Facet));
    this->All.Origin = this->All.Origin + share * (ray.Line.Origin - this->From);
    this->All.Direction = this->All.Direction + share * ray.Line.Direction;
    this->All.End = std::max(this->All.End, ends ? ray.Part.End : noEnd);
    this->All.Beyond = std::max(this->All.Beyond, static_cast<double>(this->Values(Beyond)[k]));
  }
  for (const GatheringRay& ray : this->Rays)
  {
    this->All.Apart = std::max(this->All.Apart, Length(ray.Line.Origin - this->From - this->All.Origin));
    this->All.Opens = std::max(this->All.Opens, Length(ray.Line.Direction - this->All.Direction));
  }
}

/// A ray is from the mean ray no farther than Apart + t Opens.
bool DiscPacket::Meets(const PhotonBalls::Node& node) const
{
  const Vector3 low{ node.Min[0], node.Min[1], node.Min[2] };
  const Vector3 high{ node.Max[0], node.Max[1], node.Max[2] };
  const Vector3 middle = 0.5 * (low + high);
  const double reach = Length(middle - this->All.Origin) + 0.5 * Length(high - low);
  // Rounding of single precision, with room.
  const double margin = this->All.Apart * (1.0 + this->All.Opens) + this->All.Opens * reach + 1e-5 * reach;
  double begin = -margin;
  double end = this->All.End + this->All.Beyond * static_cast<double>(node.Radius) + margin;
  const Vector3 room{ margin, margin, margin };
  return BoxRay(this->All.Origin, this->All.Direction).Clip({ low - room, high + room }, begin, end);
}

bool DiscPacket::Meets(const PhotonBall& ball) const
{
  const Vector3 to = Vector3{ ball.Center[0], ball.Center[1], ball.Center[2] } - this->All.Origin;
  const double squared = Dot(to, to);
  const double t = Dot(to, this->All.Direction);
  const double reach = std::sqrt(squared);
  const double margin = this->All.Apart * (1.0 + this->All.Opens) + (this->All.Opens + 1e-5) * reach + ball.Radius;
  // The mean direction is a little shorter than 1.
  const double along = Dot(this->All.Direction, this->All.Direction);
  return squared * along - t * t < margin * margin * along && t > -margin &&
    t < this->All.End + this->All.Beyond * static_cast<double>(ball.Radius) + margin;
}

/// The kernel of every ray, 0 where it does not pierce the disc. @return false where none does.
SHADOWCONES_WIDE bool DiscPacket::Weigh(const PhotonBall& ball)
{
  const std::size_t width = this->Width;
  const float* __restrict ox = this->Values(OriginX);
  const float* __restrict oy = this->Values(OriginY);
  const float* __restrict oz = this->Values(OriginZ);
  const float* __restrict dx = this->Values(AlongX);
  const float* __restrict dy = this->Values(AlongY);
  const float* __restrict dz = this->Values(AlongZ);
  const float* __restrict begin = this->Values(Begin);
  const float* __restrict end = this->Values(End);
  const float* __restrict beyond = this->Values(Beyond);
  const float* __restrict fx = this->Values(FacetX);
  const float* __restrict fy = this->Values(FacetY);
  const float* __restrict fz = this->Values(FacetZ);
  const float* __restrict offset = this->Values(FacetOffset);
  float* __restrict weight = this->Values(Weight);
  float* __restrict depth = this->Values(Depth);
  const float cx = ball.Center[0];
  const float cy = ball.Center[1];
  const float cz = ball.Center[2];
  const float radius = ball.Radius;
  const float inverse = 1.0f / (radius * radius);
  const float scale = threeOverPi * inverse;
  int any = 0;
  SHADOWCONES_APART
  for (std::size_t k = 0; k < width; ++k)
  {
    const float x = cx - ox[k];
    const float y = cy - oy[k];
    const float z = cz - oz[k];
    const float t = x * dx[k] + y * dy[k] + z * dz[k];
    const float ax = x - t * dx[k];
    const float ay = y - t * dy[k];
    const float az = z - t * dz[k];
    const float rest = 1.0f - (ax * ax + ay * ay + az * az) * inverse;
    const float front = cx * fx[k] + cy * fy[k] + cz * fz[k] - offset[k];
    const float last = end[k] + beyond[k] * radius;
    const int in = (rest > 0.0f) & (t > begin[k]) & (t < last) & (front >= 0.0f);
    any |= in;
    const float kept = rest > 0.0f ? rest : 0.0f;
    weight[k] = static_cast<float>(in) * (scale * kept * kept); // a choice would keep the loop narrow
    depth[k] = t > 0.0f ? t : 0.0f;
  }
  return any != 0;
}

/// Times the phase function.
SHADOWCONES_WIDE void DiscPacket::Scatter(const float* direction)
{
  const std::size_t width = this->Width;
  const float* __restrict dx = this->Values(AlongX);
  const float* __restrict dy = this->Values(AlongY);
  const float* __restrict dz = this->Values(AlongZ);
  float* __restrict weight = this->Values(Weight);
  float* __restrict cosines = this->Values(Mean);
  const float x = direction[0];
  const float y = direction[1];
  const float z = direction[2];
  for (std::size_t k = 0; k < width; ++k)
  {
    cosines[k] = -(x * dx[k] + y * dy[k] + z * dz[k]);
  }
  const PhaseFunction& phase = this->Medium.Phase;
  constexpr auto fourPi = static_cast<float>(4.0 * Pi);
  switch (phase.Kind)
  {
    case PhaseFunctionKind::BlasiSchlick:
    {
      const auto k1 = static_cast<float>(phase.Lobes.K1);
      const auto k2 = static_cast<float>(phase.Lobes.K2);
      const auto first = static_cast<float>(phase.Lobes.Weight) * (1.0f - k1 * k1) / fourPi;
      const auto second = static_cast<float>(1.0 - phase.Lobes.Weight) * (1.0f - k2 * k2) / fourPi;
      for (std::size_t k = 0; k < width; ++k)
      {
        const float a = 1.0f - k1 * cosines[k];
        const float b = 1.0f - k2 * cosines[k];
        weight[k] *= first / (a * a) + second / (b * b);
      }
      break;
    }
    case PhaseFunctionKind::Rayleigh:
      for (std::size_t k = 0; k < width; ++k)
      {
        weight[k] *= 0.75f / fourPi * (1.0f + cosines[k] * cosines[k]);
      }
      break;
    case PhaseFunctionKind::HenyeyGreenstein:
    {
      const auto g = static_cast<float>(phase.Asymmetry);
      const float most = (1.0f - g * g) / fourPi;
      for (std::size_t k = 0; k < width; ++k)
      {
        const float squared = 1.0f + g * g - 2.0f * g * cosines[k];
        weight[k] *= most / (squared * std::sqrt(squared));
      }
      break;
    }
    case PhaseFunctionKind::Isotropic:
      for (std::size_t k = 0; k < width; ++k)
      {
        weight[k] *= 1.0f / fourPi;
      }
      break;
  }
}

/// In a density: from distances to optical depths.
void DiscPacket::LookUpDepths()
{
  float* depth = this->Values(Depth);
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const float* table = this->Depths.data() + k * knots;
    const float at = this->Steps[k] > 0.0f ? depth[k] / this->Steps[k] : 0.0f;
    const auto last = static_cast<float>(knots - 1);
    const std::size_t knot = at < last ? static_cast<std::size_t>(at) : knots - 2;
    const float part = std::min(at, last) - static_cast<float>(knot);
    depth[k] = table[knot] + part * (table[knot + 1] - table[knot]);
  }
}

/// Add weights, attenuated, times powers to what there is.
SHADOWCONES_WIDE void DiscPacket::Collect(const float* power)
{
  const std::size_t width = this->Width;
  const float* __restrict weight = this->Values(Weight);
  const float* __restrict depth = this->Values(Depth);
  float* __restrict attenuated = this->Values(Attenuated);
  float* __restrict mean = this->Values(Mean);
  float* __restrict squares = this->Squares.data();
  const float share = 1.0f / static_cast<float>(this->Wavelengths.size());
  std::fill_n(mean, width, 0.0f);
  std::size_t next = 0;
  for (std::size_t group = 0; group < this->SigmaT.size(); ++group)
  {
    const float sigmaT = this->SigmaT[group];
    const std::size_t first = next;
    float groupMean = 0.0f;
    for (; next < this->Wavelengths.size() && this->GroupOf[this->Wavelengths[next]] == group; ++next)
    {
      groupMean += share * power[this->Wavelengths[next]];
    }
    for (std::size_t k = 0; k < width; ++k)
    {
      attenuated[k] = weight[k] * FallingExp(sigmaT * depth[k]);
    }
    for (std::size_t k = 0; k < width; ++k)
    {
      mean[k] += groupMean * attenuated[k];
    }
    for (std::size_t i = first; i < next; ++i)
    {
      const float value = power[this->Wavelengths[i]];
      float* __restrict sum = this->Sums.data() + this->Wavelengths[i] * width;
      for (std::size_t k = 0; k < width; ++k)
      {
        sum[k] += value * attenuated[k];
      }
    }
  }
  for (std::size_t k = 0; k < width; ++k)
  {
    squares[k] += mean[k] * mean[k];
  }
}

void DiscPacket::Take(const PhotonBall& ball, const float* direction, const float* power)
{
  if (!this->Weigh(ball))
  {
    return;
  }
  this->Scatter(direction);
  if (this->Medium.Density)
  {
    this->LookUpDepths();
  }
  this->Collect(power);
}

void PhotonDiscs::Gather(DiscPacket& packet) const
{
  packet.LayOut();
  if (packet.Count() == 0)
  {
    return;
  }
  const StoredPhotons& photons = this->Balls.Photons();
  this->Balls.ForEach([&packet](const PhotonBalls::Node& node) { return packet.Meets(node); },
    [&](std::size_t photon)
    {
      if (packet.Meets(this->Balls[photon]))
      {
        packet.Take(this->Balls[photon], photons.Directions.data() + 3 * photon,
          photons.Power(static_cast<vtkIdType>(photon)));
      }
    });
}

} // namespace shadowcones
