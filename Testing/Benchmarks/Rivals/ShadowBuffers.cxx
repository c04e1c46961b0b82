// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowBuffers.h"

#include "scConstants.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int softLooks = 16;
} // namespace

//------------------------------------------------------------------------------
ShadowBuffers::ShadowBuffers(const TriangleMeshView& mesh, const Light& light, const ShadowBufferOptions& options)
  : Points(light, options.Points)
  , Bias(options.Bias * MeshBounds(mesh).Diagonal())
  , LightRadius(options.Soft ? light.Radius : 0.0)
{
  for (const Vector3& position : this->Points.Positions)
  {
    Buffer buffer{ BufferView(position, this->Points.Parallel, mesh, options.Resolution), {} };
    buffer.Depths = buffer.View.Depths(mesh);
    this->Buffers.push_back(std::move(buffer));
  }
  const std::vector<float>& first = this->Buffers.front().Depths;
  this->Nearest = *std::min_element(first.begin(), first.end());
}

//------------------------------------------------------------------------------
std::int64_t ShadowBuffers::Memory() const
{
  std::int64_t bytes = 0;
  for (const Buffer& buffer : this->Buffers)
  {
    bytes += static_cast<std::int64_t>(buffer.Depths.size() * sizeof(float));
  }
  return bytes;
}

//------------------------------------------------------------------------------
double ShadowBuffers::Compare(const Buffer& buffer, double u, double v, double depth)
{
  const int side = buffer.View.Side();
  const double left = std::floor(u - 0.5);
  const double low = std::floor(v - 0.5);
  const int i = std::clamp(static_cast<int>(left), 0, side - 2);
  const int j = std::clamp(static_cast<int>(low), 0, side - 2);
  const double a = u - 0.5 - left;
  const double b = v - 0.5 - low;
  const float* at = buffer.Depths.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(side) + i;
  const float* above = at + side;
  const auto d = static_cast<float>(depth);
  return (1.0 - b) * ((at[0] < d ? 1.0 - a : 0.0) + (at[1] < d ? a : 0.0)) +
    b * ((above[0] < d ? 1.0 - a : 0.0) + (above[1] < d ? a : 0.0));
}

//------------------------------------------------------------------------------
double ShadowBuffers::CompareSoftly(const Buffer& buffer, const BufferView::Spot& spot, double turn) const
{
  const double depth = spot.Depth - this->Bias;
  const bool parallel = this->Points.Parallel;
  // The light spans this on the buffer, in texels, for what blocks at a depth.
  const auto spanned = [&](double blocker)
  {
    const double between = std::max(0.0, spot.Depth - blocker);
    return buffer.View.Texels() * this->LightRadius * (parallel ? between : between / (spot.Depth * std::max(blocker, 1e-6)));
  };
  const auto side = static_cast<double>(buffer.View.Side());
  const auto look = [&](int k, double radius, double& u, double& v)
  {
    // Vogel's spiral.
    const double r = radius * std::sqrt((k + 0.5) / softLooks);
    const double angle = 2.39996322972865332 * k + TwoPi * turn;
    u = spot.U + r * std::cos(angle);
    v = spot.V + r * std::sin(angle);
    return u >= 0.0 && v >= 0.0 && u < side && v < side;
  };
  double u = 0.0;
  double v = 0.0;
  double sum = 0.0;
  int found = 0;
  const double searched = spanned(this->Nearest);
  for (int k = 0; k < softLooks; ++k)
  {
    if (look(k, searched, u, v))
    {
      const float held = buffer.Depths[static_cast<std::size_t>(v) * static_cast<std::size_t>(buffer.View.Side()) + static_cast<std::size_t>(u)];
      if (held < depth)
      {
        sum += held;
        ++found;
      }
    }
  }
  if (found == 0)
  {
    return 0.0;
  }
  const double radius = spanned(sum / found);
  double blocked = 0.0;
  for (int k = 0; k < softLooks; ++k)
  {
    blocked += look(k, radius, u, v) ? Compare(buffer, u, v, depth) : 0.0;
  }
  return blocked / softLooks;
}

//------------------------------------------------------------------------------
double ShadowBuffers::BlockedAt(const Vector3& x, RandomStream& random) const
{
  if (this->LightRadius > 0.0)
  {
    return this->CompareSoftly(this->Buffers.front(), this->Buffers.front().View.Look(x), random.Next());
  }
  double blocked = 0.0;
  double all = 0.0;
  for (std::size_t k = 0; k < this->Buffers.size(); ++k)
  {
    const double weight = this->Points.Weight(this->Points.Towards(static_cast<int>(k), x));
    all += weight;
    const BufferView::Spot spot = this->Buffers[k].View.Look(x);
    if (spot.Inside && weight > 0.0)
    {
      blocked += weight * Compare(this->Buffers[k], spot.U, spot.V, spot.Depth - this->Bias);
    }
  }
  return all > 0.0 ? blocked / all : 0.0;
}

} // namespace shadowcones
