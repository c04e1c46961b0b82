// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TruthOfImage.h
 * @brief The camera of the awkward images, and the medium term of a pixel as a plain double sum.
 */
#ifndef TruthOfImage_h
#define TruthOfImage_h

#include "PlainRays.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace robustness
{

constexpr int truthWidth = 12;
constexpr int truthHeight = 9;
constexpr double truthViewAngle = 32.0;
constexpr double truthSigmaS = 0.1;
constexpr shadowcones::Vector3 truthEye{ 0.3, -8.0, 1.4 };
constexpr shadowcones::Vector3 truthFocus{ 0.1, 0.0, 1.0 };

/// Of unit length, through the centre of a pixel.
inline shadowcones::Vector3 PixelDirection(int i, int j)
{
  using namespace shadowcones;
  const Vector3 forward = Normalized(truthFocus - truthEye);
  const Vector3 right = Normalized(Cross(forward, { 0.0, 0.0, 1.0 }));
  const Vector3 up = Cross(right, forward);
  const double half = std::tan(0.5 * truthViewAngle * 3.14159265358979323846 / 180.0);
  const double x = (2.0 * (i + 0.5) / truthWidth - 1.0) * half * truthWidth / truthHeight;
  const double y = (2.0 * (j + 0.5) / truthHeight - 1.0) * half;
  return Normalized(forward + x * right + y * up);
}

/// In a medium between (-2, -2, -0.9) and (2, 2, 3.9), below a disc of radiance 1 that faces down.
inline double TrueInScattering(const PlainRays& rays, int i, int j, double lampHeight, double lampRadius)
{
  using namespace shadowcones;
  const Vector3 d = PixelDirection(i, j);
  double begin = 0.0;
  double end = rays.Nearest(truthEye, d);
  const double low[3] = { -2.0, -2.0, -0.9 };
  const double high[3] = { 2.0, 2.0, 3.9 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (low[axis] - truthEye[axis]) / d[axis];
    const double b = (high[axis] - truthEye[axis]) / d[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(end > begin))
  {
    return 0.0;
  }
  constexpr int steps = 120;
  const std::vector<Vector3> lamp = PointsOfDisc({ 0.0, 0.0, lampHeight }, lampRadius, 4);
  const double pi = 3.14159265358979323846;
  const double area = pi * lampRadius * lampRadius / static_cast<double>(lamp.size());
  const double step = (end - begin) / steps;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double t = begin + (k + 0.5) * step;
    const Vector3 x = truthEye + t * d;
    for (const Vector3& q : lamp)
    {
      if (rays.Blocked(x, q))
      {
        continue;
      }
      const Vector3 w = q - x;
      const double distance = Length(w);
      const double inside = distance * (high[2] - x.Z) / w.Z;
      const double cosine = w.Z / distance;
      sum += std::exp(-truthSigmaS * (t - begin + inside)) * cosine / (distance * distance) * area;
    }
  }
  return sum * step * truthSigmaS / (4.0 * pi);
}

} // namespace robustness

#endif
