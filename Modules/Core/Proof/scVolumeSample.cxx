// SPDX-License-Identifier: BSD-3-Clause
#include "scVolumeSample.h"

#include "scBoundingCone.h"
#include "scParallel.h"
#include "scRandom.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
constexpr std::uint32_t drawnPoints = 16384;
constexpr std::size_t mostPoints = 4096; ///< near cones
}

VolumeSample::VolumeSample(const Box& region)
{
  const Vector3 size = region.Empty() ? Vector3{} : region.Size();
  for (std::uint32_t i = 0; i < drawnPoints; ++i)
  {
    const auto u = SobolPoint(7, i);
    this->X.push_back(static_cast<float>(region.Min.X + u[0] * size.X));
    this->Y.push_back(static_cast<float>(region.Min.Y + u[1] * size.Y));
    this->Z.push_back(static_cast<float>(region.Min.Z + u[2] * size.Z));
  }
  this->PointVolume = std::max(size.X * size.Y * size.Z / drawnPoints, 1e-300);
}

void VolumeSample::KeepNear(const std::vector<Cone>& cones)
{
  std::vector<Mask> near(cones.size());
  ParallelFor(static_cast<vtkIdType>(cones.size()), {}, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      Cone wide = cones[i];
      wide.Center = wide.Center - wide.BaseRadius * wide.Axis;
      wide.BaseRadius *= 2.0;
      wide.HalfAngle = std::min(largestProvedAngle, std::max(0.0, 1.25 * wide.HalfAngle) + 0.02);
      near[i] = this->MaskOf(wide);
    }
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->X.size() && kept < mostPoints; ++i)
  {
    if (std::any_of(near.begin(), near.end(), [i](const Mask& mask) { return mask[i] != 0; }))
    {
      this->X[kept] = this->X[i];
      this->Y[kept] = this->Y[i];
      this->Z[kept++] = this->Z[i];
    }
  }
  this->X.resize(kept);
  this->Y.resize(kept);
  this->Z.resize(kept);
}

VolumeSample::Mask VolumeSample::MaskOf(const Cone& cone) const
{
  Mask mask(this->X.size());
  const auto ax = static_cast<float>(cone.Axis.X);
  const auto ay = static_cast<float>(cone.Axis.Y);
  const auto az = static_cast<float>(cone.Axis.Z);
  const auto cx = static_cast<float>(cone.Center.X);
  const auto cy = static_cast<float>(cone.Center.Y);
  const auto cz = static_cast<float>(cone.Center.Z);
  const auto radius = static_cast<float>(cone.BaseRadius);
  const auto tangent = static_cast<float>(std::tan(cone.HalfAngle));
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const float x = this->X[i] - cx;
    const float y = this->Y[i] - cy;
    const float z = this->Z[i] - cz;
    const float height = x * ax + y * ay + z * az;
    const float reach = radius + height * tangent;
    const float across = x * x + y * y + z * z - height * height;
    mask[i] = static_cast<unsigned char>((height >= 0.0f) & (reach >= 0.0f) & (across <= reach * reach));
  }
  return mask;
}

double VolumeSample::VolumeOf(const std::vector<Cone>& cones) const
{
  Mask all(this->X.size(), 0);
  int count = 0;
  for (const Cone& cone : cones)
  {
    const Mask mask = this->MaskOf(cone);
    count += CountBeyond(mask, all);
    std::transform(mask.begin(), mask.end(), all.begin(), all.begin(), [](unsigned char a, unsigned char b) { return a | b; });
  }
  return count * this->PointVolume;
}

/// Points of @p mask that are not in @p other.
int CountBeyond(const VolumeSample::Mask& mask, const VolumeSample::Mask& other)
{
  int count = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    count += mask[i] & (other[i] ^ 1);
  }
  return count;
}

} // namespace shadowcones
