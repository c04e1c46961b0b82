// SPDX-License-Identifier: BSD-3-Clause
#include "scImageOutput.h"

#include "scFieldArrays.h"

#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

namespace shadowcones
{
namespace
{
/// The values of an array as floats: its own, or a copy.
class FloatValues
{
public:
  explicit FloatValues(vtkDataArray* array)
  {
    if (auto* floats = vtkFloatArray::FastDownCast(array))
    {
      this->Values = floats->GetPointer(0);
      return;
    }
    const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
    this->Copy.resize(static_cast<std::size_t>(array->GetNumberOfTuples()) * components);
    for (std::size_t i = 0; i < this->Copy.size(); ++i)
    {
      this->Copy[i] = static_cast<float>(
        array->GetComponent(static_cast<vtkIdType>(i / components), static_cast<int>(i % components)));
    }
    this->Values = this->Copy.data();
  }
  FloatValues(const FloatValues&) = delete;
  FloatValues& operator=(const FloatValues&) = delete;

  const float* Data() const { return this->Values; }

private:
  std::vector<float> Copy;
  const float* Values = nullptr;
};

void AddTriple(vtkFieldData* field, const char* name, const double* values)
{
  AddDoubleArray(field, name, 3, { values, values + 3 });
}
} // anonymous namespace

void WritePixels(const ScatteringImage& image, vtkPointData* points)
{
  const int wavelengths = image.NumberOfWavelengths;
  AddFloatArray(points, "Radiance", wavelengths, image.Radiance);
  AddFloatArray(points, "InScattering", wavelengths, image.InScattering);
  AddFloatArray(points, "SurfaceRadiance", wavelengths, image.SurfaceRadiance);
  AddFloatArray(points, "Transmittance", wavelengths, image.Transmittance);
  AddFloatArray(points, "Depth", 1, image.Depth);
  AddFloatArray(points, "RelativeError", 1, image.RelativeError);
  AddFloatArray(points, "SurfaceRelativeError", 1, image.SurfaceRelativeError);
  AddIntArray(points, "SampleCount", 1, image.SampleCount);
  if (!image.MultipleScattering.empty())
  {
    AddFloatArray(points, "MultipleScattering", wavelengths, image.MultipleScattering);
    AddFloatArray(points, "IndirectSurface", wavelengths, image.IndirectSurface);
    AddFloatArray(points, "PhotonError", 1, image.PhotonError);
  }
}

double FindExposure(vtkImageData* image, const std::vector<double>& wavelengthsInNm)
{
  vtkDataArray* radiance = image->GetPointData()->GetArray("Radiance");
  std::vector<vtkDataArray*> parts; // all but the lamp
  for (const char* name : { "InScattering", "SurfaceRadiance", "MultipleScattering", "IndirectSurface" })
  {
    vtkDataArray* array = image->GetPointData()->GetArray(name);
    if (array && array->GetNumberOfComponents() == radiance->GetNumberOfComponents() &&
      array->GetNumberOfTuples() == radiance->GetNumberOfTuples())
    {
      parts.push_back(array);
    }
    else if (parts.size() < 2)
    {
      parts = { radiance };
      break;
    }
  }
  std::vector<std::unique_ptr<FloatValues>> values;
  std::transform(parts.begin(), parts.end(), std::back_inserter(values),
    [](vtkDataArray* array) { return std::make_unique<FloatValues>(array); });

  int size[3];
  image->GetDimensions(size);
  const std::vector<double> weights = LuminanceWeights(wavelengthsInNm);
  const std::array<int, 4> extent{ 0, size[0] - 1, 0, size[1] - 1 };
  const std::size_t slice = static_cast<std::size_t>(size[0]) * size[1] * wavelengthsInNm.size();
  std::vector<double> luminances;
  std::vector<const float*> slices(values.size());
  for (int k = 0; k < size[2]; ++k)
  {
    std::transform(values.begin(), values.end(), slices.begin(),
      [&](const std::unique_ptr<FloatValues>& part) { return part->Data() + k * slice; });
    for (const std::array<int, 4>& square : ExposureSquares(size[0], size[1]))
    {
      AppendLuminances(extent, square, slices, weights, luminances);
    }
  }
  return ExposureOf(std::move(luminances));
}

void WriteRgb(vtkImageData* image, const std::vector<double>& wavelengthsInNm, double exposure, ToneCurve curve,
  vtkImageData* output)
{
  const FloatValues radiance(image->GetPointData()->GetArray("Radiance"));
  const vtkIdType pixels = image->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("RGB");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(pixels);
  ToneMap(radiance.Data(), pixels, wavelengthsInNm, exposure, curve, rgb->GetPointer(0));
  // SetScalars() would remove an array that is active.
  output->GetPointData()->AddArray(rgb);
  output->GetPointData()->SetActiveScalars("RGB");
  AddDoubleArray(output->GetFieldData(), "Exposure", 1, { exposure });
}

void WriteCamera(vtkCamera* camera, vtkFieldData* field)
{
  AddTriple(field, "CameraPosition", camera->GetPosition());
  AddTriple(field, "CameraFocalPoint", camera->GetFocalPoint());
  AddTriple(field, "CameraViewUp", camera->GetViewUp());
  AddDoubleArray(field, "CameraViewAngle", 1, { camera->GetViewAngle() });
  AddIntArray(field, "CameraParallelProjection", 1, { camera->GetParallelProjection() });
  AddDoubleArray(field, "CameraParallelScale", 1, { camera->GetParallelScale() });
}

} // namespace shadowcones
