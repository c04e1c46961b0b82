// SPDX-License-Identifier: BSD-3-Clause
#include "scDensityGrid.h"

#include "scCellIndex.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace shadowcones
{

namespace
{

/// In cells: a ray in the very face of the grid lies inside, whatever the rounding.
constexpr double margin = 1e-6;

/// Index coordinates that hold every cell with a point where the density is not 0.
Box FindSupport(const DensityGrid& grid)
{
  std::array<int, 3> low = grid.Dimensions;
  std::array<int, 3> high{ { -1, -1, -1 } };
  std::array<int, 3> at{};
  const float* value = grid.Values.data();
  for (at[2] = 0; at[2] < grid.Dimensions[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < grid.Dimensions[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < grid.Dimensions[0]; ++at[0])
      {
        if (*value++ > 0.0f)
        {
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            low[axis] = std::min(low[axis], at[axis]);
            high[axis] = std::max(high[axis], at[axis]);
          }
        }
      }
    }
  }
  Box support;
  if (high[0] >= 0)
  {
    const auto from = [&low](std::size_t axis) { return std::max(low[axis] - 1, 0) - margin; };
    const auto to = [&grid, &high](std::size_t axis)
    { return std::min(high[axis] + 1, grid.Dimensions[axis] - 1) + margin; };
    support.Min = { from(0), from(1), from(2) };
    support.Max = { to(0), to(1), to(2) };
  }
  return support;
}

/**
 * Integral of the trilinear function of a cell over a stretch of a line of the length @p length, whose middle lies at
 * (u, v, w) of the cell. The function is a cubic there: its middle value and a 24th of its second derivative are enough.
 */
inline double IntegrateInCell(const float* at, const std::array<std::size_t, 3>& strides, double u, double v, double w,
  double length, const Vector3& mixed)
{
  const float* const up = at + strides[2];
  const std::size_t i = strides[0];
  const std::size_t j = strides[1];
  const double low = at[0];
  const double lowJ = at[j];
  const double high = up[0];
  const double highJ = up[j];
  // Along X, on the four edges of the cell.
  const double riseLow = at[i] - low;
  const double riseLowJ = at[i + j] - lowJ;
  const double riseHigh = up[i] - high;
  const double riseHighJ = up[i + j] - highJ;
  const double a = low + u * riseLow;
  const double b = lowJ + u * riseLowJ;
  const double c = high + u * riseHigh;
  const double d = highJ + u * riseHighJ;
  const double bottom = a + v * (b - a);
  const double top = c + v * (d - c);
  const double value = bottom + w * (top - bottom);
  const double xyLow = riseLowJ - riseLow;
  const double xyHigh = riseHighJ - riseHigh;
  const double xy = xyLow + w * (xyHigh - xyLow);
  const double xz = riseHigh - riseLow + v * (xyHigh - xyLow);
  const double yz = d - c - b + a;
  return length * (value + length * length * (mixed.X * yz + mixed.Y * xz + mixed.Z * xy));
}

/// The trilinear function of a cell along a line from (u, v, w) of it, as a cubic.
inline std::array<double, 4> CubicInCell(
  const float* at, const std::array<std::size_t, 3>& strides, const Vector3& from, const Vector3& along)
{
  const float* const up = at + strides[2];
  const std::size_t i = strides[0];
  const std::size_t j = strides[1];
  const double first = at[0];
  const double x = at[i] - first;
  const double y = at[j] - first;
  const double z = up[0] - first;
  const double xy = at[i + j] - first - x - y;
  const double xz = up[i] - first - x - z;
  const double yz = up[j] - first - y - z;
  const double xyz = up[i + j] - first - x - y - z - xy - xz - yz;
  const double u = from.X;
  const double v = from.Y;
  const double w = from.Z;
  const double a = along.X;
  const double b = along.Y;
  const double c = along.Z;
  return { { first + u * x + v * y + w * z + u * v * xy + u * w * xz + v * w * yz + u * v * w * xyz,
    a * (x + v * xy + w * xz + v * w * xyz) + b * (y + u * xy + w * yz + u * w * xyz) +
      c * (z + u * xz + v * yz + u * v * xyz),
    a * b * (xy + w * xyz) + a * c * (xz + v * xyz) + b * c * (yz + u * xyz), a * b * c * xyz } };
}

/// The walk of a ray through the cells along one axis.
struct CellWalk
{
  double Next = HUGE_VAL; ///< t of the next face
  double Step = 0.0;      ///< in t, from a face to the next
  int FacesLeft = 0;
  std::ptrdiff_t Stride = 0; ///< of the values, signed
  double Cell = 0.0;
  double Sign = 0.0;

  CellWalk(double from, double along, double tBegin, double tEnd, int dimension, std::size_t stride)
  {
    const int lastCell = std::max(dimension - 2, 0);
    const auto cellAt = [&](double t) { return CellIndex(from + t * along, lastCell); };
    const int first = cellAt(tBegin);
    this->Cell = first;
    this->FacesLeft = std::abs(cellAt(tEnd) - first);
    if (this->FacesLeft > 0)
    {
      this->Sign = along > 0.0 ? 1.0 : -1.0;
      this->Step = 1.0 / std::fabs(along);
      this->Next = (first + (along > 0.0 ? 1 : 0) - from) / along;
      this->Stride = along > 0.0 ? static_cast<std::ptrdiff_t>(stride) : -static_cast<std::ptrdiff_t>(stride);
    }
  }
  std::ptrdiff_t Advance(bool crosses)
  {
    this->FacesLeft -= crosses ? 1 : 0;
    this->Cell += crosses ? this->Sign : 0.0;
    this->Next = crosses ? (this->FacesLeft > 0 ? this->Next + this->Step : HUGE_VAL) : this->Next;
    return crosses ? this->Stride : 0;
  }
};

/// Call visit(values of the cell, its place, begin, end) for each cell that a ray passes in the grid's index coordinates.
template <class Visit>
void ForEachCell(const DensityGrid& grid, const Vector3& from, const Vector3& along, double tBegin, double tEnd, Visit&& visit)
{
  CellWalk x(from.X, along.X, tBegin, tEnd, grid.Dimensions[0], grid.Strides[0]);
  CellWalk y(from.Y, along.Y, tBegin, tEnd, grid.Dimensions[1], grid.Strides[1]);
  CellWalk z(from.Z, along.Z, tBegin, tEnd, grid.Dimensions[2], grid.Strides[2]);
  const float* at = grid.Values.data() + static_cast<std::size_t>(x.Cell) * grid.Strides[0] +
    static_cast<std::size_t>(y.Cell) * grid.Strides[1] + static_cast<std::size_t>(z.Cell) * grid.Strides[2];
  double t = tBegin;
  for (auto cells = std::int64_t(1) + x.FacesLeft + y.FacesLeft + z.FacesLeft; cells > 0; --cells)
  {
    const double next = std::min(std::min(x.Next, y.Next), std::min(z.Next, tEnd));
    visit(at, Vector3{ x.Cell, y.Cell, z.Cell }, t, next);
    t = next;
    const bool crossX = x.Next <= next;
    const bool crossY = !crossX && y.Next <= next;
    const bool crossZ = !crossX && !crossY && z.Next <= next;
    at += x.Advance(crossX) + y.Advance(crossY) + z.Advance(crossZ);
  }
}

} // namespace

double DensityGrid::Integrate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd) const
{
  const Vector3 from = this->IndexPoint(origin);
  const Vector3 along = this->IndexDirection(direction);
  if (this->Support.Empty() || !this->Support.Clip(from, along, tBegin, tEnd))
  {
    return 0.0;
  }
  if (along.X == 0.0 && along.Y == 0.0 && along.Z == 0.0)
  {
    return (tEnd - tBegin) * this->ValueAt(from); // also over an infinite length
  }
  // The second derivative along the ray is that of the mixed terms, twice: over 24, a twelfth.
  const Vector3 mixed = (1.0 / 12.0) * Vector3{ along.Y * along.Z, along.X * along.Z, along.X * along.Y };
  double sum = 0.0;
  ForEachCell(*this, from, along, tBegin, tEnd,
    [&](const float* at, const Vector3& cell, double begin, double end)
    {
      const Vector3 middle = from + 0.5 * (begin + end) * along - cell;
      sum += IntegrateInCell(at, this->Strides, middle.X, middle.Y, middle.Z, end - begin, mixed);
    });
  return sum;
}

void DensityGrid::Tabulate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd,
  std::vector<DensityStretch>& stretches) const
{
  stretches.clear();
  const Vector3 from = this->IndexPoint(origin);
  const Vector3 along = this->IndexDirection(direction);
  if (this->Support.Empty() || !this->Support.Clip(from, along, tBegin, tEnd))
  {
    stretches.emplace_back();
    return;
  }
  double depth = 0.0;
  const auto add = [&](const std::array<double, 4>& cubic, double begin, double end)
  {
    const bool none = cubic == std::array<double, 4>{ { 0.0, 0.0, 0.0, 0.0 } };
    if (!(end > begin) || (none && !stretches.empty() && stretches.back().Cubic == cubic))
    {
      return;
    }
    stretches.push_back({ begin, depth, cubic });
    depth = none ? depth : std::max(depth, stretches.back().DepthAfter(end - begin));
  };
  if (along.X == 0.0 && along.Y == 0.0 && along.Z == 0.0)
  {
    add({ { this->ValueAt(from), 0.0, 0.0, 0.0 } }, tBegin, tEnd); // also over an infinite length
  }
  else
  {
    ForEachCell(*this, from, along, tBegin, tEnd, [&](const float* at, const Vector3& cell, double begin, double end)
      { add(CubicInCell(at, this->Strides, from + begin * along - cell, along), begin, end); });
  }
  stretches.push_back({ tEnd, depth, {} });
}

bool IsConstantIn(const DensityGrid& grid, const Box& box, double& value)
{
  const float first = grid.Values.front();
  value = static_cast<double>(first);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 point{ (corner & 1 ? box.Max : box.Min).X, (corner & 2 ? box.Max : box.Min).Y,
      (corner & 4 ? box.Max : box.Min).Z };
    if (!grid.Support.Contains(grid.IndexPoint(point)))
    {
      return false;
    }
  }
  return std::all_of(grid.Values.begin(), grid.Values.end(), [first](float v) { return v == first; });
}

const char* PrepareDensityGrid(DensityGrid& grid)
{
  std::size_t size = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (grid.Dimensions[axis] < 1)
    {
      return "The density grid has no points.";
    }
    if (!IsFinite(grid.Axes[axis]))
    {
      return "The density grid has an axis that is not finite.";
    }
    grid.Strides[axis] = grid.Dimensions[axis] > 1 ? size : 0;
    size *= static_cast<std::size_t>(grid.Dimensions[axis]);
  }
  if (size != grid.Values.size())
  {
    return "The density grid has not one value for each point.";
  }
  // Places in cells are finite then, wherever they are.
  constexpr double longest = 1e18;
  constexpr double shortest = 1e-18;
  if (!(Length(grid.Origin) <= longest))
  {
    return "The origin of the density grid is not finite, or beyond 1e18.";
  }
  if (!std::all_of(grid.Values.begin(), grid.Values.end(), [](float v) { return std::isfinite(v) && v >= 0.0f; }))
  {
    return "The density grid has a value that is negative or not finite.";
  }
  const Vector3& a = grid.Axes[0];
  const Vector3& b = grid.Axes[1];
  const Vector3& c = grid.Axes[2];
  if (!(std::fabs(Dot(Normalized(a), Cross(Normalized(b), Normalized(c)))) > 1e-9))
  {
    return "The axes of the density grid do not span space.";
  }
  const double volume = Dot(a, Cross(b, c));
  const auto isStep = [](const Vector3& axis) { return Length(axis) >= shortest && Length(axis) <= longest; };
  if (!std::all_of(grid.Axes.begin(), grid.Axes.end(), isStep))
  {
    return "The density grid has an axis whose step is not from 1e-18 to 1e18.";
  }
  grid.ToIndex = { { (1.0 / volume) * Cross(b, c), (1.0 / volume) * Cross(c, a), (1.0 / volume) * Cross(a, b) } };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (grid.Dimensions[axis] == 1)
    {
      grid.ToIndex[axis] = {};
    }
  }
  grid.Support = FindSupport(grid);
  return nullptr;
}

} // namespace shadowcones
