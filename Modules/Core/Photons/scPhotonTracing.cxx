// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonTracing.h"

#include <algorithm>
#include <vector>

namespace shadowcones
{
namespace
{
constexpr vtkIdType photonsPerTask = 1024;
} // anonymous namespace

void Append(ShadowVectorResult& result, const ShadowVectorResult& more)
{
  ForEachArray(result, more,
    [](int, int, auto& values, const auto& added) { values.insert(values.end(), added.begin(), added.end()); });
  result.MeanSolidAngle += more.MeanSolidAngle;
}

void AddPhotons(TeamJoin& join, ShadowVectorResult& result)
{
  ForEachArray(result, result, [&join](int, int, auto& values, auto&) { join.Add(values); });
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
  AddPhotons(join, found);
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
    ShadowVectorResult& to = AreSeveral(this->Workers) ? found : result;
    for (std::size_t task = 0; finished && task < parts.size(); ++task)
    {
      solidAngles.push_back(parts[task].MeanSolidAngle);
      parts[task].MeanSolidAngle = 0.0;
      Append(to, parts[task]);
      parts[task] = {};
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
  if (AreSeveral(this->Workers))
  {
    Append(result, found);
  }
  for (const double solidAngle : solidAngles)
  {
    result.MeanSolidAngle += solidAngle;
  }
  return true;
}

} // namespace shadowcones
