// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowBuffers.h
 * @brief Shadow buffers (Williams 1978) of one point of the light, or of many; looked up by percentages (Reeves et al. 1987).
 */
#ifndef ShadowBuffers_h
#define ShadowBuffers_h

#include "BufferView.h"
#include "LampPoints.h"
#include "Rival.h"

#include <vector>

namespace shadowcones
{

struct ShadowBufferOptions
{
  int Points = 1;
  int Resolution = 512;
  /// Of the mesh's diagonal; a place is hidden where it lies so much deeper than what the buffer holds.
  double Bias = 1e-3;
  /// Percentage-closer soft shadows (Fernando 2005): 16 looks for what blocks, 16 more over the part of the buffer that the light
  /// spans behind it. For one point, where the light has a size.
  bool Soft = false;
};

class ShadowBuffers : public PointRival
{
public:
  ShadowBuffers(const TriangleMeshView& mesh, const Light& light, const ShadowBufferOptions& options);

  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  std::int64_t Memory() const override;

private:
  struct Buffer
  {
    BufferView View;
    std::vector<float> Depths;
  };
  /// Four comparisons, linear in between.
  static double Compare(const Buffer& buffer, double u, double v, double depth);
  double CompareSoftly(const Buffer& buffer, const BufferView::Spot& spot, double turn) const;

  LampPoints Points;
  std::vector<Buffer> Buffers;
  double Bias;
  double LightRadius = 0.0; ///< 0: hard
  double Nearest = 0.0;     ///< depth in the first buffer
};

} // namespace shadowcones

#endif
