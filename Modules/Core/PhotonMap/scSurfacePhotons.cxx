// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfacePhotons.h"

#include "scConstants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{
/// Surfaces that are turned by more than 45 degrees are others.
constexpr double leastCosine = 0.7;
} // anonymous namespace

SurfacePhotons::SurfacePhotons(StoredPhotons photons, int neighbours)
  : Stored(std::move(photons))
  , Neighbours(neighbours)
{
  Box bounds;
  for (vtkIdType id = 0; id < this->Stored.Count(); ++id)
  {
    bounds.Add(this->Stored.Point(id));
  }
  this->Tree = std::make_unique<const PointTree>(
    bounds, this->Stored.Count(), [this](vtkIdType id) { return this->Stored.Point(id); });
}

void SurfacePhotons::Estimate(const Vector3& place, const Vector3& normal, SurfaceQuery& query) const
{
  const std::size_t wavelengths = this->Stored.NumberOfWavelengths;
  query.Irradiance.assign(wavelengths, 0.0);
  query.Variance = 0.0;
  if (this->Empty())
  {
    return;
  }
  this->Tree->NearestTo(place, this->Neighbours, query.Found, query.Squared);
  const double squaredRadius = query.Squared.back();
  if (!(squaredRadius > 0.0))
  {
    return;
  }
  for (std::size_t k = 0; k < query.Found.size(); ++k)
  {
    const vtkIdType photon = query.Found[k];
    if (Dot(this->Stored.Normal(photon), normal) < leastCosine)
    {
      continue;
    }
    const double rest = 1.0 - query.Squared[k] / squaredRadius;
    const double kernel = 3.0 / (Pi * squaredRadius) * rest * rest;
    const float* power = this->Stored.Power(photon);
    double mean = 0.0;
    for (std::size_t w = 0; w < wavelengths; ++w)
    {
      query.Irradiance[w] += kernel * power[w];
      mean += kernel * power[w] / static_cast<double>(wavelengths);
    }
    query.Variance += mean * mean;
  }
}

std::int64_t SurfacePhotons::Memory() const
{
  return this->Stored.Memory() + (this->Tree ? this->Tree->Memory() : 0);
}

} // namespace shadowcones
