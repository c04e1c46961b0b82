// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GrowthSweep.h
 * @brief How the time of each stage grows with resolution, light radius, triangles, photons, cones and threads.
 */
#ifndef GrowthSweep_h
#define GrowthSweep_h

#include "JsonWriter.h"
#include "SpeedMeasurement.h"

#include <string>
#include <vector>

namespace shadowcones
{

/// Times of one stage at values of one parameter, everything else at its default.
struct Growth
{
  std::string Parameter;
  std::string Stage;
  std::vector<double> Values;
  std::vector<double> Seconds; ///< medians, of the processor, which other work does not change; of threads by the wall clock

  double Exponent() const { return GrowthExponent(this->Values, this->Seconds); }
};

/// The meshes of the sweep over triangles are written into the folder of the setting.
std::vector<Growth> MeasureGrowth(const std::string& nameOrFile, const SpeedSetting& setting);
void PrintGrowth(const std::string& scene, const std::vector<Growth>& list);
void WriteGrowth(const std::vector<Growth>& list, JsonWriter& json);

} // namespace shadowcones

#endif
