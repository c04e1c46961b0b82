// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scIntervalLight.h
 * @brief The unshadowed light of a ray in the intervals where occluders may block. Internal to Core.
 */
#ifndef scIntervalLight_h
#define scIntervalLight_h

#include "scEndDensity.h"
#include "scExtinctionGroups.h"
#include "scLitSums.h"
#include "scRayInterval.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

class IntervalLight
{
public:
  /// An interval in the distribution of places: from where, how much, and how much came in intervals before.
  struct Part
  {
    double Begin = 0.0;
    double Light = 0.0;
    double Before = 0.0;
    double From = 0.0; ///< as distances
    double To = 0.0;
  };
  /// Where a place is; places ascend.
  struct Node
  {
    std::size_t Part = 0;
    int Cell = 0;
  };

  explicit IntervalLight(const ExtinctionGroups& groups)
    : Groups(groups)
  {
  }

  /// @param lit with its distribution, which must outlive this; @param intervals ascending. @return is there any light?
  bool Set(const LitSums& lit, const std::vector<RayInterval>& intervals);

  const LitSums& Lit() const { return *this->Sums; }
  const std::vector<Part>& Parts() const { return this->PartsOfRay; }
  /// Per group, as exact as the profile is.
  const std::vector<double>& Inside() const { return this->InGroups; }
  double MeanInside() const { return this->Mean; } ///< over wavelengths
  double Distributed() const { return this->All; } ///< the same by the distribution of places

  /**
   * To where so much of the intervals' light lies before, each interval's places moved towards its ends.
   * @param density of places there, over an even one. @return the distance along the ray.
   */
  double MoveTo(double light, const EndDensity& ends, Node& node, double& density) const
  {
    while (node.Part + 1 < this->PartsOfRay.size() && light >= this->PartsOfRay[node.Part + 1].Before)
    {
      ++node.Part;
    }
    const Part& part = this->PartsOfRay[node.Part];
    const double before = light - part.Before;
    if (ends.IsEven())
    {
      density = 1.0;
      return this->MoveToSum(part.Begin + before, node.Cell);
    }
    const double place = ends.Place(before / part.Light);
    density = ends.Density(place);
    return this->MoveToSum(part.Begin + place * part.Light, node.Cell);
  }
  /// The same for light counted from the beginning of the ray.
  double MoveToSum(double sum, int& cell) const;

private:
  const ExtinctionGroups& Groups;
  const LitSums* Sums = nullptr;
  std::vector<Part> PartsOfRay;
  std::vector<double> InGroups;
  double Mean = 0.0;
  double All = 0.0;
};

} // namespace shadowcones

#endif
