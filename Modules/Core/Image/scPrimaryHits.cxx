// SPDX-License-Identifier: BSD-3-Clause
#include "scPrimaryHits.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

namespace
{

/// Surfaces that meet at more than this many radians make an edge.
constexpr double largestTurn = 25.0 * 3.14159265358979323846 / 180.0;
/// By so much, as a sine, may the way from hit to hit leave the surfaces beyond their own turn before it is a jump.
constexpr double smallestJump = 0.1;
/// Pixels whose rays are traced at once.
constexpr int blockWidth = 4;
constexpr int blockHeight = OccluderScene::PacketSize / blockWidth;

/// The block of a pixel, which may lie left of or below the image.
int BlockOf(int pixel, int side)
{
  return pixel >= 0 ? pixel / side : -((side - 1 - pixel) / side);
}

} // namespace

PrimaryHits::PrimaryHits(
  const ScatteringScene& scene, const ScatteringOptions& options, const VisibleLight* visibleLight)
  : Scene(scene)
  , Options(options)
  , Visible(visibleLight)
  , Apron(options.NumberOfEdgeSamples > 1 ? 1 : 0)
  , First{ options.Extent[0] - Apron, options.Extent[2] - Apron }
  , Columns(options.Extent[1] - options.Extent[0] + 1 + 2 * Apron)
  , Rows(options.Extent[3] - options.Extent[2] + 1 + 2 * Apron)
{
}

bool PrimaryHits::Trace(const Monitor& monitor)
{
  this->Hits.resize(static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(this->Rows));
  const int firstBlock[2] = { BlockOf(this->First[0], blockWidth), BlockOf(this->First[1], blockHeight) };
  const int columns = BlockOf(this->First[0] + this->Columns - 1, blockWidth) - firstBlock[0] + 1;
  const int rows = BlockOf(this->First[1] + this->Rows - 1, blockHeight) - firstBlock[1] + 1;
  return ParallelFor(static_cast<vtkIdType>(columns) * rows, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        this->TraceBlock(blockWidth * (firstBlock[0] + static_cast<int>(block % columns)),
          blockHeight * (firstBlock[1] + static_cast<int>(block / columns)));
      }
    });
}

/// Trace a whole block, and keep what is wanted of it: a ray's neighbours are the same for every extent.
void PrimaryHits::TraceBlock(int i, int j)
{
  constexpr int count = blockWidth * blockHeight;
  Ray rays[count];
  PrimaryHit hits[count];
  for (int k = 0; k < count; ++k)
  {
    rays[k] = this->RayOf(i + k % blockWidth, j + k / blockWidth);
  }
  this->Find(rays, count, hits);
  for (int k = 0; k < count; ++k)
  {
    const int column = i + k % blockWidth - this->First[0];
    const int row = j + k / blockWidth - this->First[1];
    if (column >= 0 && column < this->Columns && row >= 0 && row < this->Rows)
    {
      this->Hits[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Columns) +
        static_cast<std::size_t>(column)] = hits[k];
    }
  }
}

void PrimaryHits::Find(const Ray* rays, int count, PrimaryHit* hits) const
{
  constexpr int packet = OccluderScene::PacketSize;
  const OccluderScene& occluders = this->Scene.Occluders;
  for (int first = 0; first < count; first += packet)
  {
    const int size = std::min(count - first, packet);
    Vector3 origins[packet];
    Vector3 directions[packet];
    RayHit found[packet];
    for (int k = 0; k < size; ++k)
    {
      origins[k] = rays[first + k].Origin;
      directions[k] = rays[first + k].Direction;
    }
    occluders.IntersectPacket(origins, directions, size, found);
    for (int k = 0; k < size; ++k)
    {
      PrimaryHit& hit = hits[first + k];
      hit = PrimaryHit();
      if (found[k].Triangle >= 0)
      {
        hit.T = found[k].T;
        hit.Triangle = found[k].Triangle;
      }
      double t = 0.0;
      double scale = 0.0;
      // A mesh that is both lamp and occluder is a surface at the very same place.
      hit.SeesLight =
        this->Visible && this->Visible->Intersect(origins[k], directions[k], hit.T + occluders.Epsilon(), t, scale);
    }
  }
}

bool PrimaryHits::IsEdge(int i, int j) const
{
  return this->Apron > 0 &&
    (this->Differ(i, j, i - 1, j) || this->Differ(i, j, i + 1, j) || this->Differ(i, j, i, j - 1) ||
      this->Differ(i, j, i, j + 1));
}

bool PrimaryHits::Differ(int i, int j, int otherI, int otherJ) const
{
  const PrimaryHit& a = this->At(i, j);
  const PrimaryHit& b = this->At(otherI, otherJ);
  if (a.SeesLight != b.SeesLight)
  {
    return true;
  }
  if (a.Triangle == b.Triangle || !a.HasSurface() || !b.HasSurface())
  {
    return a.Triangle != b.Triangle;
  }
  const OccluderScene& occluders = this->Scene.Occluders;
  if (occluders.Mesh().OccluderId(a.Triangle) != occluders.Mesh().OccluderId(b.Triangle) ||
    !this->SameReflectance(a.Triangle, b.Triangle))
  {
    return true;
  }
  const Ray rayA = this->RayOf(i, j);
  const Ray rayB = this->RayOf(otherI, otherJ);
  const Vector3 normalA = NormalTowards(occluders, rayA, a);
  const Vector3 normalB = NormalTowards(occluders, rayB, b);
  if (Dot(normalA, normalB) < std::cos(largestTurn))
  {
    return true;
  }
  // The way along a surface leaves the planes at its two ends by no more than these are turned against each other.
  const Vector3 way = rayB.Origin + b.T * rayB.Direction - rayA.Origin - a.T * rayA.Direction;
  const double turn = Length(Cross(normalA, normalB)) + smallestJump;
  return std::fabs(Dot(normalA, way)) + std::fabs(Dot(normalB, way)) > turn * Length(way);
}

bool PrimaryHits::SameReflectance(vtkIdType a, vtkIdType b) const
{
  if (this->Options.SurfaceReflectance.empty())
  {
    return true;
  }
  const auto components = this->Options.ReflectanceComponents;
  const float* values = this->Options.SurfaceReflectance.data();
  return std::equal(values + a * components, values + (a + 1) * components, values + b * components);
}

} // namespace shadowcones
