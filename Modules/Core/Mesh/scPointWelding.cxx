// SPDX-License-Identifier: BSD-3-Clause
#include "scPointWelding.h"

#include "scBits.h"
#include "scRandom.h"
#include "scTriangleSides.h"
#include "scUnitFrame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shadowcones
{
namespace
{
using Ids = std::vector<vtkIdType>;

/// How far from each point another one is the same; points that no triangle uses get 0.
std::vector<double> WeldDistances(const TriangleMeshView& mesh, double relative)
{
  std::vector<double> shortest(static_cast<std::size_t>(mesh.NumberOfPoints), HUGE_VAL);
  for (vtkIdType side = 0; side < 3 * mesh.NumberOfTriangles; ++side)
  {
    const vtkIdType a = mesh.Triangles[side];
    const vtkIdType b = mesh.Triangles[NextSide(side)];
    const Vector3 edge = mesh.Point(b) - mesh.Point(a);
    const double length = std::hypot(edge.X, edge.Y, edge.Z);
    // Ends that are the same place are no edge.
    if (length > std::max(UnitFrame::RoundingOf(mesh.Point(a)), UnitFrame::RoundingOf(mesh.Point(b))))
    {
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  }
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    const double rounding = UnitFrame::RoundingOf(mesh.Point(i));
    const double edge = std::isfinite(shortest[i]) ? shortest[i] : 0.0;
    shortest[i] = relative > 0.0 ? std::max(relative * edge, rounding) : 0.0;
  }
  return shortest;
}

/**
 * Points that are kept, in hashed grids: one grid for each power of two that is just above a point's distance, with cells
 * of four times that, so that a query looks into 1 to 8 cells of each grid. Distance 0: cells are the very coordinates.
 */
class WeldGrids
{
public:
  WeldGrids(const TriangleMeshView& mesh, const std::vector<int>& blocks, const std::vector<double>& distances)
    : Mesh(mesh)
    , Blocks(blocks)
    , Distances(distances)
    , Next(distances.size(), -1)
  {
    std::size_t numberOfBuckets = 16;
    while (numberOfBuckets < 2 * distances.size())
    {
      numberOfBuckets *= 2;
    }
    this->Heads.assign(numberOfBuckets, -1);
  }

  /// The earliest kept point of the same block, no farther than the smaller of both points' distances; else @p id.
  vtkIdType Find(vtkIdType id) const
  {
    vtkIdType found = id;
    const Vector3 p = this->Mesh.Point(id);
    for (const double reach : this->Reaches)
    {
      const double distance = std::min(reach, this->Distances[id]);
      double low[3];
      double high[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = Cell(p[axis] - distance, reach);
        high[axis] = Cell(p[axis] + distance, reach);
      }
      for (int corner = 0; corner < 8; ++corner)
      {
        const bool x = corner & 1;
        const bool y = corner & 2;
        const bool z = corner & 4;
        if ((x && low[0] == high[0]) || (y && low[1] == high[1]) || (z && low[2] == high[2]))
        {
          continue;
        }
        const std::size_t bucket =
          this->Bucket(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2], reach, this->Blocks[id]);
        for (vtkIdType j = this->Heads[bucket]; j >= 0; j = this->Next[j])
        {
          found = j < found && this->AreOne(id, j) ? j : found;
        }
      }
    }
    return found;
  }

  void Add(vtkIdType id)
  {
    const double reach = Reach(this->Distances[id]);
    if (std::find(this->Reaches.begin(), this->Reaches.end(), reach) == this->Reaches.end())
    {
      this->Reaches.push_back(reach);
    }
    const Vector3 p = this->Mesh.Point(id);
    vtkIdType& head =
      this->Heads[this->Bucket(Cell(p.X, reach), Cell(p.Y, reach), Cell(p.Z, reach), reach, this->Blocks[id])];
    this->Next[id] = head;
    head = id;
  }

private:
  static double Reach(double distance) { return distance > 0.0 ? std::ldexp(1.0, std::ilogb(distance) + 1) : 0.0; }
  static double Cell(double x, double reach) { return reach > 0.0 ? std::floor(x / (4.0 * reach)) : x; }
  std::size_t Bucket(double x, double y, double z, double reach, int block) const
  {
    const std::uint64_t xy = Mix64(Mix64(BitsOf(x)) + BitsOf(y) * 0x9E3779B97F4A7C15ull);
    const std::uint64_t all = Mix64(Mix64(xy + BitsOf(z)) + BitsOf(reach));
    return Mix64(all + static_cast<std::uint64_t>(block)) & (this->Heads.size() - 1);
  }
  bool AreOne(vtkIdType i, vtkIdType j) const
  {
    const Vector3 d = this->Mesh.Point(i) - this->Mesh.Point(j);
    return this->Blocks[i] == this->Blocks[j] &&
      std::hypot(d.X, d.Y, d.Z) <= std::min(this->Distances[i], this->Distances[j]);
  }

  const TriangleMeshView& Mesh;
  const std::vector<int>& Blocks;
  const std::vector<double>& Distances;
  std::vector<double> Reaches;
  Ids Heads;
  Ids Next;
};
} // anonymous namespace

std::vector<vtkIdType> WeldPoints(const TriangleMeshView& mesh, const int* blocks, double relative)
{
  Ids kept(static_cast<std::size_t>(mesh.NumberOfPoints), -1);
  std::vector<int> blockOf(kept.size(), 0);
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    kept[mesh.Triangles[i]] = mesh.Triangles[i];
    blockOf[mesh.Triangles[i]] = blocks ? blocks[i / 3] : 0;
  }
  const std::vector<double> distances = WeldDistances(mesh, relative);
  WeldGrids grids(mesh, blockOf, distances);
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    if (kept[i] < 0)
    {
      continue;
    }
    kept[i] = grids.Find(i);
    if (kept[i] == i)
    {
      grids.Add(i);
    }
  }
  return kept;
}

} // namespace shadowcones
