// SPDX-License-Identifier: BSD-3-Clause
#include "scFreeFlight.h"

#include "scDensityGrid.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

FreeFlight::FreeFlight(const Medium& medium)
  : Density(medium.Density)
{
  if (this->Density)
  {
    const std::vector<float>& values = this->Density->Values;
    this->Densest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  }
}

double FreeFlight::Sample(double sigmaT, const Ray& ray, const RayInterval& inside, RandomStream& random) const
{
  const double most = sigmaT * this->Densest;
  double begin = inside.Begin;
  double end = inside.End;
  if (!(most > 0.0) ||
    (this->Density &&
      (this->Density->Support.Empty() ||
        !this->Density->Support.Clip(
          this->Density->IndexPoint(ray.Origin), this->Density->IndexDirection(ray.Direction), begin, end))))
  {
    return HUGE_VAL;
  }
  for (double t = begin;;)
  {
    t -= std::log1p(-random.Next()) / most;
    if (!(t < end))
    {
      return HUGE_VAL;
    }
    if (!this->Density || random.Next() * this->Densest < this->Density->At(ray.Origin + t * ray.Direction))
    {
      return t;
    }
  }
}

double FreeFlight::OpticalDepth(const Ray& ray, const RayInterval& part) const
{
  if (part.Empty())
  {
    return 0.0;
  }
  return this->Density ? this->Density->Integrate(ray.Origin, ray.Direction, part.Begin, part.End)
                       : part.End - part.Begin;
}

} // namespace shadowcones
