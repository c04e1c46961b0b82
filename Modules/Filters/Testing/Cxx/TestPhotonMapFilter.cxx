// SPDX-License-Identifier: BSD-3-Clause
// vtkPhotonMapFilter: its arrays, its parameters, and a message for each fault.
#include "Messages.h"
#include "TestPolyData.h"
#include "vtkPhotonMapFilter.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"

#include <sstream>

using namespace shadowcones::testsupport;

namespace
{

/// A lamp over a box and a floor, in a haze.
vtkSmartPointer<vtkPhotonMapFilter> FilterOf(vtkAreaLightSource* light)
{
  auto filter = vtkSmartPointer<vtkPhotonMapFilter>::New();
  filter->SetInputData(MeshBuilder().AddBox(0.0, 0.0, 1.0, 0.5, 0.5, 0.1, 0).AddSquare(0.0, 3.0, -1).Build());
  filter->SetLightConnection(light->GetOutputPort());
  filter->SetNumberOfPhotons(2000);
  filter->SetSigmaS(0.5);
  return filter;
}

vtkIdType PhotonsIn(vtkPhotonMapFilter* filter)
{
  return filter->GetOutput(0)->GetNumberOfPoints() + filter->GetOutput(1)->GetNumberOfPoints();
}

/// What a filter says where @p change was set; there is no photon then.
template <typename Change>
void ExpectError(const std::string& part, Change change)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  change(filter.GetPointer());
  EXPECT_SAYS(ErrorsOf(filter), part);
  EXPECT_EQ(PhotonsIn(filter), 0);
}
} // namespace

TEST(PhotonMapFilter, GivesTheDocumentedArrays)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  filter->SetSigmaASpectrum(2, 0.3);
  EXPECT_EQ(ErrorsOf(filter), "");
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* photons = filter->GetOutput(port);
    const vtkIdType count = photons->GetNumberOfPoints();
    ASSERT_GT(count, 200) << port;
    EXPECT_EQ(photons->GetNumberOfVerts(), count);
    EXPECT_EQ(photons->GetPoints()->GetDataType(), VTK_DOUBLE);
    vtkPointData* data = photons->GetPointData();
    ArrayOf(data, "Direction", VTK_FLOAT, 3);
    ArrayOf(data, "Power", VTK_FLOAT, 7);
    vtkDataArray* bounces = ArrayOf(data, "Bounces", VTK_INT, 1);
    EXPECT_GE(bounces->GetRange()[0], 1.0);
    EXPECT_EQ(data->HasArray("Normal"), port == 0);
    EXPECT_EQ(FieldValue(photons, "PhotonMap"), port);
    EXPECT_EQ(FieldValue(photons, "NumberOfPhotons"), 2000);
    ArrayOf(photons->GetFieldData(), "SigmaA", VTK_DOUBLE, 7);
    ArrayOf(photons->GetFieldData(), "MediumBounds", VTK_DOUBLE, 6);
    const double rest = FieldValue(photons, "PowerAbsorbedBySurfaces") + FieldValue(photons, "PowerAbsorbedByMedium") +
      FieldValue(photons, "EscapedPower") + FieldValue(photons, "CutOffPower");
    EXPECT_NEAR(rest / FieldValue(photons, "EmittedPower"), 1.0, 0.05);
  }
}

TEST(PhotonMapFilter, StraightLightIsKeptApart)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  filter->SetMaximumBounces(0);
  EXPECT_EQ(WarningsOf(filter), "");
  EXPECT_EQ(PhotonsIn(filter), 0);
  filter->StoreDirectOn();
  filter->Update();
  EXPECT_GT(PhotonsIn(filter), 1000);
  EXPECT_EQ(filter->GetOutput(1)->GetPointData()->GetArray("Bounces")->GetRange()[1], 0.0);
}

TEST(PhotonMapFilter, EmptyInputsGiveEmptyMaps)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  filter->SetNumberOfPhotons(0);
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(PhotonsIn(filter), 0);
  EXPECT_TRUE(filter->GetOutput(0)->GetPointData()->HasArray("Power"));

  // Without a mesh there is the medium alone.
  filter->SetNumberOfPhotons(2000);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->SetMediumBounds(-1.0, 1.0, -1.0, 1.0, 0.0, 2.0);
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_GT(filter->GetOutput(1)->GetNumberOfPoints(), 100);
}

TEST(PhotonMapFilter, ADensityIsWhereThePhotonsAre)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  vtkNew<vtkImageData> density;
  density->SetDimensions(2, 2, 3);
  density->SetOrigin(-2.0, -2.0, 1.5);
  density->SetSpacing(4.0, 4.0, 0.5);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  for (int i = 0; i < 12; ++i)
  {
    values->InsertNextValue(i < 8 ? 0.0f : 3.0f);
  }
  density->GetPointData()->AddArray(values);
  filter->SetDensityData(density);
  EXPECT_EQ(ErrorsOf(filter), "");
  double bounds[6];
  filter->GetOutput(1)->GetBounds(bounds);
  ASSERT_GT(filter->GetOutput(1)->GetNumberOfPoints(), 50);
  EXPECT_GE(bounds[4], 2.0);
  EXPECT_LE(bounds[5], 2.5);
  values->SetValue(3, -1.0f);
  density->Modified();
  EXPECT_SAYS(ErrorsOf(filter), "ensity");
}

TEST(PhotonMapFilter, SaysWhatIsWrong)
{
  ExpectError("No light on input port 1", [](vtkPhotonMapFilter* f) { f->RemoveAllLights(); });
  ExpectError("NumberOfPhotons is -1", [](vtkPhotonMapFilter* f) { f->SetNumberOfPhotons(-1); });
  ExpectError("MaximumBounces is -2", [](vtkPhotonMapFilter* f) { f->SetMaximumBounces(-2); });
  ExpectError("MaximumStoredPhotons is 0", [](vtkPhotonMapFilter* f) { f->SetMaximumStoredPhotons(0); });
  ExpectError("Reflectance is 1.5", [](vtkPhotonMapFilter* f) { f->SetReflectance(1.5); });
  ExpectError("PhaseFunction is 9", [](vtkPhotonMapFilter* f) { f->SetPhaseFunction(9); });
  ExpectError("PhaseLobes are 2", [](vtkPhotonMapFilter* f) { f->SetPhaseLobes(2.0, 0.0, 0.0); });
  ExpectError("PhaseAsymmetry is 1", [](vtkPhotonMapFilter* f) { f->SetPhaseAsymmetry(1.0); });
  ExpectError("SigmaS is -1", [](vtkPhotonMapFilter* f) { f->SetSigmaS(-1.0); });
  ExpectError("SigmaA", [](vtkPhotonMapFilter* f) { f->SetSigmaASpectrum(7, 1.0); });
  ExpectError("MediumBounds", [](vtkPhotonMapFilter* f) { f->SetMediumBounds(1.0, 0.0, 0.0, 1.0, 0.0, 1.0); });
  ExpectError(
    "raise MaximumStoredPhotons", [](vtkPhotonMapFilter* f) { f->SetMaximumStoredPhotons(20); });
}

TEST(PhotonMapFilter, WarnsOfLightThatIsMissing)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(light);
  filter->SetMaximumBounces(1);
  EXPECT_SAYS(WarningsOf(filter), "of the light was still on its way after MaximumBounces = 1");
  filter->SetMaximumBounces(1000);
  filter->SetSigmaS(0.0);
  filter->SetReflectance(0.0);
  EXPECT_SAYS(WarningsOf(filter), "None of 2000 photons meets a surface or the medium after a bounce");
}

TEST(PhotonMapFilter, PrintsItsParameters)
{
  vtkNew<vtkPhotonMapFilter> filter;
  std::ostringstream text;
  filter->Print(text);
  EXPECT_SAYS(text.str(), "MaximumBounces: 1000");
  EXPECT_SAYS(text.str(), "PhaseLobes: ");
}
