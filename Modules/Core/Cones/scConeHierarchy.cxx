// SPDX-License-Identifier: BSD-3-Clause
#include "scConeHierarchy.h"

#include "scCone.h"
#include "scConeIntervals.h"
#include "scConeSlice.h"
#include "scConeTree.h"
#include "scOccluderInterval.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{
/// Keep @p merged sorted and without overlaps while an interval joins it.
void InsertMerged(std::vector<OccluderInterval>& merged, OccluderInterval interval)
{
  interval.OccluderId = -1;
  const auto first = std::lower_bound(merged.begin(), merged.end(), interval.Begin,
    [](const OccluderInterval& other, double begin) { return other.End < begin; });
  auto last = first;
  while (last != merged.end() && last->Begin <= interval.End)
  {
    interval.Begin = std::min(interval.Begin, last->Begin);
    interval.End = std::max(interval.End, last->End);
    ++last;
  }
  if (first == last)
  {
    merged.insert(first, interval);
    return;
  }
  *first = interval;
  merged.erase(first + 1, last);
}

bool IsCovered(const std::vector<OccluderInterval>& merged, double begin, double end)
{
  const auto next = std::upper_bound(merged.begin(), merged.end(), begin,
    [](double value, const OccluderInterval& other) { return value < other.Begin; });
  return next != merged.begin() && end <= (next - 1)->End;
}
} // anonymous namespace

struct ConeHierarchy::Implementation
{
  std::vector<Cone> Cones;
  std::vector<double> Tangents;
  Box Bounds;
  double Length;
  ConeTree Tree;
};

ConeHierarchy::ConeHierarchy(std::vector<Cone> cones, const Box& bounds, double length)
  : Impl(new Implementation{ {}, {}, bounds, length, ConeTree::OverSlices(cones, bounds, length) })
{
  this->Impl->Cones = std::move(cones);
  this->Impl->Tangents.reserve(this->Impl->Cones.size());
  for (const Cone& cone : this->Impl->Cones)
  {
    this->Impl->Tangents.push_back(std::tan(cone.HalfAngle));
  }
}

ConeHierarchy::~ConeHierarchy() = default;

const std::vector<Cone>& ConeHierarchy::Cones() const
{
  return this->Impl->Cones;
}

double ConeHierarchy::Length() const
{
  return this->Impl->Length;
}

std::int64_t ConeHierarchy::Memory() const
{
  const std::size_t cones = this->Impl->Cones.capacity() * (sizeof(Cone) + sizeof(double));
  return static_cast<std::int64_t>(cones) + this->Impl->Tree.Memory();
}

void ConeHierarchy::Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
  std::vector<OccluderInterval>& intervals, bool perOccluder) const
{
  intervals.clear();
  if (!this->Impl->Bounds.Clip(origin, direction, tMin, tMax))
  {
    return;
  }
  const Ray ray{ origin, direction };
  const RayInterval part{ tMin, tMax };
  const auto intersect = [&](const ConeTree::Entry& entry, OccluderInterval& interval)
  {
    const Cone& cone = this->Impl->Cones[entry.Cone];
    interval.OccluderId = cone.OccluderId;
    return ConeSlice{ cone, this->Impl->Tangents[entry.Cone], entry.Low, entry.High }.Intersect(ray, part, interval);
  };
  OccluderInterval interval;
  if (perOccluder)
  {
    this->Impl->Tree.ForEachOnRay(origin, direction, tMin, tMax,
      [&](const ConeTree::Entry& entry)
      {
        if (intersect(entry, interval))
        {
          intervals.push_back(interval);
        }
      });
    MergeIntervals(intervals, true);
    return;
  }
  // Cones overlap so much that most of a ray's boxes lie in what is covered already: those need no look.
  this->Impl->Tree.ForEachOnRay(
    origin, direction, tMin, tMax,
    [&](const ConeTree::Entry& entry)
    {
      if (intersect(entry, interval))
      {
        InsertMerged(intervals, interval);
      }
    },
    [&](double enter, double exit) { return IsCovered(intervals, enter, exit); });
}

bool ConeHierarchy::Contains(const Vector3& point) const
{
  return this->Impl->Bounds.Contains(point) &&
    this->Impl->Tree.AnyAtPoint(point,
      [&](const ConeTree::Entry& entry) { return ConeContains(this->Impl->Cones[entry.Cone], point, entry.High); });
}

void ConeHierarchy::ConesAt(const Vector3& point, std::vector<int>& cones) const
{
  cones.clear();
  if (!this->Impl->Bounds.Contains(point))
  {
    return;
  }
  this->Impl->Tree.ForEachAtPoint(point,
    [&](const ConeTree::Entry& entry)
    {
      if (ConeContains(this->Impl->Cones[entry.Cone], point, entry.High))
      {
        cones.push_back(entry.Cone);
      }
    });
  // A cone may be met in several of its slices.
  std::sort(cones.begin(), cones.end());
  cones.erase(std::unique(cones.begin(), cones.end()), cones.end());
}

void ConeHierarchy::ConesInBeam(const std::array<BeamPlane, 4>& planes, std::vector<int>& cones) const
{
  cones.clear();
  const auto inside = [&](const Box& box)
  {
    for (const BeamPlane& plane : planes)
    {
      // The box's corner that lies deepest inside.
      const Vector3 corner{ plane.Normal.X > 0.0 ? box.Max.X : box.Min.X, plane.Normal.Y > 0.0 ? box.Max.Y : box.Min.Y,
        plane.Normal.Z > 0.0 ? box.Max.Z : box.Min.Z };
      if (Dot(plane.Normal, corner) < plane.Offset)
      {
        return false;
      }
    }
    return true;
  };
  this->Impl->Tree.ForEachInside(inside, [&](const ConeTree::Entry& entry) { cones.push_back(entry.Cone); });
  std::sort(cones.begin(), cones.end());
  cones.erase(std::unique(cones.begin(), cones.end()), cones.end());
}

void ConeHierarchy::OccludersAt(const Vector3& point, std::vector<int>& occluderIds) const
{
  this->ConesAt(point, occluderIds);
  for (int& id : occluderIds)
  {
    id = this->Impl->Cones[id].OccluderId;
  }
  std::sort(occluderIds.begin(), occluderIds.end());
  occluderIds.erase(std::unique(occluderIds.begin(), occluderIds.end()), occluderIds.end());
}

bool ConeHierarchy::MarkGrid(const Vector3& origin, const Vector3& spacing, const std::array<int, 3>& dimensions,
  const Monitor& monitor, unsigned char* marks) const
{
  const vtkIdType rows = static_cast<vtkIdType>(dimensions[1]) * dimensions[2];
  const double step = std::fabs(spacing.X);
  const Vector3 direction{ spacing.X < 0.0 ? -1.0 : 1.0, 0.0, 0.0 };
  return ParallelFor(rows, monitor,
    [&](vtkIdType firstRow, vtkIdType endOfRows)
    {
      std::vector<OccluderInterval> intervals;
      for (vtkIdType row = firstRow; row < endOfRows; ++row)
      {
        const Vector3 start = origin +
          Vector3{ 0.0, spacing.Y * static_cast<double>(row % dimensions[1]),
            spacing.Z * static_cast<double>(row / dimensions[1]) };
        unsigned char* mark = marks + row * dimensions[0];
        if (step == 0.0)
        {
          // One place: all of the row lies in a cone, or nothing.
          std::fill(mark, mark + dimensions[0], static_cast<unsigned char>(this->Contains(start) ? 1 : 0));
          continue;
        }
        std::fill(mark, mark + dimensions[0], static_cast<unsigned char>(0));
        this->Intersect(start, direction, 0.0, step * dimensions[0], intervals);
        for (const OccluderInterval& interval : intervals)
        {
          const double last = dimensions[0] - 1.0;
          const int begin = static_cast<int>(std::clamp(std::ceil(interval.Begin / step), 0.0, last + 1.0));
          const int end = static_cast<int>(std::clamp(std::floor(interval.End / step), -1.0, last));
          std::fill(mark + begin, mark + std::max(begin, end + 1), static_cast<unsigned char>(1));
        }
      }
    });
}

} // namespace shadowcones
