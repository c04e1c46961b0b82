// SPDX-License-Identifier: BSD-3-Clause
#include "scImageOutput.h"

#include "scFieldArrays.h"

#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
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

/// An array that has the memory of the values.
template <typename Array, typename T>
void Give(vtkPointData* points, const char* name, int components, PixelArray<T>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  const auto count = static_cast<vtkIdType>(values.size());
  constexpr int freedByArray = 0;
  array->SetArray(values.Release(), count, freedByArray, Array::VTK_DATA_ARRAY_FREE);
  points->AddArray(array);
}

void AddTriple(vtkFieldData* field, const char* name, const double* values)
{
  AddDoubleArray(field, name, 3, { values, values + 3 });
}
} // anonymous namespace

void WritePixels(ScatteringImage& image, vtkPointData* points)
{
  const int wavelengths = image.NumberOfWavelengths;
  Give<vtkFloatArray>(points, "Radiance", wavelengths, image.Radiance);
  Give<vtkFloatArray>(points, "InScattering", wavelengths, image.InScattering);
  Give<vtkFloatArray>(points, "SurfaceRadiance", wavelengths, image.SurfaceRadiance);
  Give<vtkFloatArray>(points, "Transmittance", wavelengths, image.Transmittance);
  Give<vtkFloatArray>(points, "Depth", 1, image.Depth);
  Give<vtkFloatArray>(points, "RelativeError", 1, image.RelativeError);
  Give<vtkFloatArray>(points, "SurfaceRelativeError", 1, image.SurfaceRelativeError);
  Give<vtkIntArray>(points, "SampleCount", 1, image.SampleCount);
  if (!image.MultipleScattering.empty())
  {
    Give<vtkFloatArray>(points, "MultipleScattering", wavelengths, image.MultipleScattering);
    Give<vtkFloatArray>(points, "IndirectSurface", wavelengths, image.IndirectSurface);
    Give<vtkFloatArray>(points, "PhotonError", 1, image.PhotonError);
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

bool WriteRgb(vtkImageData* image, const ToneMapping& mapping, const Monitor& monitor, vtkImageData* output)
{
  const FloatValues radiance(image->GetPointData()->GetArray("Radiance"));
  const vtkIdType pixels = image->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("RGB");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(pixels);
  if (!ToneMap(radiance.Data(), pixels, mapping, monitor, rgb->GetPointer(0)))
  {
    return false;
  }
  // SetScalars() would remove an array that is active.
  output->GetPointData()->AddArray(rgb);
  output->GetPointData()->SetActiveScalars("RGB");
  AddDoubleArray(output->GetFieldData(), "Exposure", 1, { mapping.Exposure });
  return true;
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
