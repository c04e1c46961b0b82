// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightLegs.h
 * @brief How much of a varying density lies between places and points of the light, read from a table. Internal to Core.
 *
 * The mean density on the way, which varies less than the optical depth, stands at the points of a grid over the medium
 * for nine points of the light: linear in place, quadratic over the light. What that errs by is measured along rays of
 * the image, against integrals, before a table is used.
 */
#ifndef scLightLegs_h
#define scLightLegs_h

#include "scBox.h"
#include "scDensityGrid.h"
#include "scLight.h"
#include "scLightRule.h"
#include "scMedium.h"
#include "scMediumOpticalDepth.h"
#include "scParallel.h"
#include "scVector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Used from any number of threads once it is filled; light and medium must outlive it.
class LightLegs
{
public:
  static constexpr int NumberOfNodes = 9; ///< on the light

  /// Two coordinates tell the points of such a light: discs, rectangles, Suns, points.
  static bool Fit(const Light& light);
  /// @param cells of the density from one point of the table to the next.
  LightLegs(const Light& light, const Medium& medium, double cells);
  std::int64_t NumberOfPlaces() const
  {
    return static_cast<std::int64_t>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
  /// @return false where the monitor asked to stop.
  bool Fill(const Monitor& monitor);

  /// A place and the mean densities from there to the nodes on the light.
  struct Place
  {
    Vector3 Point;
    bool InTable = false;
    std::array<float, NumberOfNodes> Means;
  };
  void LookAt(const Vector3& point, Place& place) const;
  /// Optical depth as of MediumOpticalDepth::Towards(), to a point of the light.
  double Towards(const Place& place, const Vector3& direction, double distance) const
  {
    const double length = std::min(distance, ExitDistance(this->Air.Bounds, place.Point, direction));
    if (!place.InTable || (!this->AtInfinity && distance == HUGE_VAL))
    {
      return this->Air.Density->Integrate(place.Point, direction, 0.0, length);
    }
    const std::array<float, NumberOfNodes> weights = this->WeightsOf(
      this->AtInfinity ? direction - this->Center : place.Point + distance * direction - this->Center);
    float mean = 0.0f;
    for (std::size_t k = 0; k < NumberOfNodes; ++k)
    {
      mean += weights[k] * place.Means[k];
    }
    return length * static_cast<double>(mean > 0.0f ? mean : 0.0f);
  }
  /// Multiply lengths of ways to @p count points of the light, whose weights are given as by WeightsOf(), by the mean
  /// density.
  static void MultiplyByMeans(const Place& place, const float* weights, int count, float* legs);
  /// Weights of the nodes for the points of a rule by area, all points of a node in a row.
  std::vector<float> WeightsOf(const LightRule& rule) const;

  /// @name Measured along rays of the image: standard errors
  ///@{
  double ErrorOfRays = 0.0; ///< of the light on a ray, over it
  double ErrorOfLegs = 0.0; ///< of the transmittance to single points of the light, over it
  ///@}

private:
  std::array<float, NumberOfNodes> WeightsOf(const Vector3& offset) const;
  float MeanTowards(const Vector3& point, int node) const;

  const Medium& Air;
  const bool AtInfinity;
  Vector3 Center; ///< of the light; of a light at infinity, the direction towards it
  Vector3 U;      ///< to the edge of the light
  Vector3 V;
  Vector3 PerU; ///< a coordinate on the light is the product with this
  Vector3 PerV;
  Box Region; ///< of the table
  std::array<int, 3> Dimensions{ { 2, 2, 2 } };
  std::array<double, 3> PerLength{}; ///< steps
  std::vector<float> Values; ///< of the nodes, at every place
};

/// Optical depth from a point in the medium by a table, or by an integral where there is none.
inline double DepthTowards(const LightLegs* legs, const MediumOpticalDepth& depth, const Vector3& point,
  const Vector3& direction, double distance)
{
  if (!legs)
  {
    return depth.Towards(point, direction, distance);
  }
  LightLegs::Place place;
  legs->LookAt(point, place);
  return legs->Towards(place, direction, distance);
}

} // namespace shadowcones

#endif
