// SPDX-License-Identifier: BSD-3-Clause
#include "RivalReference.h"

#include "scReference.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

//------------------------------------------------------------------------------
HiddenLight ReferenceHiddenLight(const RivalMarch& march, const ReferenceScene& occluders, std::size_t pixel, int samples)
{
  constexpr int parts = 16;
  HiddenLight result;
  const RivalRay& ray = march.PixelRay(pixel);
  if (ray.Count() == 0)
  {
    return result;
  }
  const ScatteringScene& scene = march.Scene();
  const ExtinctionGroups groups(scene.Light.Spectrum, scene.Medium);
  const double from = ray.Cuts.front();
  const double to = ray.Cuts.back();
  const EvenAngle even(scene.Light, ray.Line);
  const double first = even.At(from);
  const int strata = std::max(1, samples / parts);
  const double step = (even.At(to) - first) / strata;
  double squares = 0.0;
  for (int part = 0; part < parts; ++part)
  {
    RandomStream random(HashSeed(8, pixel), static_cast<std::uint64_t>(part));
    double sum = 0.0;
    for (int k = 0; k < strata; ++k)
    {
      const double variable = first + (k + random.Next()) * step;
      const double t = std::clamp(even.Distance(variable), from, to);
      const Vector3 point = ray.Line.Origin + t * ray.Line.Direction;
      const double u = random.Next();
      const IncidentSample sample = SampleIncidentLight(scene.Light, point, u, random.Next());
      if (sample.Weight > 0.0 && occluders.Blocked(point, sample.Direction, 0.0, sample.Distance * (1.0 - 1e-9)))
      {
        sum += step * even.Slope(variable) * ScatteredTowardsCamera(scene, groups, ray.Line, from, t, sample);
      }
    }
    result.Mean += sum / parts;
    squares += sum * sum / parts;
  }
  result.StandardError = std::sqrt(std::max(0.0, squares - result.Mean * result.Mean) / (parts - 1));
  return result;
}

} // namespace shadowcones
