// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibleRatio.h
 * @brief What is left of a ray's light, from two sums over the same samples. Internal to Core.
 *
 * What is visible in the intervals is their unshadowed light times a ratio: the light of samples that see the lamp over
 * the light of all. So nothing is left where all are blocked, all is left where none is, and an error of the unshadowed
 * term is as large, relatively, in what is left.
 */
#ifndef scVisibleRatio_h
#define scVisibleRatio_h

#include "scExtinctionGroups.h"
#include "scIntervalLight.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

class VisibleRatio
{
public:
  explicit VisibleRatio(const ExtinctionGroups& groups)
    : Groups(groups)
  {
  }

  void Forget()
  {
    this->All.assign(static_cast<std::size_t>(this->Groups.Count()), 0.0);
    this->Visible = this->All;
  }
  void Add(std::size_t group, double all, double visible)
  {
    this->All[group] += all;
    this->Visible[group] += visible;
  }
  /// All of the ray's light is left: there is no sample.
  void LeaveAll(const IntervalLight& intervals);
  /// @param weights sum over samples of what theirs were multiplied by.
  void Conclude(const IntervalLight& intervals, double weights);
  /**
   * Squared error with that of the unshadowed light, which enters by its sum in the intervals times the ratio, and by
   * what lies outside of them; and with that of the weights of all samples, relative: where the visible ones err one way
   * and the hidden ones the other, as far as can be.
   */
  double SquaredError(
    const IntervalLight& intervals, double sampledVariance, double litError, double weightError) const;

  const std::vector<double>& Left() const { return this->LeftOfGroups; } ///< per group
  double MeanLeft() const { return this->Mean; }                         ///< over wavelengths
  double Ratio() const { return this->MeanRatio; }                       ///< of means over wavelengths
  double PerAll() const { return this->LightPerAll; }                    ///< light for each unit of the samples

private:
  const ExtinctionGroups& Groups;
  std::vector<double> All; ///< weighted sums, per group
  std::vector<double> Visible;
  std::vector<double> LeftOfGroups;
  double Mean = 0.0;
  double MeanRatio = 1.0;
  double LightPerAll = 0.0;
};

} // namespace shadowcones

#endif
