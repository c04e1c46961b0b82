// SPDX-License-Identifier: BSD-3-Clause
#include "scPrimaryHits.h"

#include "scConstants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{

namespace
{

/// Surfaces that meet at more than this many radians make an edge.
constexpr double largestTurn = 25.0 * Pi / 180.0;
/// By so much, as a sine, may the way from hit to hit leave the surfaces beyond their own turn before it is a jump.
constexpr double smallestJump = 0.1;
/// Rays that look for surfaces in a pixel at an edge, for each of NumberOfEdgeSamples.
constexpr int looksOfEdgeSample = 16;
/// Surfaces of a pixel for each of NumberOfEdgeSamples; of more, such as leaves, only some are looked at.
constexpr std::size_t mostSurfaces = 2;
/// Pixels whose rays are traced at once.
constexpr int blockWidth = 4;
constexpr int blockHeight = OccluderScene::PacketSize / blockWidth;

/// Points spread over the unit square around 0, no two in one row or column: four of them are the rotated grid.
std::vector<std::array<double, 2>> SpreadOffsets(int count)
{
  // A lattice whose step is coprime to count + 1 and nearest to the golden ratio of it.
  const int modulus = count + 1;
  const double wanted = 0.61803398874989485 * modulus;
  int step = 1;
  for (int candidate = 1; candidate < modulus; ++candidate)
  {
    if (std::gcd(candidate, modulus) == 1 && std::fabs(candidate - wanted) < std::fabs(step - wanted))
    {
      step = candidate;
    }
  }
  std::vector<std::array<double, 2>> offsets;
  for (int k = 1; k <= count; ++k)
  {
    const auto row = static_cast<int>(static_cast<long long>(step) * k % modulus);
    offsets.push_back({ (k - 0.5) / count - 0.5, (row - 0.5) / count - 0.5 });
  }
  return offsets;
}

} // namespace

PrimaryHits::PrimaryHits(const ScatteringScene& scene, const ScatteringOptions& options,
  const std::array<int, 4>& extent, const std::vector<VisibleLight>& visibleLights)
  : Scene(scene)
  , Options(options)
  , Extent(extent)
  , Visible(visibleLights)
  , FindsEdges(options.NumberOfEdgeSamples > 1)
  , Centers(this->LatticeOver(0.0, 0))
{
  if (this->FindsEdges)
  {
    this->Corners = this->LatticeOver(-0.5, 1);
    this->EdgeOffsets = SpreadOffsets(looksOfEdgeSample * options.NumberOfEdgeSamples);
  }
}

PrimaryHits::Lattice PrimaryHits::LatticeOver(double shift, int more) const
{
  Lattice lattice;
  lattice.Shift = shift;
  lattice.First = { this->Extent[0], this->Extent[2] };
  lattice.Columns = std::max(this->Extent[1] - this->Extent[0] + 1, 0) + more;
  lattice.Rows = std::max(this->Extent[3] - this->Extent[2] + 1, 0) + more;
  return lattice;
}

bool PrimaryHits::Trace(const Monitor& monitor)
{
  return this->Trace(this->Centers, monitor.Part(0.0, this->FindsEdges ? 0.5 : 1.0)) &&
    (!this->FindsEdges || this->Trace(this->Corners, monitor.Part(0.5, 1.0)));
}

bool PrimaryHits::Trace(Lattice& lattice, const Monitor& monitor) const
{
  lattice.Hits.Resize(static_cast<std::size_t>(lattice.Columns) * static_cast<std::size_t>(lattice.Rows));
  const int firstBlock[2] = { lattice.First[0] / blockWidth, lattice.First[1] / blockHeight };
  const int columns = (lattice.First[0] + lattice.Columns - 1) / blockWidth - firstBlock[0] + 1;
  const int rows = (lattice.First[1] + lattice.Rows - 1) / blockHeight - firstBlock[1] + 1;
  return ParallelFor(static_cast<vtkIdType>(columns) * rows, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        this->TraceBlock(blockWidth * (firstBlock[0] + static_cast<int>(block % columns)),
          blockHeight * (firstBlock[1] + static_cast<int>(block / columns)), lattice);
      }
    });
}

/// Trace a whole block, and keep what is wanted of it: a ray's neighbours are the same for every extent.
void PrimaryHits::TraceBlock(int i, int j, Lattice& lattice) const
{
  constexpr int count = blockWidth * blockHeight;
  Ray rays[count];
  PrimaryHit hits[count];
  for (int k = 0; k < count; ++k)
  {
    rays[k] = this->RayOf(i + k % blockWidth + lattice.Shift, j + k / blockWidth + lattice.Shift);
  }
  this->Find(rays, count, hits);
  for (int k = 0; k < count; ++k)
  {
    const int column = i + k % blockWidth - lattice.First[0];
    const int row = j + k / blockWidth - lattice.First[1];
    if (column >= 0 && column < lattice.Columns && row >= 0 && row < lattice.Rows)
    {
      lattice.Hits[static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice.Columns) +
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
      for (std::size_t light = 0; light < this->Visible.size(); ++light)
      {
        const bool sees =
          this->Visible[light].Intersect(origins[k], directions[k], hit.T + RoundingAlong(origins[k], hit.T), t, scale);
        hit.LightsSeen |= static_cast<std::uint64_t>(sees) << (light % 64);
      }
    }
  }
}

void PrimaryHits::RaysOf(int i, int j, std::vector<PixelRay>& rays) const
{
  rays.assign(1, { 1.0 * i, 1.0 * j, this->RayOf(i, j), this->At(i, j), 1.0 });
  if (!this->IsEdge(i, j))
  {
    return;
  }
  thread_local std::vector<Ray> lines;
  thread_local std::vector<PrimaryHit> hits;
  thread_local std::vector<std::vector<std::size_t>> surfaces; // the rays that see each, beginning with the centre's
  const std::size_t count = this->EdgeOffsets.size();
  lines.resize(count);
  hits.resize(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    lines[k] = this->RayOf(i + this->EdgeOffsets[k][0], j + this->EdgeOffsets[k][1]);
  }
  this->Find(lines.data(), static_cast<int>(count), hits.data());
  surfaces.assign(1, {});
  for (std::size_t k = 0; k < count; ++k)
  {
    std::size_t surface = this->Differ(rays[0].Line, rays[0].Hit, lines[k], hits[k]) ? 1 : 0;
    while (surface > 0 && surface < surfaces.size() &&
      this->Differ(lines[surfaces[surface][0]], hits[surfaces[surface][0]], lines[k], hits[k]))
    {
      ++surface;
    }
    surfaces.resize(std::max(surfaces.size(), surface + 1));
    surfaces[surface].push_back(k);
  }
  if (surfaces.size() == 1)
  {
    return;
  }

  rays.clear();
  const auto rayAt = [&](std::size_t k, double fraction) {
    return PixelRay{ i + this->EdgeOffsets[k][0], j + this->EdgeOffsets[k][1], lines[k], hits[k], fraction };
  };
  const std::size_t most = mostSurfaces * static_cast<std::size_t>(this->Options.NumberOfEdgeSamples);
  if (surfaces.size() > most)
  {
    for (std::size_t k = 0; k < most; ++k)
    {
      const std::size_t ray = k * count / most;
      rays.push_back(rayAt(ray, 1.0 / static_cast<double>(most)));
    }
    return;
  }
  for (const std::vector<std::size_t>& seen : surfaces)
  {
    if (!seen.empty())
    {
      const std::size_t ray = this->MiddleOf(seen);
      rays.push_back(rayAt(ray, static_cast<double>(seen.size()) / static_cast<double>(count)));
    }
  }
}

/// Of rays that see the same surface the one nearest to the middle of them.
std::size_t PrimaryHits::MiddleOf(const std::vector<std::size_t>& seen) const
{
  double x = 0.0;
  double y = 0.0;
  for (const std::size_t k : seen)
  {
    x += this->EdgeOffsets[k][0] / static_cast<double>(seen.size());
    y += this->EdgeOffsets[k][1] / static_cast<double>(seen.size());
  }
  const auto distance = [&](std::size_t k)
  { return std::hypot(this->EdgeOffsets[k][0] - x, this->EdgeOffsets[k][1] - y); };
  return *std::min_element(
    seen.begin(), seen.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
}

bool PrimaryHits::IsEdge(int i, int j) const
{
  if (!this->FindsEdges)
  {
    return false;
  }
  const Ray ray = this->RayOf(i, j);
  for (int corner = 0; corner < 4; ++corner)
  {
    const int cornerI = i + corner % 2;
    const int cornerJ = j + corner / 2;
    const PrimaryHit& hit = this->Corners.At(cornerI, cornerJ);
    if (this->Differ(ray, this->At(i, j), this->RayOf(cornerI - 0.5, cornerJ - 0.5), hit))
    {
      return true;
    }
  }
  return false;
}

bool PrimaryHits::Differ(
  const Ray& rayA, const PrimaryHit& a, const Ray& rayB, const PrimaryHit& b) const
{
  if (a.LightsSeen != b.LightsSeen)
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
