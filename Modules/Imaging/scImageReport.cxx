// SPDX-License-Identifier: BSD-3-Clause
#include "scImageReport.h"

#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scWarnings.h"

#include <algorithm>
#include <cstddef>

namespace shadowcones
{

namespace
{
/// Guided exceeds the goal by no more than this where it is not stopped, and by about so much stops short of the maximum.
constexpr double goalSlack = 1.5;
constexpr double nearlyAll = 0.9;

struct PixelCounts
{
  vtkIdType Pixels = 0;
  vtkIdType Bright = 0;    ///< with light of any kind
  vtkIdType OnSurfaces = 0; ///< whose ray meets one
  vtkIdType InMedium = 0;  ///< whose ray loses light in the medium
  vtkIdType Missed = 0;    ///< Guided: sampling ended above the error goal
  double WorstError = 0.0; ///< of those
};

PixelCounts CountPixels(const ScatteringImage& image, const ScatteringOptions& options)
{
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  PixelCounts counts;
  counts.Pixels = static_cast<vtkIdType>(image.Depth.size());
  for (std::size_t pixel = 0; pixel < image.Depth.size(); ++pixel)
  {
    const auto first = static_cast<std::ptrdiff_t>(pixel * wavelengths);
    const auto last = first + static_cast<std::ptrdiff_t>(wavelengths);
    const auto any = [first, last](const PixelArray<float>& values, auto is)
    { return std::any_of(values.begin() + first, values.begin() + last, is); };
    counts.Bright += any(image.Radiance, [](float value) { return value > 0.0f; }) ? 1 : 0;
    counts.OnSurfaces += image.Depth[pixel] >= 0.0f ? 1 : 0;
    counts.InMedium += any(image.Transmittance, [](float value) { return value < 1.0f; }) ? 1 : 0;
    if (options.RelativeErrorGoal > 0.0 && image.SampleCount[pixel] >= nearlyAll * options.MaximumSamples &&
      image.RelativeError[pixel] > goalSlack * options.RelativeErrorGoal)
    {
      ++counts.Missed;
      counts.WorstError = std::max(counts.WorstError, static_cast<double>(image.RelativeError[pixel]));
    }
  }
  return counts;
}

/// Does any light get lost in the medium?
bool Attenuates(const Medium& medium)
{
  const auto positive = [](double sigma) { return sigma > 0.0; };
  return std::any_of(medium.SigmaS.begin(), medium.SigmaS.end(), positive) ||
    std::any_of(medium.SigmaA.begin(), medium.SigmaA.end(), positive);
}

/// The share of a box that lies outside a visibility volume, 0..1; 0 for a flat box.
double FractionBeyond(const Box& box, const VisibilityGrid& grid)
{
  const std::array<int, 3>& n = grid.Dimensions;
  const Vector3 far = grid.Vertex(n[0] - 1, n[1] - 1, n[2] - 1);
  double inside = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = box.Max[axis] - box.Min[axis];
    if (!(length > 0.0))
    {
      return 0.0;
    }
    const double from = std::max(box.Min[axis], grid.Origin[axis]);
    const double to = std::min(box.Max[axis], far[axis]);
    inside *= std::max(to - from, 0.0) / length;
  }
  return 1.0 - inside;
}

} // namespace

void ReportImage(const ImageScene& scene, const ScatteringImage& image, bool whole, Warnings& warnings)
{
  const ScatteringOptions& options = scene.Options;
  const PixelCounts counts = CountPixels(image, options);
  if (options.Mode == ScatteringMode::Volume)
  {
    warnings.Add(MediumBeyondVolume(FractionBeyond(scene.Medium.Bounds, scene.Grids->Grids.front())));
  }
  if (options.Mode == ScatteringMode::Soft)
  {
    for (const VisibilityGrid& grid : scene.Grids->Grids)
    {
      warnings.Add(TooCoarse(grid,
        "Raise SoftDimensions, or take a vtkVisibilityVolume of Method Soft, which refines such cells, and Mode "
        "Volume."));
    }
  }
  if (options.Mode == ScatteringMode::Guided && options.RelativeErrorGoal > 0.0)
  {
    warnings.Add(
      GoalNotMet(counts.InMedium, counts.Missed, options.RelativeErrorGoal, counts.WorstError, options.MaximumSamples));
  }
  if (options.RelativeErrorGoal > 0.0)
  {
    warnings.Add(SurfaceGoalNotMet(counts.OnSurfaces, image.NumberOfShortPixels, options.RelativeErrorGoal,
      image.WorstSurfaceError, options.MaximumSamples));
  }
  warnings.Add(ThickSteps(image.NumberOfThickRays, counts.Pixels, image.MarchOpticalDepth, options.NumberOfSteps));
  if (whole)
  {
    warnings.Add(MediumNotSeen(Attenuates(scene.Medium) ? counts.Pixels : 0, counts.InMedium));
    warnings.Add(NothingSeen(counts.Pixels, counts.Bright));
  }
}

} // namespace shadowcones
