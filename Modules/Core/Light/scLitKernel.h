// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitKernel.h
 * @brief The innermost loops of the unshadowed term: many light points seen from one point. Internal to Core.
 *
 * In single precision and relative to the point, hence exact enough however far from the origin the scene is.
 */
#ifndef scLitKernel_h
#define scLitKernel_h

namespace shadowcones
{

/// Points of a light about its centre, their unit normals, and the area that each stands for.
struct LightPoints
{
  const float* X;
  const float* Y;
  const float* Z;
  const float* NormalX;
  const float* NormalY;
  const float* NormalZ;
  const float* Area;
  int Count;
};

/// A point in a box medium: everything relative to it.
struct LightPointsView
{
  float Center[3]; ///< of the light
  float Direction[3]; ///< of the camera ray through the point
  float Low[3];       ///< corners of the box
  float High[3];
};

/// For every light point: its solid angle as seen from the point, the cosine of scattering, the length in the box. The
/// point lies in the box; a light point at the very same place counts for nothing.
void LookAtLight(
  const LightPoints& points, const LightPointsView& view, float* weight, float* cosine, float* leg);

/// Sum of weight exp(-sigmaT leg); sigmaT leg >= 0.
float SumAttenuated(const float* weight, const float* leg, int count, float sigmaT);

} // namespace shadowcones

#endif
