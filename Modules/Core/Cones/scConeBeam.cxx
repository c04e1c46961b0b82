// SPDX-License-Identifier: BSD-3-Clause
#include "scConeBeam.h"

#include "scBits.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shadowcones
{
namespace
{
/// Cones in a row, each number in a column of its own.
struct ConeColumns
{
  const double* CenterX;
  const double* CenterY;
  const double* CenterZ;
  const double* AxisX;
  const double* AxisY;
  const double* AxisZ;
  const double* Radius;
  const double* Tangent;
  const double* Height;
  double* Enter;
  double* Exit;
  std::size_t Count;
};

/// Where the ray from @p o along the unit vector @p d enters and leaves every cone; Enter > Exit: not at all.
SHADOWCONES_WIDE void MeetCones(const ConeColumns& cones, const Vector3& o, const Vector3& d)
{
  const ConeColumns c = cones;
  const double ox = o.X;
  const double oy = o.Y;
  const double oz = o.Z;
  const double dx = d.X;
  const double dy = d.Y;
  const double dz = d.Z;
  for (std::size_t k = 0; k < c.Count; ++k)
  {
    const double qx = ox - c.CenterX[k];
    const double qy = oy - c.CenterY[k];
    const double qz = oz - c.CenterZ[k];
    const double h = qx * c.AxisX[k] + qy * c.AxisY[k] + qz * c.AxisZ[k];
    const double slope = dx * c.AxisX[k] + dy * c.AxisY[k] + dz * c.AxisZ[k];
    const double dh = slope == 0.0 ? 1e-300 : slope;

    // Between the planes.
    const double low = -h / dh;
    const double high = (c.Height[k] - h) / dh;
    double enter = low < high ? low : high;
    double exit = low < high ? high : low;

    // Inside the sheet: a t^2 + 2 b t + g <= 0, as in IntersectCone.
    const double r = c.Radius[k] + h * c.Tangent[k];
    const double dr = dh * c.Tangent[k];
    const double lx = qx - h * c.AxisX[k];
    const double ly = qy - h * c.AxisY[k];
    const double lz = qz - h * c.AxisZ[k];
    const double b = lx * dx + ly * dy + lz * dz - r * dr;
    const double g = lx * lx + ly * ly + lz * lz - r * r;
    const double square = 1.0 - dh * dh - dr * dr;
    const double a = square == 0.0 ? 1e-30 : square;
    const double discriminant = b * b - a * g;
    const double root = std::sqrt(discriminant > 0.0 ? discriminant : 0.0);
    const double q = b < 0.0 ? root - b : -(root + b);
    const double t0 = q / a;
    const double t1 = q == 0.0 ? t0 : g / q;
    const double first = t0 < t1 ? t0 : t1;
    const double second = t0 < t1 ? t1 : t0;
    // a > 0: between the roots; a < 0: outside them, on the one sheet that the planes leave.
    const bool between = a > 0.0;
    const bool before = enter <= first;
    const bool real = discriminant >= 0.0;
    const double from = between ? first : (before || !real ? -HUGE_VAL : second);
    const double to = between ? (real ? second : -HUGE_VAL) : (before && real ? first : HUGE_VAL);
    enter = enter > from ? enter : from;
    exit = exit < to ? exit : to;
    c.Enter[k] = enter;
    c.Exit[k] = exit;
  }
}

/// The plane through a ray that also holds the next one, its normal towards @p inside.
BeamPlane PlaneBetween(const Ray& ray, const Ray& next, const Ray& inside)
{
  BeamPlane plane;
  plane.Normal = Normalized(Cross(ray.Direction, next.Origin + next.Direction - ray.Origin));
  plane.Offset = Dot(plane.Normal, ray.Origin);
  const double side = Dot(plane.Normal, inside.Origin + inside.Direction) - plane.Offset;
  if (side < 0.0)
  {
    plane.Normal = -plane.Normal;
    plane.Offset = -plane.Offset;
  }
  return plane;
}

/// The runs of bins that are set, of an interval cut into as many bins as there are bits.
void ListRuns(const std::uint64_t (&bits)[2], const RayInterval& whole, std::vector<RayInterval>& runs)
{
  constexpr int bins = 128;
  const double length = whole.End - whole.Begin;
  int bin = 0;
  const auto next = [&](bool set)
  {
    // The first bin from here on that is set, or not.
    while (bin < bins)
    {
      const std::uint64_t word = (set ? bits[bin / 64] : ~bits[bin / 64]) >> (bin % 64);
      if (word)
      {
        bin += LowestBit(word);
        return;
      }
      bin = (bin / 64 + 1) * 64;
    }
  };
  next(true);
  while (bin < bins)
  {
    RayInterval run;
    run.Begin = whole.Begin + length * bin / bins;
    next(false);
    run.End = bin < bins ? whole.Begin + length * bin / bins : whole.End;
    runs.push_back(run);
    next(true);
  }
}
} // anonymous namespace

ConeBeam::ConeBeam(const ConeHierarchy& cones)
  : Hierarchy(cones)
{
}

void ConeBeam::Gather(const std::array<Ray, 4>& corners)
{
  std::array<BeamPlane, 4> planes;
  for (std::size_t k = 0; k < 4; ++k)
  {
    planes[k] = PlaneBetween(corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]);
  }
  this->Hierarchy.ConesInBeam(planes, this->Ids);
  const std::size_t count = this->Ids.size();
  this->Columns.resize(NumberOfColumns * count);
  double* columns = this->Columns.data();
  for (std::size_t k = 0; k < count; ++k)
  {
    const Cone& cone = this->Hierarchy.Cones()[static_cast<std::size_t>(this->Ids[k])];
    const double tangent = std::tan(cone.HalfAngle);
    columns[CenterX * count + k] = cone.Center.X;
    columns[CenterY * count + k] = cone.Center.Y;
    columns[CenterZ * count + k] = cone.Center.Z;
    columns[AxisX * count + k] = cone.Axis.X;
    columns[AxisY * count + k] = cone.Axis.Y;
    columns[AxisZ * count + k] = cone.Axis.Z;
    columns[Radius * count + k] = cone.BaseRadius;
    columns[Tangent * count + k] = tangent;
    columns[Height * count + k] = std::min({ this->Hierarchy.Length(), TipHeight(cone.BaseRadius, tangent), 1e100 });
  }
}

void ConeBeam::Intersect(const Ray& ray, double tBegin, double tEnd, std::vector<RayInterval>& intervals)
{
  intervals.clear();
  const std::size_t count = this->Ids.size();
  if (count == 0 || !(tEnd > tBegin))
  {
    return;
  }
  double* columns = this->Columns.data();
  const auto column = [&](Column name) { return columns + name * count; };
  // Counted from where the medium begins: digits are lost with the square of a far origin.
  MeetCones({ column(CenterX), column(CenterY), column(CenterZ), column(AxisX), column(AxisY), column(AxisZ),
              column(Radius), column(Tangent), column(Height), column(Enter), column(Exit), count },
    ray.Origin + tBegin * ray.Direction, ray.Direction);

  const double* enter = column(Enter);
  const double* exit = column(Exit);
  const double length = tEnd - tBegin;
  const double perLength = Bins / length;
  std::uint64_t bits[2] = { 0, 0 };
  for (std::size_t k = 0; k < count; ++k)
  {
    if (!(enter[k] <= exit[k] && exit[k] >= 0.0 && enter[k] <= length))
    {
      continue;
    }
    // A little is added on both sides against rounding.
    const int first = static_cast<int>(std::max(0.0, enter[k] * perLength - 1e-6));
    const int last = static_cast<int>(std::min(Bins - 1.0, exit[k] * perLength + 1e-6));
    const std::uint64_t all = ~std::uint64_t(0);
    if (first < 64)
    {
      bits[0] |= (all << first) & (last < 63 ? ~(all << (last + 1)) : all);
    }
    if (last >= 64)
    {
      bits[1] |= (first > 64 ? all << (first - 64) : all) & (last < 127 ? ~(all << (last - 63)) : all);
    }
  }

  ListRuns(bits, { tBegin, tEnd }, intervals);
}

} // namespace shadowcones
