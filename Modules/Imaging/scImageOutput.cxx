// SPDX-License-Identifier: BSD-3-Clause
#include "scImageOutput.h"

#include "scFieldArrays.h"
#include "scSpectrum.h"

#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace shadowcones
{
namespace
{
/// Linear radiance of every pixel to sRGB bytes.
vtkSmartPointer<vtkUnsignedCharArray> ToneMap(
  const std::vector<float>& radiance, const std::vector<double>& wavelengthsInNm, double exposure)
{
  const auto matrix = SpectrumToLinearSrgb(wavelengthsInNm);
  const auto wavelengths = static_cast<int>(wavelengthsInNm.size());
  const auto pixels = static_cast<vtkIdType>(radiance.size() / static_cast<std::size_t>(wavelengths));
  auto rgb = vtkSmartPointer<vtkUnsignedCharArray>::New();
  rgb->SetName("RGB");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(pixels);
  unsigned char* bytes = rgb->GetPointer(0);
  vtkSMPTools::For(0, pixels,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float* spectrum = radiance.data() + i * wavelengths;
        for (int c = 0; c < 3; ++c)
        {
          double linear = 0.0;
          for (int k = 0; k < wavelengths; ++k)
          {
            linear += matrix[c][k] * spectrum[k];
          }
          bytes[3 * i + c] = EncodeSrgb(exposure * linear);
        }
      }
    });
  return rgb;
}

void AddTriple(vtkFieldData* field, const char* name, const double* values)
{
  AddDoubleArray(field, name, 3, { values, values + 3 });
}
} // anonymous namespace

void WritePixels(
  const ScatteringImage& image, const std::vector<double>& wavelengthsInNm, double exposure, vtkPointData* points)
{
  const int wavelengths = image.NumberOfWavelengths;
  AddFloatArray(points, "Radiance", wavelengths, image.Radiance);
  AddFloatArray(points, "InScattering", wavelengths, image.InScattering);
  AddFloatArray(points, "SurfaceRadiance", wavelengths, image.SurfaceRadiance);
  AddFloatArray(points, "Transmittance", wavelengths, image.Transmittance);
  AddFloatArray(points, "Depth", 1, image.Depth);
  AddFloatArray(points, "RelativeError", 1, image.RelativeError);
  AddIntArray(points, "SampleCount", 1, image.SampleCount);
  points->SetScalars(ToneMap(image.Radiance, wavelengthsInNm, exposure));
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
