// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityGridFiller.h
 * @brief The steps of FillVisibilityGrid: marking, vertices, and the bricks of cells that are refined. Internal to Core.
 */
#ifndef scVisibilityGridFiller_h
#define scVisibilityGridFiller_h

#include "scCone.h"
#include "scLight.h"
#include "scParallel.h"
#include "scTeam.h"
#include "scTrilinear.h"
#include "scVisibilityGrid.h"
#include "scVisibilitySampler.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shadowcones
{

/// Where along an axis of a grid, or brick, a coordinate lies: the vertex before it and the fraction of the way to the next.
struct CellCoordinate
{
  int Index;
  double Fraction;

  CellCoordinate(double coordinate, int vertices)
    : Index(std::clamp(static_cast<int>(coordinate), 0, vertices - 2))
    , Fraction(std::clamp(coordinate - this->Index, 0.0, 1.0))
  {
  }
};

/// @param values of a grid with @p nx, @p ny vertices along x and y.
inline double ValueAt(const float* values, std::size_t nx, std::size_t ny, const CellCoordinate& x, const CellCoordinate& y,
  const CellCoordinate& z)
{
  const auto at = [](const CellCoordinate& c) { return static_cast<std::size_t>(c.Index); };
  return Trilinear(values + (at(z) * ny + at(y)) * nx + at(x), 1, nx, nx * ny, x.Fraction, y.Fraction, z.Fraction);
}

/// A cube inside a brick: its first corner in the brick's own grid. Its side is that of all cubes of the same round.
struct BrickPart
{
  std::size_t Brick;
  std::array<int, 3> Corner;
};

/**
 * What collect(row, visit) hands to visit(id) for rows 0..count - 1, in their order. It is called twice for each row, to count
 * and to write, so that nothing is held twice. @return false where aborted.
 */
template <typename Collector>
bool CollectRows(vtkIdType count, const Monitor& monitor, const Collector& collect, std::vector<vtkIdType>& all)
{
  std::vector<std::size_t> begins(static_cast<std::size_t>(std::max<vtkIdType>(0, count)) + 1, 0);
  const auto forEachRow = [&](const Monitor& part, const auto& use)
  {
    return ParallelFor(count, part,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          use(row, begins[static_cast<std::size_t>(row) + 1]);
        }
      });
  };
  const auto countRow = [&](vtkIdType row, std::size_t& number) { collect(row, [&number](vtkIdType) { number += 1; }); };
  if (!forEachRow(monitor.Part(0.0, 0.5), countRow))
  {
    return false;
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  all.resize(begins.back());
  const auto writeRow = [&](vtkIdType row, const std::size_t&)
  {
    auto at = all.begin() + static_cast<std::ptrdiff_t>(begins[static_cast<std::size_t>(row)]);
    collect(row, [&at](vtkIdType id) { *at++ = id; });
  };
  return forEachRow(monitor.Part(0.5, 1.0), writeRow);
}

constexpr vtkIdType pointsPerBlock = 64; // dealt out to processes: near ones take about as long

/// The steps of FillVisibilityGrid.
class VisibilityGridFiller
{
public:
  VisibilityGridFiller(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityGridOptions& options, VisibilityGrid& grid);

  bool Fill(const Box& bounds, const Monitor& monitor)
  {
    return this->Mark(bounds, monitor.Part(0.0, 0.1)) && this->FillVertices(monitor.Part(0.1, 0.5)) &&
      (this->Options.BrickParts < 2 || this->FillBricks(monitor.Part(0.5, 1.0)));
  }

private:
  bool Mark(const Box& bounds, const Monitor& monitor);
  bool FillWholeFluence(const Monitor& monitor);
  bool FillVertices(const Monitor& monitor);
  template <typename Asker>
  bool AskShare(const TeamShare& share, TeamJoin& join, const Monitor& monitor, const Asker& ask);
  bool FillBricks(const Monitor& monitor);
  bool FindBricks(const Monitor& monitor, std::vector<BrickPart>& parts);
  bool NeedsBrick(int i, int j, int k) const;
  template <typename Visitor>
  void ForEachInside(const BrickPart& part, int step, int smaller, const Visitor& visit);
  bool AskInside(const std::vector<BrickPart>& parts, int step, int smaller, const Monitor& monitor);
  void SplitPart(const BrickPart& part, int step, int smaller, std::vector<BrickPart>& unresolved);
  void Split(const std::vector<BrickPart>& parts, int step, int smaller, std::vector<BrickPart>& unresolved);
  std::array<vtkIdType, 3> CellAt(vtkIdType cell) const
  {
    const vtkIdType nx = this->Grid.Dimensions[0] - 1;
    const vtkIdType ny = this->Grid.Dimensions[1] - 1;
    return { cell % nx, cell / nx % ny, cell / nx / ny };
  }
  /// The value at a place of a brick's own grid.
  float& BrickValue(std::size_t brick, int a, int b, int c)
  {
    const auto side = static_cast<std::size_t>(this->Grid.BrickParts) + 1;
    const std::size_t row = (brick * side + static_cast<std::size_t>(c)) * side + static_cast<std::size_t>(b);
    return this->Grid.BrickVisibility[row * side + static_cast<std::size_t>(a)];
  }

  const std::vector<Cone>& Cones;
  const Light& Lamp;
  const VisibilityGridOptions& Options;
  VisibilityGrid& Grid;
  VisibilitySampler Asked;
  std::array<int, 3> First{};
  std::array<int, 3> Last{};
};

/// ask(begin, end), which returns the rays it sent, for this process's share; then all have all answers, and the sum of the rays.
template <typename Asker>
bool VisibilityGridFiller::AskShare(
  const TeamShare& share, TeamJoin& join, const Monitor& monitor, const Asker& ask)
{
  std::atomic<vtkIdType> sent{ 0 };
  std::vector<vtkIdType> rays; // of each process
  join.Add(rays);
  const auto body = [&](vtkIdType begin, vtkIdType end) { sent += ask(begin, end); };
  const bool done = TeamFor(this->Options.Workers, join, share, monitor, body, [&] { rays.assign(1, sent); });
  this->Grid.NumberOfOcclusionRays = std::accumulate(rays.begin(), rays.end(), this->Grid.NumberOfOcclusionRays);
  this->Grid.NumberOfOwnRays += sent;
  return done;
}

} // namespace shadowcones

#endif
