// SPDX-License-Identifier: BSD-3-Clause
#include "scLitKernel.h"

#include "scWideLoops.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace shadowcones
{
namespace
{
/// exp(-x) for x >= 0, to 2e-7: 2^-f by a polynomial (its Taylor series to 2e-8 on [-1/2, 1/2]) and an exponent by bits.
inline float ExponentialOfMinus(float x)
{
  float y = -1.44269504f * x;
  y = y < -126.0f ? -126.0f : y;
  const float whole = (y + 12582912.0f) - 12582912.0f; // rounded: the constant is 1.5 * 2^23
  const float f = y - whole;
  const float power = 1.0f +
    f *
      (0.693147181f +
        f * (0.240226507f + f * (0.0555041087f + f * (0.00961812911f + f * (0.00133335581f + f * 0.000154035304f)))));
  const std::int32_t bits = (static_cast<std::int32_t>(whole) + 127) << 23;
  float scale = 0.0f;
  std::memcpy(&scale, &bits, sizeof(scale));
  return power * scale;
}

/// Share of the way to the light after which a ray leaves the box along one axis; never, where it runs along the faces.
inline float ShareInside(float d, float low, float high)
{
  const float plane = d > 0.0f ? high : low;
  const float slope = d == 0.0f ? 1.0f : d;
  return d == 0.0f ? 1.0f : plane / slope;
}
} // anonymous namespace

SHADOWCONES_WIDE void LookAtLight(
  const LightPoints& points, const LightPointsView& view, float* weight, float* cosine, float* leg)
{
  const LightPointsView v = view;
  for (int k = 0; k < points.Count; ++k)
  {
    const float x = v.Center[0] + points.X[k];
    const float y = v.Center[1] + points.Y[k];
    const float z = v.Center[2] + points.Z[k];
    const float squared = x * x + y * y + z * z;
    const float distance = std::sqrt(squared);
    // A light point that is the very point has no direction: it sends nothing.
    const float inverse = squared > 0.0f ? 1.0f / distance : 0.0f;
    const float emission = -(x * points.NormalX[k] + y * points.NormalY[k] + z * points.NormalZ[k]) * inverse;
    cosine[k] = (x * v.Direction[0] + y * v.Direction[1] + z * v.Direction[2]) * inverse;
    weight[k] = emission > 0.0f ? points.Area[k] * emission * inverse * inverse : 0.0f;
    const float sx = ShareInside(x, v.Low[0], v.High[0]);
    const float sy = ShareInside(y, v.Low[1], v.High[1]);
    const float sz = ShareInside(z, v.Low[2], v.High[2]);
    float fraction = sx < sy ? sx : sy;
    fraction = fraction < sz ? fraction : sz;
    fraction = fraction < 1.0f ? fraction : 1.0f;
    leg[k] = fraction > 0.0f ? fraction * distance : 0.0f;
  }
}

SHADOWCONES_WIDE float SumAttenuated(const float* weight, const float* leg, int count, float sigmaT)
{
  // Eight sums: the order of additions is the same for every width of vectors.
  float sums[8] = {};
  const int blocks = count / 8;
  for (int block = 0; block < blocks; ++block)
  {
    for (int k = 0; k < 8; ++k)
    {
      const int at = 8 * block + k;
      sums[k] += weight[at] * ExponentialOfMinus(sigmaT * leg[at]);
    }
  }
  float sum = 0.0f;
  for (int at = 8 * blocks; at < count; ++at)
  {
    sum += weight[at] * ExponentialOfMinus(sigmaT * leg[at]);
  }
  return sum + ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

} // namespace shadowcones
