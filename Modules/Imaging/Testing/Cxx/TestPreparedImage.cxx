// SPDX-License-Identifier: BSD-3-Clause
// What images and volumes keep from run to run changes no byte, and is built anew where an input has changed.
#include "vtkScatteringImageFilter.h"

#include "ImageTesting.h"
#include "ProvedCones.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkObject.h"
#include "vtkPoints.h"

#include <functional>
#include <vector>

using namespace imagetesting;

/// All that any mode needs, as data objects: a test edits them in place.
class PreparedImage : public ImageTest
{
protected:
  PreparedImage()
  {
    this->ConnectDisc();
    this->Filter->SetInputData(this->Mesh);
    shadowcones::AddIntArray(this->Mesh->GetCellData(), "OccluderId", 1,
      std::vector<int>(static_cast<std::size_t>(this->Mesh->GetNumberOfCells()), 0));
    this->Filter->SetDensityData(this->Density);
    this->Filter->SetRelativeErrorGoal(0.1);
    this->Filter->SetSoftDimensions(9, 9, 9);
    this->Volume->SetDimensions(13, 13, 13);
  }

  /// Of a filter that has nothing of another image.
  vtkSmartPointer<vtkImageData> Unprepared()
  {
    this->Filter->ReleasePreparedScene();
    this->Filter->Modified();
    return this->Image();
  }
  vtkIdType BuildsOf(const std::function<void()>& change)
  {
    const vtkIdType before = this->Filter->GetNumberOfPreparations();
    change();
    this->Filter->Update();
    return this->Filter->GetNumberOfPreparations() - before;
  }

  vtkSmartPointer<vtkPolyData> Mesh = Disc();
  vtkSmartPointer<vtkImageData> Density = Constant("Density", 1.0f);
};

TEST_F(PreparedImage, AnotherCameraBuildsNothingAndChangesNoByte)
{
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    this->Filter->Update();
    const auto first = this->Image();
    const vtkIdType builds = this->BuildsOf(
      [this]
      {
        double* p = this->Camera->GetPosition();
        this->Camera->SetPosition(p[0] + 1e-6, p[1], p[2]);
      });
    EXPECT_EQ(builds, 0) << mode;
    const auto second = this->Image();
    EXPECT_NE(Field(first, "CameraPosition"), Field(second, "CameraPosition"));
    ExpectSameBytes(second, this->Unprepared());
  }
}

TEST_F(PreparedImage, WhatHasChangedIsBuiltAnew)
{
  this->Filter->SetModeToVolume();
  this->Filter->Update();
  EXPECT_EQ(this->BuildsOf([this] { this->Filter->SetSigmaS(0.2); }), 0);
  const auto before = this->Image();
  const std::function<void()> changes[] = {
    [this]
    {
      this->Mesh->GetPoints()->SetPoint(0, 0.0, 1.2, 0.0);
      this->Mesh->GetPoints()->Modified();
    },
    [this]
    {
      vtkDataArray* ids = this->Mesh->GetCellData()->GetArray("OccluderId");
      ids->SetComponent(0, 0, -1.0);
      ids->Modified();
    },
    [this]
    {
      vtkDataArray* values = this->Density->GetPointData()->GetArray("Density");
      values->SetComponent(0, 0, 3.0);
      values->Modified();
    },
    [this] { this->Light->SetCenter(0.3, lampHeight, 0.0); },
    [this] { this->Volume->SetNumberOfLightSamples(8); },
    [this] { this->Filter->SetConeLength(0.7); },
  };
  for (const auto& change : changes)
  {
    EXPECT_GT(this->BuildsOf(change), 0);
    const auto changed = this->Image();
    ExpectSameBytes(changed, this->Unprepared());
  }
  EXPECT_GT(Error(this->Image(), before), 0.01);
}

TEST_F(PreparedImage, IsSharedWhereAScriptHandsItOn)
{
  this->Volume->SetMeshData(this->Mesh);
  this->Volume->Update();
  EXPECT_EQ(this->Volume->GetNumberOfPreparations(), 2); // mesh and search tree
  EXPECT_GT(this->Volume->GetPreparedMemory(), 0);

  this->Filter->SetModeToBruteForce();
  this->Filter->SetConeSetConnection(nullptr);
  this->Filter->SetDensityConnection(nullptr);
  const auto own = this->Image();
  EXPECT_EQ(this->Filter->GetNumberOfPreparations(), 3); // reflectances too
  EXPECT_GE(this->Filter->GetPreparedMemory(), this->Volume->GetPreparedMemory());

  vtkNew<vtkScatteringImageFilter> other;
  other->SetPreparedScene(this->Filter->GetPreparedScene());
  EXPECT_EQ(other->GetPreparedScene(), this->Filter->GetPreparedScene());
  other->SetInputData(this->Mesh);
  other->SetLightConnection(this->Light->GetOutputPort());
  other->SetCamera(this->Camera);
  other->SetResolution(width, height);
  other->SetMediumBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  other->SetModeToBruteForce();
  other->SetNumberOfSteps(10);
  other->SetNumberOfLightSamples(4);
  other->LightVisibleOff();
  ExpectSameBytes(CopyOfOutput(other), own);
  EXPECT_EQ(other->GetNumberOfPreparations(), 0);

  other->ReleasePreparedScene();
  EXPECT_EQ(this->Filter->GetPreparedMemory(), 0);
  Messages said(other);
  other->SetPreparedScene(this->Light);
  EXPECT_SAYS(said.Errors, "is no prepared scene");
}

TEST_F(PreparedImage, NormalsAreReadOnce)
{
  this->Filter->Update();
  const auto values = static_cast<std::size_t>(3 * this->Mesh->GetNumberOfPoints());
  for (const float tilt : { 1.0f, 0.5f })
  {
    std::vector<float> normals(values, 1.0f);
    for (std::size_t k = 0; k < values; k += 3)
    {
      normals[k] = tilt;
    }
    EXPECT_GT(this->BuildsOf([&] { shadowcones::AddFloatArray(this->Mesh->GetPointData(), "Normals", 3, normals); }), 0);
    EXPECT_EQ(this->BuildsOf([this] { this->Camera->Azimuth(1.0); }), 0);
    const auto image = this->Image();
    ExpectSameBytes(image, this->Unprepared());
  }
}

TEST_F(PreparedImage, ACertificateIsCheckedOnceForEachOfItsInputs)
{
  this->Filter->SetModeToGuided();
  const auto cones = ProvedConesOf(this->Mesh, this->Light);
  this->Filter->SetConeSetData(cones);
  const auto isCertified = [this] { return Field(this->Filter->GetOutput(), "Certified") == 1.0; };
  this->Filter->Update();
  EXPECT_TRUE(isCertified());
  EXPECT_EQ(this->BuildsOf([this] { this->Camera->Azimuth(1.0); }), 0);
  EXPECT_TRUE(isCertified());
  EXPECT_EQ(this->BuildsOf(
              [&cones]
              {
                cones->GetPointData()->GetArray("HalfAngle")->SetComponent(0, 0, 0.1);
                cones->Modified();
              }),
    2); // the certificate, and the cones' tree
  EXPECT_FALSE(isCertified());
  EXPECT_EQ(this->BuildsOf([this] { this->Camera->Azimuth(1.0); }), 0);
  EXPECT_FALSE(isCertified()) << "and it is said again";
}

TEST_F(PreparedImage, AVolumeWithOtherSamplesKeepsItsTree)
{
  this->Volume->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0); // looked for in the mesh, which is read for it
  this->Volume->SetMeshData(this->Mesh);
  this->Volume->Update();
  EXPECT_EQ(this->Volume->GetNumberOfPreparations(), 2);
  this->Volume->SetNumberOfLightSamples(8);
  this->Volume->Update();
  EXPECT_EQ(this->Volume->GetNumberOfPreparations(), 2);
  this->Mesh->Modified();
  this->Volume->Update();
  EXPECT_EQ(this->Volume->GetNumberOfPreparations(), 4);
}

TEST_F(PreparedImage, AnotherExposureSendsNoRay)
{
  this->Filter->SetModeToGuided();
  this->Filter->Update();
  const vtkIdType rays = this->Filter->GetNumberOfRaysSent();
  EXPECT_GT(rays, 0);
  EXPECT_EQ(static_cast<double>(rays), Field(this->Filter->GetOutput(), "NumberOfOcclusionRays"));
  this->Filter->AutoExposureOff();
  for (const double exposure : { 0.5, 2.0 })
  {
    this->Filter->SetExposure(exposure);
    this->Filter->Update();
    EXPECT_EQ(Field(this->Filter->GetOutput(), "Exposure"), exposure);
  }
  this->Filter->AutoExposureOn();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfRaysSent(), rays);
  EXPECT_GT(this->Filter->GetPreparedMemory(), 0); // kept for the next camera
  this->Filter->Modified();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfRaysSent(), 2 * rays);
}
