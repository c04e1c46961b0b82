// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeepShadowMaps.h
 * @brief Deep shadow maps (Lokovic and Veach 2000): in each texel the share of its rays that are blocked, as a function of depth.
 *
 * Of opaque meshes: each of Samples^2 rays through a texel is blocked from its nearest hit on. The mean of these steps is kept
 * as straight lines within a tolerance, found by their greedy rule. One map a point of the light.
 */
#ifndef DeepShadowMaps_h
#define DeepShadowMaps_h

#include "BufferView.h"
#include "LampPoints.h"
#include "Rival.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

struct DeepShadowMapOptions
{
  int Points = 1;
  int Resolution = 256;
  int Samples = 4;         ///< along both sides of a texel
  double Tolerance = 0.05; ///< of a share
  double Bias = 1e-3;      ///< of the mesh's diagonal
};

/// The share of what is blocked, against depth.
struct DepthNode
{
  float Depth;
  float Blocked;
};

/**
 * Append to @p nodes straight lines that stay within @p tolerance of the steps at the sorted depths, each of 1 / @p samples. What
 * comes after the last node is its value; before the first, 0. No node where there is no step.
 */
void CompressSteps(const std::vector<float>& depths, int samples, double tolerance, std::vector<DepthNode>& nodes);
/// The value of such lines.
double BlockedAtDepth(const DepthNode* begin, const DepthNode* end, float depth);

class DeepShadowMaps : public PointRival
{
public:
  DeepShadowMaps(const TriangleMeshView& mesh, const Light& light, const DeepShadowMapOptions& options);

  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  std::int64_t Memory() const override;

private:
  struct Map
  {
    BufferView View; ///< of single rays
    std::vector<std::uint32_t> Begin; ///< of each texel's nodes, and the end
    std::vector<DepthNode> Nodes;
  };
  double Blocked(const Map& map, const BufferView::Spot& spot) const;

  LampPoints Points;
  std::vector<Map> Maps;
  int Side;
  int Samples;
  double Bias;
};

} // namespace shadowcones

#endif
