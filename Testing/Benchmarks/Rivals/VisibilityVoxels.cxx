// SPDX-License-Identifier: BSD-3-Clause
#include "VisibilityVoxels.h"

#include "scParallel.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

//------------------------------------------------------------------------------
VisibilityVoxels::VisibilityVoxels(
  const OccluderScene& scene, const Light& light, const Box& bounds, int side, int rays)
  : Bounds(bounds)
  , Side(side)
  , Blocked(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(side))
{
  const LampRays lamp(scene, light, rays);
  const Vector3 step = (1.0 / (side - 1)) * bounds.Size();
  ParallelFor(static_cast<vtkIdType>(this->Blocked.size()), Monitor(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        RandomStream random(4, static_cast<std::uint64_t>(k));
        const Vector3 x = bounds.Min +
          Vector3{ static_cast<double>(k % side) * step.X, static_cast<double>(k / side % side) * step.Y,
            static_cast<double>(k / side / side) * step.Z };
        this->Blocked[static_cast<std::size_t>(k)] =
          static_cast<unsigned char>(std::lround(255.0 * lamp.BlockedAt(x, random)));
      }
    });
}

//------------------------------------------------------------------------------
double VisibilityVoxels::BlockedAt(const Vector3& x, RandomStream&) const
{
  const Vector3 size = this->Bounds.Size();
  std::size_t low[3];
  double share[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = std::clamp((x[axis] - this->Bounds.Min[axis]) / size[axis], 0.0, 1.0) * (this->Side - 1);
    low[axis] = static_cast<std::size_t>(std::min(static_cast<int>(place), this->Side - 2));
    share[axis] = place - static_cast<double>(low[axis]);
  }
  const auto row = static_cast<std::size_t>(this->Side);
  const unsigned char* at = this->Blocked.data() + low[0] + row * (low[1] + row * low[2]);
  const auto alongX = [&](const unsigned char* p) { return p[0] + share[0] * (p[1] - p[0]); };
  const auto alongY = [&](const unsigned char* p) { return alongX(p) + share[1] * (alongX(p + row) - alongX(p)); };
  const double near = alongY(at);
  return (near + share[2] * (alongY(at + row * row) - near)) / 255.0;
}

} // namespace shadowcones
