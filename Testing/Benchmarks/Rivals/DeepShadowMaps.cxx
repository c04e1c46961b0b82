// SPDX-License-Identifier: BSD-3-Clause
#include "DeepShadowMaps.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

//------------------------------------------------------------------------------
void CompressSteps(const std::vector<float>& depths, int samples, double tolerance, std::vector<DepthNode>& nodes)
{
  if (depths.empty())
  {
    return;
  }
  DepthNode from{ depths.front(), 0.0f };
  DepthNode last = from;
  nodes.push_back(from);
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  const auto emit = [&](double slope)
  {
    from = { last.Depth, static_cast<float>(from.Blocked + slope * (last.Depth - from.Depth)) };
    nodes.push_back(from);
    low = -HUGE_VAL;
    high = HUGE_VAL;
  };
  const auto add = [&](float depth, double blocked)
  {
    // A step has the width of the next number.
    const float next = std::max(depth, std::nextafter(last.Depth, HUGE_VALF));
    const auto narrow = [&]
    {
      const double length = static_cast<double>(next) - from.Depth;
      const double newLow = std::max(low, (blocked - tolerance - from.Blocked) / length);
      const double newHigh = std::min(high, (blocked + tolerance - from.Blocked) / length);
      if (newLow > newHigh)
      {
        return false;
      }
      low = newLow;
      high = newHigh;
      return true;
    };
    if (!narrow())
    {
      emit(0.5 * (low + high));
      narrow();
    }
    last = { next, static_cast<float>(blocked) };
  };
  for (std::size_t k = 0; k < depths.size(); ++k)
  {
    const double before = static_cast<double>(k) / samples;
    if (depths[k] > last.Depth)
    {
      add(depths[k], before);
    }
    add(depths[k], before + 1.0 / samples);
  }
  // The last value holds for ever: as near to it as the lines before allow.
  emit(std::clamp((static_cast<double>(last.Blocked) - from.Blocked) / (static_cast<double>(last.Depth) - from.Depth), low, high));
}

//------------------------------------------------------------------------------
double BlockedAtDepth(const DepthNode* begin, const DepthNode* end, float depth)
{
  const DepthNode* after =
    std::upper_bound(begin, end, depth, [](float d, const DepthNode& node) { return d < node.Depth; });
  if (after == begin)
  {
    return 0.0;
  }
  const DepthNode& a = *(after - 1);
  if (after == end)
  {
    return a.Blocked;
  }
  return a.Blocked + (after->Blocked - a.Blocked) * (depth - a.Depth) / (after->Depth - a.Depth);
}

//------------------------------------------------------------------------------
DeepShadowMaps::DeepShadowMaps(const TriangleMeshView& mesh, const Light& light, const DeepShadowMapOptions& options)
  : Points(light, options.Points)
  , Side(options.Resolution)
  , Samples(options.Samples)
  , Bias(options.Bias * MeshBounds(mesh).Diagonal())
{
  const int fine = this->Side * this->Samples;
  std::vector<float> steps;
  for (const Vector3& position : this->Points.Positions)
  {
    Map map{ BufferView(position, this->Points.Parallel, mesh, fine), {}, {} };
    const std::vector<float> depths = map.View.Depths(mesh);
    for (int texel = 0; texel < this->Side * this->Side; ++texel)
    {
      map.Begin.push_back(static_cast<std::uint32_t>(map.Nodes.size()));
      steps.clear();
      for (int k = 0; k < this->Samples * this->Samples; ++k)
      {
        const int i = texel % this->Side * this->Samples + k % this->Samples;
        const int j = texel / this->Side * this->Samples + k / this->Samples;
        const float depth = depths[static_cast<std::size_t>(j) * static_cast<std::size_t>(fine) + static_cast<std::size_t>(i)];
        if (depth < HUGE_VALF)
        {
          steps.push_back(depth);
        }
      }
      std::sort(steps.begin(), steps.end());
      CompressSteps(steps, this->Samples * this->Samples, options.Tolerance, map.Nodes);
    }
    map.Begin.push_back(static_cast<std::uint32_t>(map.Nodes.size()));
    map.Nodes.shrink_to_fit();
    this->Maps.push_back(std::move(map));
  }
}

//------------------------------------------------------------------------------
std::int64_t DeepShadowMaps::Memory() const
{
  std::size_t bytes = 0;
  for (const Map& map : this->Maps)
  {
    bytes += map.Begin.size() * sizeof(std::uint32_t) + map.Nodes.size() * sizeof(DepthNode);
  }
  return static_cast<std::int64_t>(bytes);
}

//------------------------------------------------------------------------------
double DeepShadowMaps::Blocked(const Map& map, const BufferView::Spot& spot) const
{
  const double u = spot.U / this->Samples - 0.5;
  const double v = spot.V / this->Samples - 0.5;
  const int i = static_cast<int>(std::floor(u));
  const int j = static_cast<int>(std::floor(v));
  const auto depth = static_cast<float>(spot.Depth - this->Bias);
  double blocked = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const int x = i + (corner & 1);
    const int y = j + (corner >> 1);
    if (x >= 0 && y >= 0 && x < this->Side && y < this->Side)
    {
      const std::uint32_t* at = map.Begin.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Side) + static_cast<std::size_t>(x);
      const double share = (1.0 - std::fabs(u - x)) * (1.0 - std::fabs(v - y));
      blocked += at[0] < at[1] ? share * BlockedAtDepth(map.Nodes.data() + at[0], map.Nodes.data() + at[1], depth) : 0.0;
    }
  }
  return blocked;
}

//------------------------------------------------------------------------------
double DeepShadowMaps::BlockedAt(const Vector3& x, RandomStream&) const
{
  double blocked = 0.0;
  double all = 0.0;
  for (std::size_t k = 0; k < this->Maps.size(); ++k)
  {
    const double weight = this->Points.Weight(this->Points.Towards(static_cast<int>(k), x));
    all += weight;
    const BufferView::Spot spot = this->Maps[k].View.Look(x);
    if (spot.Inside && weight > 0.0)
    {
      blocked += weight * this->Blocked(this->Maps[k], spot);
    }
  }
  return all > 0.0 ? blocked / all : 0.0;
}

} // namespace shadowcones
