// SPDX-License-Identifier: BSD-3-Clause
#include "scKeptImage.h"

#include "scFieldArrays.h"
#include "scFingerprints.h"
#include "scImageOutput.h"
#include "scImageScene.h"
#include "scLightData.h"
#include "scMediumData.h"
#include "scOccluderNames.h"
#include "scToneMap.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace shadowcones
{

bool IsWhole(const int extent[6], const int resolution[2])
{
  return extent[0] == 0 && extent[2] == 0 && extent[1] == resolution[0] - 1 && extent[3] == resolution[1] - 1;
}

void KeptImage::Drop()
{
  this->Pixels = nullptr;
  this->Wavelengths.clear();
  this->Exposure = 0.0;
}

void KeptImage::DropIfOld(vtkInformationVector** inputs, int numberOfPorts, vtkMTimeType parametersChanged)
{
  const std::vector<InputStamp> stamps = StampsOf(inputs, numberOfPorts);
  if (parametersChanged != this->ParametersChanged || !(stamps == this->Inputs))
  {
    this->Drop();
    this->ParametersChanged = parametersChanged;
    this->Inputs = stamps;
  }
}

bool KeptImage::HoldsPixels(const int extent[6]) const
{
  return this->Pixels && std::equal(extent, extent + 6, this->Pixels->GetExtent());
}

void KeptImage::KeepPixels(ScatteringImage& image, const ImageScene& scene, const int extent[6], double seconds)
{
  auto pixels = vtkSmartPointer<vtkImageData>::New();
  int own[6];
  std::copy_n(extent, 6, own);
  pixels->SetExtent(own);
  WritePixels(image, pixels->GetPointData());
  vtkFieldData* field = pixels->GetFieldData();
  AddIntArray(field, "Mode", 1, { static_cast<int>(scene.Options.Mode) });
  AddIntArray(field, "Seed", 1, { static_cast<int>(scene.Options.Seed) });
  if (scene.HasCones)
  {
    AddIntArray(field, "Certified", 1, { scene.ConesProved ? 1 : 0 });
  }
  AddDoubleArray(field, "RelativeErrorGoal", 1, { scene.Options.RelativeErrorGoal });
  AddIdArray(field, "NumberOfOcclusionRays", { image.NumberOfOcclusionRays });
  AddIdArray(field, "NumberOfShadowLines", { image.NumberOfShadowLines });
  AddDoubleArray(field, "RenderSeconds", 1, { seconds });
  AddDoubleArray(field, "LightWavelengths", 1, scene.Lights.Wavelengths);
  WriteCamera(scene.UsedCamera, field);
  WriteMedium(scene.Medium, field);
  WriteOccluderNames(scene.OccluderNames, field);
  WriteFingerprints(castersFingerprint, scene.CastersFingerprints, field);
  WriteLightFingerprints(scene.Lights.Lights, pixels);
  this->Pixels = pixels;
}

std::vector<std::array<int, 4>> KeptImage::MissingExtents(
  const int extent[6], const int resolution[2], bool automaticExposure) const
{
  std::vector<std::array<int, 4>> missing;
  if (!this->HoldsPixels(extent))
  {
    missing.push_back({ extent[0], extent[1], extent[2], extent[3] });
  }
  if (automaticExposure && this->Exposure == 0.0 && !IsWhole(extent, resolution))
  {
    const auto squares = ExposureSquares(resolution[0], resolution[1]);
    missing.insert(missing.end(), squares.begin(), squares.end());
  }
  return missing;
}

void KeptImage::KeepExposure(
  const std::vector<std::array<int, 4>>& extents, const std::vector<ScatteringImage>& images, std::size_t first)
{
  if (first >= extents.size())
  {
    return;
  }
  const std::vector<double> weights = LuminanceWeights(this->Wavelengths);
  std::vector<double> luminances;
  for (std::size_t k = first; k < extents.size(); ++k)
  {
    const ScatteringImage& image = images[k];
    std::vector<const float*> parts{ image.InScattering.data(), image.SurfaceRadiance.data() };
    if (!image.MultipleScattering.empty())
    {
      parts.insert(parts.end(), { image.MultipleScattering.data(), image.IndirectSurface.data() });
    }
    AppendLuminances(extents[k], extents[k], parts, weights, luminances);
  }
  this->Exposure = ExposureOf(std::move(luminances));
}

} // namespace shadowcones
