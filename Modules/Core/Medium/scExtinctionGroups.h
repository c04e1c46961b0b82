// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scExtinctionGroups.h
 * @brief Wavelengths with one extinction coefficient share one march. Internal to Core.
 */
#ifndef scExtinctionGroups_h
#define scExtinctionGroups_h

#include "scMedium.h"

#include <vector>

namespace shadowcones
{

/// The wavelength samples of a light in a medium, grouped by sigma_t = sigma_s + sigma_a.
struct ExtinctionGroups
{
  std::vector<double> SigmaT; ///< per group
  std::vector<double>
    MeanScatteredRadiance;  ///< per group: sum of its wavelengths' sigma_s * L over the number of all wavelengths
  std::vector<int> GroupOf; ///< per wavelength
  std::vector<double> ScatteredRadiance; ///< per wavelength: sigma_s * L

  ExtinctionGroups(const std::vector<double>& spectrum, const Medium& medium)
  {
    const std::size_t count = spectrum.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      const double sigmaT = medium.SigmaS[k] + medium.SigmaA[k];
      std::size_t group = 0;
      while (group < this->SigmaT.size() && this->SigmaT[group] != sigmaT)
      {
        ++group;
      }
      if (group == this->SigmaT.size())
      {
        this->SigmaT.push_back(sigmaT);
        this->MeanScatteredRadiance.push_back(0.0);
      }
      this->GroupOf.push_back(static_cast<int>(group));
      this->ScatteredRadiance.push_back(medium.SigmaS[k] * spectrum[k]);
      this->MeanScatteredRadiance[group] += this->ScatteredRadiance.back() / static_cast<double>(count);
    }
  }

  int Count() const { return static_cast<int>(this->SigmaT.size()); }
  /// Radiance at every wavelength from one integral a group. @return its mean over wavelengths.
  double ToRadiance(const std::vector<double>& integrals, float* radiance) const
  {
    double mean = 0.0;
    for (std::size_t k = 0; k < this->ScatteredRadiance.size(); ++k)
    {
      const double value = this->ScatteredRadiance[k] * integrals[static_cast<std::size_t>(this->GroupOf[k])];
      radiance[k] = static_cast<float>(value);
      mean += value / static_cast<double>(this->ScatteredRadiance.size());
    }
    return mean;
  }
  /// False where no wavelength scatters any light.
  bool Scatters() const
  {
    for (const double radiance : this->ScatteredRadiance)
    {
      if (radiance > 0.0)
      {
        return true;
      }
    }
    return false;
  }
};

} // namespace shadowcones

#endif
