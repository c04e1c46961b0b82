// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfacePhotons.h"

#include "scBox.h"
#include "scConstants.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace shadowcones
{
namespace
{
/// Surfaces that are turned by more than 45 degrees are others.
constexpr float leastCosine = 0.7f;
constexpr std::size_t lanes = 8;
/// Points that lie no farther apart, in mean radii, ask together.
constexpr double radiiTogether = 3.0;

/// Points that ask together: coordinates from the photons' origin, normals, kernels, and what is found; one array each.
struct Lanes
{
  std::size_t Width;
  float* Values;

  float* At(std::size_t value) const { return this->Values + value * this->Width; }
  static constexpr std::size_t Kernel = 6;
  static constexpr std::size_t Squares = 7;
  static constexpr std::size_t Sums = 8; ///< one a wavelength
};

/// The kernel of every point, 0 where it is not within the radius or faces another way. @return false where all are 0.
SHADOWCONES_WIDE bool Weigh(const PhotonBall& ball, const float* normal, const Lanes& points)
{
  const std::size_t width = points.Width;
  const float* __restrict x = points.At(0);
  const float* __restrict y = points.At(1);
  const float* __restrict z = points.At(2);
  const float* __restrict nx = points.At(3);
  const float* __restrict ny = points.At(4);
  const float* __restrict nz = points.At(5);
  float* __restrict kernel = points.At(Lanes::Kernel);
  const float cx = ball.Center[0];
  const float cy = ball.Center[1];
  const float cz = ball.Center[2];
  const float ux = normal[0];
  const float uy = normal[1];
  const float uz = normal[2];
  const float inverse = 1.0f / (ball.Radius * ball.Radius);
  const float scale = static_cast<float>(3.0 / Pi) * inverse;
  int any = 0;
  SHADOWCONES_APART
  for (std::size_t k = 0; k < width; ++k)
  {
    const float dx = x[k] - cx;
    const float dy = y[k] - cy;
    const float dz = z[k] - cz;
    const float rest = 1.0f - (dx * dx + dy * dy + dz * dz) * inverse;
    const float cosine = nx[k] * ux + ny[k] * uy + nz[k] * uz;
    const int in = (rest > 0.0f) & (cosine >= leastCosine);
    any |= in;
    const float kept = rest > 0.0f ? rest : 0.0f;
    kernel[k] = static_cast<float>(in) * (scale * kept * kept); // a choice would keep the loop narrow
  }
  return any != 0;
}

/// Add kernels times powers to what there is.
SHADOWCONES_WIDE void Collect(const float* power, std::size_t wavelengths, const Lanes& points)
{
  const std::size_t width = points.Width;
  const float* __restrict kernel = points.At(Lanes::Kernel);
  float mean = 0.0f;
  for (std::size_t w = 0; w < wavelengths; ++w)
  {
    float* __restrict sum = points.At(Lanes::Sums + w);
    const float value = power[w];
    mean += value / static_cast<float>(wavelengths);
    for (std::size_t k = 0; k < width; ++k)
    {
      sum[k] += value * kernel[k];
    }
  }
  float* __restrict squares = points.At(Lanes::Squares);
  for (std::size_t k = 0; k < width; ++k)
  {
    squares[k] += (mean * kernel[k]) * (mean * kernel[k]);
  }
}
} // anonymous namespace

void SurfacePhotons::Estimate(SurfacePacket& packet) const
{
  packet.NumberOfWavelengths = this->Balls.Photons().NumberOfWavelengths;
  packet.Sums.assign(packet.Count() * packet.NumberOfWavelengths, 0.0);
  packet.Squares.assign(packet.Count(), 0.0);
  packet.Order.resize(packet.Count());
  std::iota(packet.Order.begin(), packet.Order.end(), std::size_t(0));
  if (!this->Empty() && packet.Count() > 0)
  {
    this->Ask(packet, 0, packet.Count());
  }
}

/// Points that lie far apart meet photons of their own: halves along the longest side.
void SurfacePhotons::Ask(SurfacePacket& packet, std::size_t begin, std::size_t end) const
{
  Box box;
  for (std::size_t k = begin; k < end; ++k)
  {
    box.Add(packet.Points[packet.Order[k]].Place);
  }
  const Vector3 size = box.Size();
  if (end - begin <= lanes || box.Diagonal() <= radiiTogether * this->MeanRadius())
  {
    this->AskTogether(packet, begin, end);
    return;
  }
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : (size.Y >= size.Z ? 1 : 2);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&packet](std::size_t k) { return packet.Order.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end),
    [&packet, axis](std::size_t a, std::size_t b)
    { return packet.Points[a].Place[axis] < packet.Points[b].Place[axis]; });
  this->Ask(packet, begin, middle);
  this->Ask(packet, middle, end);
}

void SurfacePhotons::AskTogether(SurfacePacket& packet, std::size_t begin, std::size_t end) const
{
  const std::size_t wavelengths = packet.NumberOfWavelengths;
  const std::size_t width = (end - begin + lanes - 1) / lanes * lanes;
  packet.Lanes.assign(width * (Lanes::Sums + wavelengths), 0.0f);
  const Lanes points{ width, packet.Lanes.data() };
  float low[3] = { HUGE_VALF, HUGE_VALF, HUGE_VALF };
  float high[3] = { -HUGE_VALF, -HUGE_VALF, -HUGE_VALF };
  for (std::size_t k = begin; k < end; ++k)
  {
    const auto& point = packet.Points[packet.Order[k]];
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto x = static_cast<float>((point.Place - this->Balls.Origin())[axis]);
      points.At(static_cast<std::size_t>(axis))[k - begin] = x;
      points.At(static_cast<std::size_t>(3 + axis))[k - begin] = static_cast<float>(point.Normal[axis]);
      low[axis] = std::min(low[axis], x);
      high[axis] = std::max(high[axis], x);
    }
  }
  const auto meets = [&](const float* min, const float* max, float more)
  {
    return low[0] <= max[0] + more && high[0] >= min[0] - more && low[1] <= max[1] + more && high[1] >= min[1] - more &&
      low[2] <= max[2] + more && high[2] >= min[2] - more;
  };
  const StoredPhotons& photons = this->Balls.Photons();
  this->Balls.ForEach([&](const PhotonBalls::Node& node) { return meets(node.Min, node.Max, 0.0f); },
    [&](std::size_t photon)
    {
      const PhotonBall& ball = this->Balls[photon];
      if (meets(ball.Center, ball.Center, ball.Radius) && Weigh(ball, photons.Normals.data() + 3 * photon, points))
      {
        Collect(photons.Power(static_cast<vtkIdType>(photon)), wavelengths, points);
      }
    });
  for (std::size_t k = begin; k < end; ++k)
  {
    const std::size_t point = packet.Order[k];
    packet.Squares[point] = static_cast<double>(points.At(Lanes::Squares)[k - begin]);
    for (std::size_t w = 0; w < wavelengths; ++w)
    {
      packet.Sums[point * wavelengths + w] = static_cast<double>(points.At(Lanes::Sums + w)[k - begin]);
    }
  }
}

} // namespace shadowcones
