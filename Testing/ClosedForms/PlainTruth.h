// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainTruth.h
 * @brief The medium term of a pixel under a disc, by samples that share no light rule with what they judge.
 */
#ifndef PlainTruth_h
#define PlainTruth_h

#include "Scenes.h"
#include "scDensityGrid.h"
#include "scRandom.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shadowcones
{

struct PlainTruth
{
  double Mean = 0.0;
  double Error = 0.0; ///< one standard error
};

/// Optical depth over sigma_t of the way between two points in the bounds: a plain sum of the density.
inline double PlainDepth(const Medium& fog, const Vector3& from, const Vector3& to)
{
  const double length = Length(to - from);
  if (!fog.Density)
  {
    return length;
  }
  constexpr int steps = 48;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    sum += fog.Density->At(from + (k + 0.5) / steps * (to - from));
  }
  return sum * length / steps;
}

/**
 * One wavelength, isotropic scattering. Places are stratified in the angle under which the ray is seen from the disc's
 * centre, points of the disc are even in area, from a lattice (Roberts 2018) that is shifted at random; the rest is the
 * integrand as it stands in books. The error is that of @p repeats independent estimates.
 */
inline PlainTruth PlainInScattering(const testsupport::ImageTestScene& scene, const OccluderScene& occluders, int i,
  int j, int samples, std::uint64_t seed, int repeats = 4)
{
  const Ray ray = scene.PixelRay(i, j);
  const Light& lamp = scene.Source;
  double begin = 0.0;
  double end = HUGE_VAL;
  RayHit hit;
  if (occluders.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, hit))
  {
    end = hit.T;
  }
  PlainTruth truth;
  if (!scene.Fog.Bounds.Clip(ray.Origin, ray.Direction, begin, end))
  {
    return truth;
  }
  const double pi = testsupport::Pi;
  const double nearest = Dot(lamp.Center - ray.Origin, ray.Direction);
  const double distance = Length(ray.Origin + nearest * ray.Direction - lamp.Center);
  const double first = std::atan((begin - nearest) / distance);
  const double angle = std::atan((end - nearest) / distance) - first;
  const Vector3 u = Normalized(Cross(lamp.Normal, { 0.3, 0.5, 0.8 }));
  const Vector3 v = Cross(lamp.Normal, u);
  const double area = pi * lamp.Radius * lamp.Radius;
  const double sigmaT = scene.Fog.SigmaS[0] + scene.Fog.SigmaA[0];
  const double source = scene.Fog.SigmaS[0] * lamp.Spectrum[0] / (4.0 * pi);
  double squares = 0.0;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    RandomStream random(seed + static_cast<std::uint64_t>(repeat), static_cast<std::uint64_t>(j * 4096 + i));
    const double shift[2] = { random.Next(), random.Next() };
    double sum = 0.0;
    for (int k = 0; k < samples; ++k)
    {
      const double t = nearest + distance * std::tan(first + angle * (k + random.Next()) / samples);
      const Vector3 x = ray.Origin + t * ray.Direction;
      double whole = 0.0;
      const double radius = lamp.Radius * std::sqrt(std::modf(shift[0] + 0.7548776662466927 * k, &whole));
      const double turn = 2.0 * pi * std::modf(shift[1] + 0.5698402909980532 * k, &whole);
      const Vector3 to = lamp.Center + radius * (std::cos(turn) * u + std::sin(turn) * v) - x;
      const double length = Length(to);
      const Vector3 direction = (1.0 / length) * to;
      const double cosine = -Dot(direction, lamp.Normal);
      if (cosine > 0.0 && !occluders.Occluded(x, direction, 0.0, length))
      {
        double from = 0.0;
        double leg = length;
        scene.Fog.Bounds.Clip(x, direction, from, leg);
        const double perAngle = (distance * distance + (t - nearest) * (t - nearest)) / distance;
        const double density = scene.Fog.Density ? scene.Fog.Density->At(x) : 1.0;
        sum += source * area * cosine / (length * length) * density *
          std::exp(-sigmaT *
            (PlainDepth(scene.Fog, ray.Origin + begin * ray.Direction, x) +
              PlainDepth(scene.Fog, x, x + leg * direction))) *
          perAngle;
      }
    }
    const double estimate = sum * angle / samples;
    truth.Mean += estimate / repeats;
    squares += estimate * estimate / repeats;
  }
  truth.Error = repeats > 1 ? std::sqrt(std::max(squares - truth.Mean * truth.Mean, 0.0) / (repeats - 1)) : 0.0;
  return truth;
}

/// What pixels of one wavelength err by, over what they claim and what the truth errs by.
struct ClaimsHeld
{
  int WithinTwo = 0; ///< number of pixels
  double Mean = 0.0;
  double Root = 0.0; ///< of the mean square
};

/// @param pixels where each of the truths is in the image's arrays.
inline ClaimsHeld JudgeClaims(
  const ScatteringImage& image, const std::vector<std::size_t>& pixels, const std::vector<PlainTruth>& truths)
{
  ClaimsHeld held;
  const auto count = static_cast<double>(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k)
  {
    const double value = image.InScattering[pixels[k]];
    const double claim = std::hypot(static_cast<double>(image.RelativeError[pixels[k]]) * value, truths[k].Error);
    const double ratio = (value - truths[k].Mean) / claim;
    held.WithinTwo += std::fabs(ratio) <= 2.0;
    held.Mean += ratio / count;
    held.Root += ratio * ratio / count;
  }
  held.Root = std::sqrt(held.Root);
  return held;
}

} // namespace shadowcones

#endif
