// SPDX-License-Identifier: BSD-3-Clause
#include "scConeIntervals.h"

#include "scConeTree.h"

#include <algorithm>

namespace shadowcones
{
namespace
{

/// The part of [tMin, tMax] in the slice of the cone between two heights; heights where the radius would be negative excluded.
bool IntersectSlice(const Cone& cone, double tangent, double low, double high, const Vector3& origin,
  const Vector3& direction, double tMin, double tMax, RayInterval& interval)
{
  const Vector3 start = origin - cone.Center;
  const double startHeight = Dot(start, cone.Axis);
  const double dh = Dot(direction, cone.Axis);

  // Between the planes.
  if (dh != 0.0)
  {
    const double a = (low - startHeight) / dh;
    const double b = (high - startHeight) / dh;
    tMin = std::max(tMin, std::min(a, b));
    tMax = std::min(tMax, std::max(a, b));
  }
  else if (startHeight < low || startHeight > high)
  {
    return false;
  }
  if (!(tMin <= tMax))
  {
    return false;
  }

  // Roots are counted from the point nearest to the cone's centre: digits are lost with the square of a far origin.
  const double nearest = -Dot(start, direction) / Dot(direction, direction);
  const Vector3 offset = start + nearest * direction;
  const double h = Dot(offset, cone.Axis);

  // Inside the sheet: |lateral|^2 <= (r + h tan)^2, appendix A with the apex moved to where the radius is 0.
  const Vector3 lateral = offset - h * cone.Axis;
  const Vector3 dLateral = direction - dh * cone.Axis;
  const double radius = cone.BaseRadius + h * tangent;
  const double dRadius = dh * tangent;
  const double a = Dot(dLateral, dLateral) - dRadius * dRadius;
  const double b = Dot(lateral, dLateral) - radius * dRadius;
  const double c = Dot(lateral, lateral) - radius * radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0)
  {
    if (a > 0.0)
    {
      return false;
    }
  }
  else
  {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double t0 = a != 0.0 ? q / a : std::copysign(HUGE_VAL, q);
    const double t1 = q != 0.0 ? c / q : t0;
    const double first = nearest + std::min(t0, t1);
    const double second = nearest + std::max(t0, t1);
    if (a > 0.0 || (a == 0.0 && b != 0.0))
    {
      // a == 0: one root at infinity; the inside lies towards decreasing quadratic.
      const double from = a > 0.0 ? first : (b > 0.0 ? -HUGE_VAL : nearest - 0.5 * c / b);
      const double to = a > 0.0 ? second : (b > 0.0 ? nearest - 0.5 * c / b : HUGE_VAL);
      tMin = std::max(tMin, from);
      tMax = std::min(tMax, to);
    }
    else if (a < 0.0)
    {
      // Outside the roots, on one sheet each; the planes leave room for one of them only.
      if (tMin <= first)
      {
        tMax = std::min(tMax, first);
      }
      else
      {
        tMin = std::max(tMin, second);
      }
    }
    else if (c > 0.0)
    {
      return false;
    }
  }
  if (!(tMin <= tMax))
  {
    return false;
  }
  interval = { tMin, tMax, cone.OccluderId };
  return true;
}

/// Keep @p merged sorted and without overlaps while an interval joins it.
void InsertMerged(std::vector<RayInterval>& merged, RayInterval interval)
{
  interval.OccluderId = -1;
  const auto first = std::lower_bound(merged.begin(), merged.end(), interval.Begin,
    [](const RayInterval& other, double begin) { return other.End < begin; });
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

bool IsCovered(const std::vector<RayInterval>& merged, double begin, double end)
{
  const auto next = std::upper_bound(
    merged.begin(), merged.end(), begin, [](double value, const RayInterval& other) { return value < other.Begin; });
  return next != merged.begin() && end <= (next - 1)->End;
}

double TipHeight(const Cone& cone)
{
  return cone.HalfAngle < 0.0 ? cone.BaseRadius / std::tan(-cone.HalfAngle) : HUGE_VAL;
}

} // anonymous namespace

bool ConeContains(const Cone& cone, const Vector3& point, double length)
{
  const Vector3 offset = point - cone.Center;
  const double h = Dot(offset, cone.Axis);
  const double radius = cone.BaseRadius + h * std::tan(cone.HalfAngle);
  const Vector3 lateral = offset - h * cone.Axis;
  return h >= 0.0 && h <= length && radius >= 0.0 && Dot(lateral, lateral) <= radius * radius;
}

bool IntersectCone(const Cone& cone, double length, const Vector3& origin, const Vector3& direction, double tMin,
  double tMax, RayInterval& interval)
{
  const double high = std::min(length, TipHeight(cone));
  return IntersectSlice(cone, std::tan(cone.HalfAngle), 0.0, high, origin, direction, tMin, tMax, interval);
}

void MergeIntervals(std::vector<RayInterval>& intervals, bool perOccluder)
{
  if (!perOccluder)
  {
    for (RayInterval& interval : intervals)
    {
      interval.OccluderId = -1;
    }
  }
  std::sort(intervals.begin(), intervals.end(), [](const RayInterval& a, const RayInterval& b) {
    return a.OccluderId != b.OccluderId ? a.OccluderId < b.OccluderId : a.Begin < b.Begin;
  });
  std::size_t last = 0;
  for (std::size_t i = 1; i < intervals.size(); ++i)
  {
    if (intervals[i].OccluderId == intervals[last].OccluderId && intervals[i].Begin <= intervals[last].End)
    {
      intervals[last].End = std::max(intervals[last].End, intervals[i].End);
    }
    else
    {
      intervals[++last] = intervals[i];
    }
  }
  intervals.resize(intervals.empty() ? 0 : last + 1);
  if (perOccluder)
  {
    std::stable_sort(intervals.begin(), intervals.end(),
      [](const RayInterval& a, const RayInterval& b) { return a.Begin < b.Begin; });
  }
}

Cone ConeAroundBox(const Box& box)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  const double spare = 0.01 * box.Diagonal() + 1e-6 * std::max(Length(box.Min), Length(box.Max));
  cone.Center = { box.Center().X, box.Center().Y, box.Min.Z - spare };
  cone.BaseRadius = 0.5 * std::hypot(box.Size().X, box.Size().Y) + spare;
  cone.InnerHalfAngle = -1.5;
  return cone;
}

std::vector<Cone> Lengthened(std::vector<Cone> cones)
{
  for (Cone& cone : cones)
  {
    const double before = cone.BaseRadius;
    cone.Center = cone.Center - before * cone.Axis;
    cone.BaseRadius += std::max(0.0, -before * std::tan(cone.HalfAngle));
  }
  return cones;
}

struct ConeHierarchy::Implementation
{
  std::vector<Cone> Cones;
  std::vector<double> Tangents;
  Box Bounds;
  double Length;
  ConeTree Tree;
};

ConeHierarchy::ConeHierarchy(const std::vector<Cone>& cones, const Box& bounds, double length)
  : Impl(new Implementation{ cones, {}, bounds, length, ConeTree::OverSlices(cones, bounds, length) })
{
  for (const Cone& cone : cones)
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

void ConeHierarchy::Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
  std::vector<RayInterval>& intervals, bool perOccluder) const
{
  intervals.clear();
  if (!this->Impl->Bounds.Clip(origin, direction, tMin, tMax))
  {
    return;
  }
  const auto intersect = [&](const ConeTree::Entry& entry, RayInterval& interval) {
    return IntersectSlice(this->Impl->Cones[entry.Cone], this->Impl->Tangents[entry.Cone], entry.Low, entry.High, origin,
      direction, tMin, tMax, interval);
  };
  RayInterval interval;
  if (perOccluder)
  {
    this->Impl->Tree.ForEachOnRay(origin, direction, tMin, tMax, [&](const ConeTree::Entry& entry) {
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
    [&](const ConeTree::Entry& entry) {
      if (intersect(entry, interval))
      {
        InsertMerged(intervals, interval);
      }
    },
    [&](double enter, double exit) { return IsCovered(intervals, enter, exit); });
}

bool ConeHierarchy::Contains(const Vector3& point) const
{
  return this->Impl->Bounds.Contains(point) && this->Impl->Tree.AnyAtPoint(point, [&](const ConeTree::Entry& entry) {
    return ConeContains(this->Impl->Cones[entry.Cone], point, entry.High);
  });
}

void ConeHierarchy::ConesAt(const Vector3& point, std::vector<int>& cones) const
{
  cones.clear();
  if (!this->Impl->Bounds.Contains(point))
  {
    return;
  }
  this->Impl->Tree.ForEachAtPoint(point, [&](const ConeTree::Entry& entry) {
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
  const auto inside = [&](const Box& box) {
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
  return ParallelFor(rows, monitor, [&](vtkIdType firstRow, vtkIdType endOfRows) {
    std::vector<RayInterval> intervals;
    for (vtkIdType row = firstRow; row < endOfRows; ++row)
    {
      const Vector3 start = origin +
        Vector3{ 0.0, spacing.Y * static_cast<double>(row % dimensions[1]), spacing.Z * static_cast<double>(row / dimensions[1]) };
      unsigned char* mark = marks + row * dimensions[0];
      if (step == 0.0)
      {
        // One place: all of the row lies in a cone, or nothing.
        std::fill(mark, mark + dimensions[0], static_cast<unsigned char>(this->Contains(start) ? 1 : 0));
        continue;
      }
      std::fill(mark, mark + dimensions[0], static_cast<unsigned char>(0));
      this->Intersect(start, direction, 0.0, step * dimensions[0], intervals);
      for (const RayInterval& interval : intervals)
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
