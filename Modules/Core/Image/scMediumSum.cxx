// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumSum.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{

bool MediumSum::Add(const ScatteringImage& term, const Monitor& monitor)
{
  const std::size_t pixels = term.RelativeError.size();
  const auto wavelengths = static_cast<std::size_t>(term.NumberOfWavelengths);
  const bool first = std::exchange(this->IsEmpty, false);
  this->InScattering.Resize(pixels * wavelengths);
  this->Errors.Resize(pixels);
  this->Samples.Resize(pixels);
  this->OcclusionRays += term.NumberOfOcclusionRays;
  this->ShadowLines += term.NumberOfShadowLines;
  this->ThickRays += term.NumberOfThickRays;
  this->OpticalDepth = std::max(this->OpticalDepth, term.MarchOpticalDepth);
  return ParallelFor(static_cast<vtkIdType>(pixels), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto pixel = static_cast<std::size_t>(begin); pixel < static_cast<std::size_t>(end); ++pixel)
      {
        for (std::size_t k = pixel * wavelengths; k < (pixel + 1) * wavelengths; ++k)
        {
          this->InScattering[k] = (first ? 0.0 : this->InScattering[k]) + term.InScattering[k];
        }
        const double error = term.MediumError[pixel];
        this->Errors[pixel] = error < 0.0 ? HUGE_VAL : (first ? 0.0 : this->Errors[pixel]) + error;
        this->Samples[pixel] = (first ? 0 : this->Samples[pixel]) + term.SampleCount[pixel];
      }
    });
}

bool MediumSum::Write(const Monitor& monitor, ScatteringImage& image) const
{
  image.NumberOfOcclusionRays += this->OcclusionRays;
  image.NumberOfShadowLines += this->ShadowLines;
  image.NumberOfThickRays += this->ThickRays;
  image.MarchOpticalDepth = std::max(image.MarchOpticalDepth, this->OpticalDepth);
  return ParallelFor(static_cast<vtkIdType>(this->Errors.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto pixel = static_cast<std::size_t>(begin); pixel < static_cast<std::size_t>(end); ++pixel)
      {
        this->WritePixel(pixel, image);
      }
    });
}

void MediumSum::WritePixel(std::size_t pixel, ScatteringImage& image) const
{
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  image.SampleCount[pixel] = this->Samples[pixel];
  double mean = 0.0;
  for (std::size_t k = pixel * wavelengths; k < (pixel + 1) * wavelengths; ++k)
  {
    image.InScattering[k] = static_cast<float>(this->InScattering[k]);
    mean += this->InScattering[k] / static_cast<double>(wavelengths);
  }
  const double error = this->Errors[pixel];
  const double relative = mean > 0.0 ? error / mean : (error > 0.0 ? 1.0 : 0.0);
  image.RelativeError[pixel] = error == HUGE_VAL ? -1.0f : static_cast<float>(relative);
  image.MediumError[pixel] = error == HUGE_VAL ? -1.0f : static_cast<float>(error);
}

} // namespace shadowcones
