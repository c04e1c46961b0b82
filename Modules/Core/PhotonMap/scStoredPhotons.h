// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scStoredPhotons.h
 * @brief Photons where light met a surface, or was scattered by the medium.
 */
#ifndef scStoredPhotons_h
#define scStoredPhotons_h

#include "scVector3.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Structure of arrays; so many values a photon as named.
struct StoredPhotons
{
  std::size_t NumberOfWavelengths = 0;
  std::vector<double> Points;    ///< 3
  std::vector<float> Directions; ///< 3, unit: the way that the light travels before it meets what is here
  std::vector<float> Normals;    ///< 3, unit, on the side that the light came from; of surfaces alone
  std::vector<float> Powers;     ///< one a wavelength, W
  std::vector<int> Bounces;      ///< scatterings and reflections on the way: 0 straight from the light

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Bounces.size()); }
  Vector3 Point(vtkIdType id) const
  {
    return { this->Points[3 * id], this->Points[3 * id + 1], this->Points[3 * id + 2] };
  }
  Vector3 Direction(vtkIdType id) const
  {
    return { this->Directions[3 * id], this->Directions[3 * id + 1], this->Directions[3 * id + 2] };
  }
  Vector3 Normal(vtkIdType id) const
  {
    return { this->Normals[3 * id], this->Normals[3 * id + 1], this->Normals[3 * id + 2] };
  }
  const float* Power(vtkIdType id) const
  {
    return this->Powers.data() + static_cast<std::size_t>(id) * this->NumberOfWavelengths;
  }
  /// Photons after those that are there.
  void Append(const StoredPhotons& more)
  {
    const auto append = [](auto& values, const auto& others)
    { values.insert(values.end(), others.begin(), others.end()); };
    this->NumberOfWavelengths = more.NumberOfWavelengths;
    append(this->Points, more.Points);
    append(this->Directions, more.Directions);
    append(this->Normals, more.Normals);
    append(this->Powers, more.Powers);
    append(this->Bounces, more.Bounces);
  }
  /// Bytes.
  std::int64_t Memory() const
  {
    return static_cast<std::int64_t>(this->Points.capacity() * sizeof(double) +
      (this->Directions.capacity() + this->Normals.capacity() + this->Powers.capacity()) * sizeof(float) +
      this->Bounces.capacity() * sizeof(int));
  }
};

} // namespace shadowcones

#endif
