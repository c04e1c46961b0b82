// SPDX-License-Identifier: BSD-3-Clause
#include "scLightShares.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{
constexpr vtkIdType shortestPattern = 1024;
/// Photons in a pattern for each light, at least.
constexpr vtkIdType leastOfPattern = 16;
/// Of an equal share.
constexpr double smallestShare = 0.125;

/// Shares that add up to 1.
std::vector<double> SharesOf(const std::vector<double>& powers)
{
  const double total = std::accumulate(powers.begin(), powers.end(), 0.0);
  const auto count = static_cast<double>(powers.size());
  std::vector<double> shares;
  for (const double power : powers)
  {
    const double share = total > 0.0 ? power / total : 1.0 / count;
    shares.push_back(share > 0.0 ? std::max(share, smallestShare / count) : 0.0);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares)
  {
    share /= sum;
  }
  return shares;
}

/// Whole numbers in proportion to shares, with the sum @p total: rounded down, then up where most is missing.
std::vector<vtkIdType> Apportion(const std::vector<double>& shares, vtkIdType total)
{
  std::vector<vtkIdType> parts;
  for (const double share : shares)
  {
    parts.push_back(static_cast<vtkIdType>(share * static_cast<double>(total)));
  }
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto missing = [&](std::size_t i)
  { return shares[i] * static_cast<double>(total) - static_cast<double>(parts[i]); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return missing(a) > missing(b); });
  const vtkIdType left = total - std::accumulate(parts.begin(), parts.end(), vtkIdType(0));
  for (vtkIdType k = 0; k < left; ++k)
  {
    ++parts[order[static_cast<std::size_t>(k) % order.size()]];
  }
  return parts;
}
} // anonymous namespace

LightShares::LightShares(const std::vector<double>& powers)
{
  const auto count = static_cast<vtkIdType>(powers.size());
  const vtkIdType length = count > 1 ? std::max(shortestPattern, leastOfPattern * count) : 1;
  this->InPattern = Apportion(SharesOf(powers), length);
  for (std::size_t light = 0; light < powers.size(); ++light)
  {
    for (vtkIdType k = 0; k < this->InPattern[light]; ++k)
    {
      this->Pattern.push_back({ static_cast<int>(light), k });
    }
  }
  // Each light's photons spread evenly over the pattern.
  const auto turn = [this](const LightPhoton& photon)
  {
    return (static_cast<double>(photon.Index) + 0.5) /
      static_cast<double>(this->InPattern[static_cast<std::size_t>(photon.Light)]);
  };
  std::stable_sort(this->Pattern.begin(), this->Pattern.end(),
    [&](const LightPhoton& a, const LightPhoton& b) { return turn(a) < turn(b); });
}

LightShares::LightPhoton LightShares::At(vtkIdType photon) const
{
  const auto length = static_cast<vtkIdType>(this->Pattern.size());
  LightPhoton found = this->Pattern[static_cast<std::size_t>(photon % length)];
  found.Index += photon / length * this->InPattern[static_cast<std::size_t>(found.Light)];
  return found;
}

std::vector<vtkIdType> LightShares::Counts(vtkIdType photons) const
{
  const auto length = static_cast<vtkIdType>(this->Pattern.size());
  std::vector<vtkIdType> counts;
  for (const vtkIdType inPattern : this->InPattern)
  {
    counts.push_back(photons / length * inPattern);
  }
  for (vtkIdType k = 0; k < photons % length; ++k)
  {
    ++counts[static_cast<std::size_t>(this->Pattern[static_cast<std::size_t>(k)].Light)];
  }
  return counts;
}

} // namespace shadowcones
