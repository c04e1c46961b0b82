// SPDX-License-Identifier: BSD-3-Clause
#include "scTuningData.h"

#include "scBox.h"
#include "scCellIndex.h"
#include "scParallel.h"
#include "scRandom.h"
#include "scVector3.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace shadowcones
{
namespace
{
constexpr vtkIdType largestNumberOfHeldOut = 6000;
constexpr vtkIdType largestNumberOfPaths = 160000; ///< to trim bases by
constexpr int samplesPerPath = 8;

bool IsHeldOut(const double* emission, const float* direction)
{
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, emission + i, sizeof(double));
    std::uint32_t more = 0;
    std::memcpy(&more, direction + i, sizeof(float));
    hash = HashSeed(hash ^ bits, more);
  }
  return hash % 4 == 0;
}

/// The smallest step at which at most @p largest of @p count are taken.
vtkIdType StrideFor(vtkIdType count, vtkIdType largest)
{
  return std::max<vtkIdType>(1, (count + largest - 1) / largest);
}

Vector3 At(const double* points, vtkIdType i)
{
  return { points[3 * i], points[3 * i + 1], points[3 * i + 2] };
}
} // anonymous namespace

TuningData::TuningData(
  const ShadowVectorView& vectors, const PhotonPathView& paths, vtkIdType largestNumberOfVectors)
{
  const vtkIdType stride = StrideFor(vectors.Count, largestNumberOfVectors);
  this->AddVectors(vectors, stride);
  // As many paths a vector as there are in all: bases are trimmed as finely as those of the final fit.
  this->AddPaths(paths, std::max(stride, StrideFor(paths.Count, largestNumberOfPaths)));
}

std::string TuningData::Lacking(bool needLit) const
{
  const auto all = static_cast<vtkIdType>(this->HeldOut.size());
  const auto blocked = std::count_if(this->HeldOut.begin(), this->HeldOut.end(),
    [](const HeldOutPath& path) { return std::isfinite(path.Stop); });
  if (blocked > 0 && (blocked < all || !needLit))
  {
    return {};
  }
  return "of " + std::to_string(all) + " photon paths held out " + std::to_string(blocked) + " are blocked and " +
    std::to_string(all - blocked) + " are lit";
}

void TuningData::AddVectors(const ShadowVectorView& vectors, vtkIdType stride)
{
  Rays& rays = this->FittedVectors;
  for (vtkIdType i = 0; i < vectors.Count; i += stride)
  {
    const double* p = vectors.Points + 3 * i;
    const float* d = vectors.Directions + 3 * i;
    const double* e = vectors.EmissionPoints ? vectors.EmissionPoints + 3 * i : nullptr;
    if (e && IsHeldOut(e, d))
    {
      continue;
    }
    rays.Points.insert(rays.Points.end(), p, p + 3);
    rays.Directions.insert(rays.Directions.end(), d, d + 3);
    if (e)
    {
      rays.EmissionPoints.insert(rays.EmissionPoints.end(), e, e + 3);
    }
    rays.Values.push_back(vectors.OccluderIds ? vectors.OccluderIds[i] : 0);
    rays.LightIds.push_back(vectors.LightIds ? vectors.LightIds[i] : 0);
  }
}

void TuningData::AddPaths(const PhotonPathView& paths, vtkIdType stride)
{
  std::vector<vtkIdType> heldOut;
  Rays& rays = this->FittedPaths;
  vtkIdType others = 0;
  for (vtkIdType i = 0; i < paths.Count; ++i)
  {
    const double* p = paths.Points + 3 * i;
    const double* e = paths.EmissionPoints + 3 * i;
    const float* d = paths.Directions + 3 * i;
    this->Bounds.Add(At(paths.Points, i));
    this->Bounds.Add(At(paths.EmissionPoints, i));
    if (IsHeldOut(e, d))
    {
      heldOut.push_back(i);
    }
    else if (others++ % stride == 0)
    {
      rays.Points.insert(rays.Points.end(), p, p + 3);
      rays.Directions.insert(rays.Directions.end(), d, d + 3);
      rays.EmissionPoints.insert(rays.EmissionPoints.end(), e, e + 3);
      rays.Values.push_back(paths.States[i]);
      rays.LightIds.push_back(paths.LightIds ? paths.LightIds[i] : 0);
    }
  }

  const auto count = static_cast<vtkIdType>(heldOut.size());
  const vtkIdType kept = std::min(count, largestNumberOfHeldOut);
  for (vtkIdType k = 0; k < kept; ++k)
  {
    const vtkIdType i = heldOut[PieceBound(count, k, kept)];
    HeldOutPath path;
    path.Origin = At(paths.EmissionPoints, i);
    const float* d = paths.Directions + 3 * i;
    path.Direction = Normalized({ d[0], d[1], d[2] });
    path.Stop = paths.States[i] != 0 ? Length(At(paths.Points, i) - path.Origin) : HUGE_VAL;
    path.Light = paths.LightIds ? static_cast<std::size_t>(paths.LightIds[i]) : 0;
    this->HeldOut.push_back(path);
  }
}

ShadowVectorView TuningData::Vectors() const
{
  const Rays& rays = this->FittedVectors;
  ShadowVectorView view;
  view.Count = static_cast<vtkIdType>(rays.Values.size());
  view.Points = rays.Points.data();
  view.Directions = rays.Directions.data();
  view.EmissionPoints = rays.EmissionPoints.empty() ? nullptr : rays.EmissionPoints.data();
  view.OccluderIds = rays.Values.data();
  view.LightIds = rays.LightIds.data();
  return view;
}

PhotonPathView TuningData::Paths() const
{
  const Rays& rays = this->FittedPaths;
  PhotonPathView view;
  view.Count = static_cast<vtkIdType>(rays.Values.size());
  view.Points = rays.Points.data();
  view.EmissionPoints = rays.EmissionPoints.data();
  view.Directions = rays.Directions.data();
  view.States = rays.Values.data();
  view.LightIds = rays.LightIds.data();
  return view;
}

Box TuningData::Region(double margin) const
{
  const double grow = margin * this->Bounds.Diagonal();
  return { this->Bounds.Min - Vector3{ grow, grow, grow }, this->Bounds.Max + Vector3{ grow, grow, grow } };
}

std::vector<PathSample> TuningData::SamplesIn(const Box& region) const
{
  const Vector3 size = region.Size();
  std::vector<PathSample> samples;
  samples.reserve(samplesPerPath * this->HeldOut.size());
  for (std::size_t i = 0; i < this->HeldOut.size(); ++i)
  {
    const HeldOutPath& path = this->HeldOut[i];
    double begin = 0.0;
    double end = HUGE_VAL;
    if (!region.Clip(path.Origin, path.Direction, begin, end) || !(end > begin))
    {
      continue;
    }
    // Shifted by the golden ratio from path to path, so that neighbours see each other's gaps.
    const double turns = 0.61803398874989485 * static_cast<double>(i);
    const double shift = turns - std::floor(turns);
    for (int piece = 0; piece < samplesPerPath; ++piece)
    {
      PathSample sample;
      sample.Length = (end - begin) / samplesPerPath;
      const double t = begin + (piece + shift) * sample.Length;
      sample.Point = path.Origin + t * path.Direction;
      sample.Blocked = t > path.Stop;
      sample.Light = path.Light;
      for (int axis = 2; axis >= 0; --axis)
      {
        const double fraction = (sample.Point[axis] - region.Min[axis]) / std::max(size[axis], 1e-300);
        sample.Cell =
          sample.Cell * CellsPerSide + CellIndex(fraction * CellsPerSide, CellsPerSide - 1);
      }
      samples.push_back(sample);
    }
  }
  return samples;
}

} // namespace shadowcones
