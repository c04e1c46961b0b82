// SPDX-License-Identifier: BSD-3-Clause
#include "scScatteringOptions.h"

#include <limits>

namespace shadowcones
{
namespace
{
/// What is wrong with numbers of the image and of samples.
const char* CheckCounts(const ScatteringOptions& options)
{
  constexpr int mostSamples = 65536;
  if (options.Width < 1 || options.Height < 1 || options.Width > std::numeric_limits<int>::max() / options.Height)
  {
    return "Width and Height must be at least 1, and their product at most 2^31 - 1";
  }
  if (options.NumberOfSteps < 1 || options.NumberOfSteps > 1000000)
  {
    return "NumberOfSteps must lie in 1..1000000";
  }
  if (options.MaximumHalvings < 0 || options.MaximumHalvings > 16)
  {
    return "MaximumHalvings must lie in 0..16";
  }
  if (options.NumberOfLightSamples < 1 || options.NumberOfLightSamples > mostSamples)
  {
    return "NumberOfLightSamples must lie in 1..65536";
  }
  if (options.NumberOfSurfaceLightSamples < 0 || options.NumberOfSurfaceLightSamples > mostSamples)
  {
    return "NumberOfSurfaceLightSamples must lie in 0..65536";
  }
  if (options.NumberOfEdgeSamples < 1 || options.NumberOfEdgeSamples > 1024)
  {
    return "NumberOfEdgeSamples must lie in 1..1024";
  }
  return options.MaximumSamples < 1 ? "MaximumSamples must be at least 1" : nullptr;
}
} // anonymous namespace

const char* CheckScatteringOptions(const ScatteringOptions& options)
{
  if (const char* fault = CheckCounts(options))
  {
    return fault;
  }
  if (options.Mode < ScatteringMode::BruteForce || options.Mode > ScatteringMode::Volume)
  {
    return "Mode must be 0 (BruteForce), 1 (Medium), 2 (Fast), 3 (Guided), 4 (Soft) or 5 (Volume)";
  }
  if (options.Extent[0] < 0 || options.Extent[2] < 0)
  {
    return "Extent must begin at pixel 0 or above";
  }
  if (!(options.IntensityThreshold >= 0.0))
  {
    return "IntensityThreshold must be 0 or above";
  }
  if (!(options.ShareNearEnds >= 0.0 && options.ShareNearEnds < 1.0))
  {
    return "ShareNearEnds must be 0 or above, and below 1";
  }
  if (!(options.RelativeErrorGoal >= 0.0))
  {
    return "RelativeErrorGoal must be 0 or above";
  }
  if (!(options.Reflectance >= 0.0 && options.Reflectance <= 1.0))
  {
    return "Reflectance must lie in 0..1";
  }
  return nullptr;
}

} // namespace shadowcones
