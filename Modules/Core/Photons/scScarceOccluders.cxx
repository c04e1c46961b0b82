// SPDX-License-Identifier: BSD-3-Clause
#include "scScarceOccluders.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Beside the occluder, as shares of the box's sides and of its diagonal.
constexpr double marginOfSide = 0.1;
constexpr double marginOfDiagonal = 0.02;

/// Cut a range of casters in two along the longest side of their centres' box, until there are so many ranges.
void Group(const CasterBoxes& casters, std::vector<std::size_t>::iterator begin, std::vector<std::size_t>::iterator end,
  std::size_t groups, std::vector<ScarceOccluders>& result)
{
  if (groups <= 1 || end - begin <= 1)
  {
    ScarceOccluders group;
    for (auto it = begin; it != end; ++it)
    {
      group.Ids.push_back(casters.Ids[*it]);
      group.Bounds.Add(casters.Boxes[*it]);
    }
    std::sort(group.Ids.begin(), group.Ids.end());
    result.push_back(group);
    return;
  }
  Box centers;
  std::for_each(begin, end, [&](std::size_t i) { centers.Add(casters.Boxes[i].Center()); });
  const Vector3 size = centers.Size();
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
    [&](std::size_t a, std::size_t b)
    {
      const double at = casters.Boxes[a].Center()[axis];
      const double other = casters.Boxes[b].Center()[axis];
      return at < other || (at == other && a < b);
    });
  Group(casters, begin, middle, groups / 2, result);
  Group(casters, middle, end, groups - groups / 2, result);
}

Box Widened(const Box& box)
{
  const double more = marginOfDiagonal * box.Diagonal();
  const Vector3 margin = marginOfSide * box.Size() + Vector3{ more, more, more };
  return { box.Min - margin, box.Max + margin };
}
} // anonymous namespace

std::vector<ScarceOccluders> BoxesToAimAt(const CasterBoxes& casters, const std::vector<bool>& scarce, std::size_t most)
{
  std::vector<std::size_t> those;
  for (std::size_t k = 0; k < scarce.size(); ++k)
  {
    if (scarce[k])
    {
      those.push_back(k);
    }
  }
  std::vector<ScarceOccluders> groups;
  if (!those.empty())
  {
    Group(casters, those.begin(), those.end(), std::min(most, those.size()), groups);
  }
  for (ScarceOccluders& group : groups)
  {
    group.Bounds = Widened(group.Bounds);
  }
  std::stable_sort(groups.begin(), groups.end(),
    [](const ScarceOccluders& a, const ScarceOccluders& b) { return a.Bounds.Diagonal() < b.Bounds.Diagonal(); });
  return groups;
}

} // namespace shadowcones
