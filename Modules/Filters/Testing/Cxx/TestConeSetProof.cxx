// SPDX-License-Identifier: BSD-3-Clause
// vtkConeSetFilter proves its cones: held against a check of its own, and what a certificate is worth elsewhere.
#include "Messages.h"
#include "TestPolyData.h"
#include "TracedBoard.h"
#include "scConeData.h"
#include "scConeProofCheck.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "vtkConeSetFilter.h"

#include "vtkFieldData.h"

#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{

/// The check that shares nothing with the filter, on what a reader of the cone set gets.
class ProvedSet
{
public:
  ProvedSet(vtkPolyData* coneSet, vtkPolyData* mesh, vtkAreaLightSource* light)
  {
    std::string error;
    light->Update();
    EXPECT_TRUE(shadowcones::ReadConeSet(coneSet, this->Cones, error)) << error;
    EXPECT_TRUE(shadowcones::ReadTriangles(mesh, this->Mesh, error)) << error;
    this->Lights.resize(1);
    EXPECT_TRUE(shadowcones::ReadLight(light->GetOutput(), this->Lights[0], error)) << error;
    this->Data = coneSet->GetFieldData();
  }
  bool Checked() const
  {
    shadowcones::ConeProofCheck check;
    shadowcones::CheckConeProof(this->Mesh.View(), this->Lights[0], this->Cones, {}, {}, check);
    return check.Proved;
  }
  /// Why the certificate does not stand; empty where it does.
  std::string Objection() const
  {
    std::string why;
    shadowcones::ReadConeCertificate(this->Data, this->Cones, this->Mesh.View(), this->Lights, why);
    return why;
  }

  std::vector<shadowcones::Cone> Cones;
  shadowcones::TriangleMesh Mesh;
  std::vector<shadowcones::Light> Lights;
  vtkFieldData* Data = nullptr;
};

/// A board of 1.6 x 1.6 and a small one beside it, which the photons hardly meet.
vtkSmartPointer<vtkPolyData> TwoBoards()
{
  return MeshBuilder()
    .AddBox(0.0, 0.0, 1.0, 0.8, 0.8, 0.02, 4)
    .AddBox(1.5, 0.0, 1.0, 0.01, 0.01, 0.01, 5)
    .AddSquare(0.0, 3.0, -1)
    .Build();
}

} // namespace

TEST(ConeSetProof, EveryProvableTuningIsProved)
{
  const auto mesh = TwoBoards();
  const auto light = LampAbove(3.0);
  for (const int tuning : { vtkConeSetFilter::Automatic, vtkConeSetFilter::Manual })
  {
    vtkNew<vtkConeSetFilter> filter;
    EXPECT_EQ(filter->GetTuning(), vtkConeSetFilter::Automatic);
    filter->SetTuning(tuning);
    filter->SetInputData(Board().Vectors());
    filter->SetMeshData(mesh);
    Messages messages(filter);
    filter->Update();
    EXPECT_EQ(messages.Errors + messages.Warnings, "");
    const ProvedSet set(filter->GetOutput(), mesh, light);
    EXPECT_EQ(FieldValue(filter->GetOutput(), "Certified"), 1.0);
    EXPECT_EQ(FieldValue(filter->GetOutput(), "NumberOfOccludersWithoutCone"), 0.0);
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("CertifiedBounds")->GetComponent(0, 5), HUGE_VAL);
    EXPECT_TRUE(set.Checked()) << tuning;
    EXPECT_EQ(set.Objection(), "");
    EXPECT_EQ(FieldValue(filter->GetOutput(), "NumberOfDiscarded"), 0.0);
    // Without the proof the small board, which no photon met, has no cone.
    filter->CertifyOff();
    filter->Update();
    const ProvedSet fitted(filter->GetOutput(), mesh, light);
    EXPECT_EQ(FieldValue(filter->GetOutput(), "Certified"), 0.0);
    EXPECT_FALSE(fitted.Checked());
    EXPECT_SAYS(fitted.Objection(), "says nothing of a proof");
  }
}

TEST(ConeSetProof, CertificateIsOfTheseConesCastersAndLights)
{
  const auto mesh = TwoBoards();
  const auto light = LampAbove(3.0);
  vtkNew<vtkConeSetFilter> filter;
  filter->SetInputData(Board().Vectors());
  filter->SetMeshData(mesh);
  filter->Update();
  vtkNew<vtkPolyData> scaled;
  scaled->DeepCopy(filter->GetOutput());
  scaled->GetPointData()->GetArray("BaseRadius")->SetComponent(0, 0, 0.1);
  EXPECT_SAYS(ProvedSet(scaled, mesh, light).Objection(), "are not those");
  EXPECT_SAYS(ProvedSet(filter->GetOutput(), mesh, LampAbove(3.1)).Objection(), "are not those");
  const auto other = MeshBuilder().AddBox(0.0, 0.0, 1.0, 0.8, 0.8, 0.02, 4).Build();
  EXPECT_SAYS(ProvedSet(filter->GetOutput(), other, light).Objection(), "are not those");
  EXPECT_EQ(ProvedSet(filter->GetOutput(), mesh, light).Objection(), "");
}

TEST(ConeSetProof, NeedsTheLightAndLeavesPreviewAlone)
{
  const auto mesh = TwoBoards();
  const auto light = LampAbove(3.0);
  const auto vectors = Board().Vectors();
  vtkNew<vtkFieldData> nothing;
  vectors->SetFieldData(nothing);
  vtkNew<vtkConeSetFilter> filter;
  filter->SetInputData(vectors);
  filter->SetPhotonPathData(Board().Paths());
  filter->SetMeshData(mesh);
  Messages messages(filter);
  filter->Update();
  EXPECT_SAYS(messages.Warnings, "Connect the light with SetLightConnection");
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Certified"), 0.0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetLightConnection(light->GetOutputPort());
  filter->AddLightConnection(LampAbove(4.0)->GetOutputPort());
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Certified"), 1.0);
  EXPECT_TRUE(ProvedSet(filter->GetOutput(), mesh, light).Checked());
  EXPECT_TRUE(ProvedSet(filter->GetOutput(), mesh, LampAbove(4.0)).Checked());
  EXPECT_FALSE(ProvedSet(filter->GetOutput(), mesh, LampAbove(3.0, 0.9)).Checked());
  filter->SetTuningToSoft();
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Certified"), 0.0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("ConeOrigin")->GetRange()[1], 0.0);
}
