// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVolumeSample.h
 * @brief The volume that cones hold, by points in a box. Internal to Core.
 */
#ifndef scVolumeSample_h
#define scVolumeSample_h

#include "scCone.h"

#include <vector>

namespace shadowcones
{

/// Points that fill a box evenly, and which of them cones hold. Single precision will do: nothing is proved here.
class VolumeSample
{
public:
  /// 1 for each point that is held, else 0.
  using Mask = std::vector<unsigned char>;

  explicit VolumeSample(const Box& region);

  /// Keep only points in or near the cones, and not too many.
  void KeepNear(const std::vector<Cone>& cones);
  Mask MaskOf(const Cone& cone) const;
  /// Of the box, over the number of points in it.
  double VolumeOfPoint() const { return this->PointVolume; }
  /// Volume of the union of cones in the box, as far as the points tell.
  double VolumeOf(const std::vector<Cone>& cones) const;

private:
  std::vector<float> X;
  std::vector<float> Y;
  std::vector<float> Z;
  double PointVolume = 1.0;
};

/// Points of @p mask that are not in @p other.
int CountBeyond(const VolumeSample::Mask& mask, const VolumeSample::Mask& other);

} // namespace shadowcones

#endif
