// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonTracing.h"

#include "scLargePages.h"

#include <algorithm>
#include <vector>

namespace shadowcones
{
namespace
{
constexpr vtkIdType photonsPerTask = 1024;
} // anonymous namespace

void AppendAll(ShadowVectorResult& result, const std::vector<ShadowVectorResult*>& ranges)
{
  std::size_t more[numberOfPhotonItems] = { 0, 0, 0 };
  for (const ShadowVectorResult* range : ranges)
  {
    more[0] += range->Vectors.PhotonIndices.size();
    more[1] += range->Paths.PhotonIndices.size();
    more[2] += range->Photons.PhotonIndices.size();
  }
  ForEachArray(result, result,
    [&more](int item, int components, auto& values, auto&)
    {
      const std::size_t needed = values.size() + more[item] * static_cast<std::size_t>(components);
      if (needed > values.capacity())
      {
        // Not twice what there is, which would be the peak of memory; but more than needed where many ranges follow.
        ReserveLarge(values, std::max(needed, values.capacity() + values.capacity() / 4));
      }
    });
  for (ShadowVectorResult* range : ranges)
  {
    ForEachArray(result, *range,
      [](int, int, auto& values, const auto& added) { values.insert(values.end(), added.begin(), added.end()); });
    result.MeanSolidAngle += range->MeanSolidAngle;
    *range = {};
  }
}

void MakeRoomForAll(const Team& team, const ShadowVectorResult& own, ShadowVectorResult& all)
{
  constexpr double more = 1.1; // than this process has: what is left is not touched
  const double share = more * team.GetSize();
  ForEachArray(own, all,
    [share](int, int, const auto& part, auto& values)
    { ReserveLarge(values, values.size() + static_cast<std::size_t>(share * static_cast<double>(part.size()))); });
}

void AddPhotons(TeamJoin& join, ShadowVectorResult& own, ShadowVectorResult& all)
{
  ForEachArray(own, all, [&join](int, int, auto& part, auto& values) { join.Append(part, values); });
}

bool PhotonTracing::TraceRange(vtkIdType begin, vtkIdType end, const Monitor& monitor, ShadowVectorResult& result) const
{
  const vtkIdType tasks = (std::max(end - begin, vtkIdType(0)) + photonsPerTask - 1) / photonsPerTask;
  // Processes have a range of tasks each, so that what they find joins in order; sums are taken task by task.
  const int rank = this->Workers ? this->Workers->GetRank() : 0;
  const int size = this->Workers ? this->Workers->GetSize() : 1;
  const vtkIdType firstTask = PieceBound(tasks, rank, size);
  const vtkIdType ownTasks = PieceBound(tasks, rank + 1, size) - firstTask;
  ShadowVectorResult found;
  std::vector<double> solidAngles;
  TeamJoin join(this->Workers);
  AddPhotons(join, found, result);
  join.Add(solidAngles);
  const auto traceOwn = [&]
  {
    std::vector<ShadowVectorResult> parts(static_cast<std::size_t>(ownTasks));
    const bool finished = ParallelFor(ownTasks, monitor,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType task = first; task < last; ++task)
        {
          const vtkIdType taskBegin = begin + (firstTask + task) * photonsPerTask;
          const vtkIdType taskEnd = std::min(end, taskBegin + photonsPerTask);
          for (vtkIdType photon = taskBegin; photon < taskEnd; ++photon)
          {
            this->Trace(this->Bundles.At(photon), photon, parts[static_cast<std::size_t>(task)]);
          }
        }
      });
    std::vector<ShadowVectorResult*> ranges;
    for (ShadowVectorResult& part : parts)
    {
      solidAngles.push_back(part.MeanSolidAngle);
      part.MeanSolidAngle = 0.0;
      ranges.push_back(&part);
    }
    if (finished)
    {
      AppendAll(AreSeveral(this->Workers) ? found : result, ranges);
    }
    if (finished && AreSeveral(this->Workers))
    {
      MakeRoomForAll(*this->Workers, found, result);
    }
    return finished;
  };
  if (AreSeveral(this->Workers))
  {
    this->Workers->Count(std::min(end, begin + (firstTask + ownTasks) * photonsPerTask) - begin - firstTask * photonsPerTask);
  }
  if (!join.Run(traceOwn))
  {
    return false;
  }
  for (const double solidAngle : solidAngles)
  {
    result.MeanSolidAngle += solidAngle;
  }
  return true;
}

} // namespace shadowcones
