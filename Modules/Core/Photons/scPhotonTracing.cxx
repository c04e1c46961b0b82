// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonTracing.h"

#include <algorithm>
#include <vector>

namespace shadowcones
{
namespace
{
constexpr vtkIdType photonsPerTask = 1024;

template <typename T>
void Append(std::vector<T>& values, const std::vector<T>& more)
{
  values.insert(values.end(), more.begin(), more.end());
}
} // anonymous namespace

void Append(ShadowVectorResult& result, const ShadowVectorResult& more)
{
  Append(result.Vectors.Points, more.Vectors.Points);
  Append(result.Vectors.Directions, more.Vectors.Directions);
  Append(result.Vectors.Normals, more.Vectors.Normals);
  Append(result.Vectors.OccluderIds, more.Vectors.OccluderIds);
  Append(result.Vectors.EmissionPoints, more.Vectors.EmissionPoints);
  Append(result.Vectors.PathLengths, more.Vectors.PathLengths);
  Append(result.Vectors.Thicknesses, more.Vectors.Thicknesses);
  Append(result.Vectors.PhotonIndices, more.Vectors.PhotonIndices);
  Append(result.Vectors.LightIds, more.Vectors.LightIds);
  Append(result.Paths.Points, more.Paths.Points);
  Append(result.Paths.States, more.Paths.States);
  Append(result.Paths.OccluderIds, more.Paths.OccluderIds);
  Append(result.Paths.EmissionPoints, more.Paths.EmissionPoints);
  Append(result.Paths.Directions, more.Paths.Directions);
  Append(result.Paths.Powers, more.Paths.Powers);
  Append(result.Paths.PhotonIndices, more.Paths.PhotonIndices);
  Append(result.Paths.LightIds, more.Paths.LightIds);
  Append(result.Photons.Points, more.Photons.Points);
  Append(result.Photons.Normals, more.Photons.Normals);
  Append(result.Photons.Directions, more.Photons.Directions);
  Append(result.Photons.Powers, more.Photons.Powers);
  Append(result.Photons.OccluderIds, more.Photons.OccluderIds);
  Append(result.Photons.ReceiverIds, more.Photons.ReceiverIds);
  Append(result.Photons.PhotonIndices, more.Photons.PhotonIndices);
  Append(result.Photons.LightIds, more.Photons.LightIds);
  result.MeanSolidAngle += more.MeanSolidAngle;
}

bool PhotonTracing::TraceRange(vtkIdType begin, vtkIdType end, const Monitor& monitor, ShadowVectorResult& result) const
{
  const vtkIdType tasks = (std::max(end - begin, vtkIdType(0)) + photonsPerTask - 1) / photonsPerTask;
  std::vector<ShadowVectorResult> parts(static_cast<std::size_t>(tasks));
  const bool finished = ParallelFor(tasks, monitor,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType task = first; task < last; ++task)
      {
        const vtkIdType taskBegin = begin + task * photonsPerTask;
        const vtkIdType taskEnd = std::min(end, taskBegin + photonsPerTask);
        for (vtkIdType photon = taskBegin; photon < taskEnd; ++photon)
        {
          this->Trace(this->Bundles.At(photon), photon, parts[task]);
        }
      }
    });
  if (finished)
  {
    for (ShadowVectorResult& part : parts)
    {
      Append(result, part);
      part = {};
    }
  }
  return finished;
}

} // namespace shadowcones
