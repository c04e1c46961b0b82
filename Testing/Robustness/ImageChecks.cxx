// SPDX-License-Identifier: BSD-3-Clause
// Pictures of an awkward mesh in every mode: depths and light against the truth, tones, and the page.
#include "FilterChecks.h"

#include "Asking.h"
#include "SceneParts.h"
#include "TruthOfImage.h"

#include "vtkConeSetProbe.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowPage.h"
#include "vtkToneMapRadiance.h"
#include "vtkVisibilityVolume.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <string>

namespace robustness
{

using namespace shadowcones;

namespace
{

vtkSmartPointer<vtkScatteringImageFilter> ImageOf(const Scene& scene, int mode)
{
  auto filter = Made<vtkScatteringImageFilter>::New();
  const AwkwardMesh& mesh = scene.Mesh;
  filter->SetMode(mode);
  filter->SetResolution(truthWidth, truthHeight);
  double bounds[6];
  PlaceBounds(mesh, bounds);
  filter->SetMediumBounds(bounds);
  filter->SetSigmaS(truthSigmaS / mesh.Scale);
  filter->SetNumberOfSteps(128);
  filter->SetNumberOfLightSamples(32);
  filter->SetSoftDimensions(17, 17, 17);
  vtkNew<vtkCamera> camera;
  const Vector3 eye = mesh.Place(truthEye);
  const Vector3 focus = mesh.Place(truthFocus);
  camera->SetPosition(eye.X, eye.Y, eye.Z);
  camera->SetFocalPoint(focus.X, focus.Y, focus.Z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(truthViewAngle);
  filter->SetCamera(camera);
  filter->SetInputData(scene.Labelled);
  filter->SetLightData(scene.Lamp);
  if (mode != vtkScatteringImageFilter::BruteForce)
  {
    filter->SetConeSetData(scene.Cones());
  }
  if (mode == vtkScatteringImageFilter::Volume)
  {
    vtkNew<vtkVisibilityVolume> volume;
    volume->SetDimensions(9, 9, 9);
    volume->SetBounds(bounds);
    volume->SetLightData(scene.Lamp);
    volume->SetMeshData(scene.Labelled);
    testsupport::Messages messages(volume);
    volume->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(volume->GetOutput());
    filter->SetVisibilityVolumeData(copy);
  }
  return filter;
}

} // namespace

Finding AskImage(const Scene& scene, int mode)
{
  const auto filter = ImageOf(scene, mode);
  Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkPointData* data = filter->GetOutput()->GetPointData();
  const bool exact = mode == vtkScatteringImageFilter::BruteForce || mode == vtkScatteringImageFilter::Guided ||
    mode == vtkScatteringImageFilter::Medium;
  int compared = 0;
  for (int pixel = 0; pixel < truthWidth * truthHeight; ++pixel)
  {
    const int i = pixel % truthWidth;
    const int j = pixel / truthWidth;
    const double nearest = scene.Rays.Nearest(truthEye, PixelDirection(i, j));
    const double depth = ValueOf(data, "Depth", pixel);
    const bool agrees =
      std::isfinite(nearest) ? std::fabs(depth / scene.Mesh.Scale - nearest) < 1e-4 * nearest : depth == -1.0;
    if (!agrees)
    {
      return WrongOf("pixel ", i, ", ", j, " is ", depth, " deep in place of ", nearest * scene.Mesh.Scale);
    }
    if (!exact || pixel % 17 != 5 || scene.Mesh.Corners.size() > 100000)
    {
      continue;
    }
    ++compared;
    const double truth = TrueInScattering(scene.Rays, i, j, lampHeight, lampRadius);
    const double value = ValueOf(data, "InScattering", pixel);
    if (std::fabs(value - truth) > 0.06 * truth + 2e-4)
    {
      return WrongOf("pixel ", i, ", ", j, " scatters ", value, " in place of ", truth);
    }
  }
  return { compared > 0 ? Verdict::Right : Verdict::Sound, {} };
}

Finding AskToneMap(const Scene& scene)
{
  const auto image = ImageOf(scene, vtkScatteringImageFilter::Guided);
  Finding asked = Ask(image, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(image->GetOutput());
  copy->GetPointData()->RemoveArray("RGB");
  const auto filter = Made<vtkToneMapRadiance>::New();
  filter->SetInputData(copy);
  asked = Ask(filter, scene);
  vtkDataArray* now = filter->GetOutput()->GetPointData()->GetArray("RGB");
  vtkDataArray* then = image->GetOutput()->GetPointData()->GetArray("RGB");
  for (vtkIdType k = 0; asked.Kind == Verdict::Sound && k < then->GetNumberOfTuples(); ++k)
  {
    if (!now || now->GetComponent(k, 1) != then->GetComponent(k, 1))
    {
      return Wrong("other colours than those of the image");
    }
    asked.Kind = k + 1 == then->GetNumberOfTuples() ? Verdict::Right : asked.Kind;
  }
  return asked;
}

Finding AskPage(const Scene& scene)
{
  vtkNew<vtkShadowPage> page;
  if (!scene.Mesh.Refusal.empty())
  {
    return {};
  }
  if (scene.Labelled->GetNumberOfPoints() > 0)
  {
    page->AddMesh(scene.Labelled, "mesh");
  }
  if (scene.Cones()->GetNumberOfPoints() > 0)
  {
    page->AddCones(scene.Cones());
  }
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(scene.Places);
  probe->SetLightData(scene.Lamp);
  probe->SetMeshData(scene.Labelled);
  const Finding asked = Ask(probe, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  page->AddAnswer(vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0)), "Visibility");
  return page->GetPage().find("Visibility") == std::string::npos ? Wrong("a page without the answer") : Finding();
}

} // namespace robustness
