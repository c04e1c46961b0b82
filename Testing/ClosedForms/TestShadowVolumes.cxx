// SPDX-License-Identifier: BSD-3-Clause
// Closed forms 1 and 2 as solids: volumes of penumbra and umbra behind a disc and a sphere, through the chain.
#include "ClosedForms.h"
#include "TestPolyData.h"

#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"

#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double PenumbraTolerance = 0.05;
constexpr double UmbraTolerance = 0.10;

double Frustum(double height, double r0, double r1)
{
  return closedforms::Pi * height / 3.0 * (r0 * r0 + r0 * r1 + r1 * r1);
}

struct Volumes
{
  double Penumbra = 0.0;
  double Umbra = 0.0;
};

double VolumeOf(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  mass->Update();
  return mass->GetVolume();
}

/// Volumes from z0 to z1, of cones that are bounds: 20,000 vectors, few and large cones.
Volumes MeasuredVolumes(const TestMesh& mesh, vtkAreaLightSource* light, double z0, double z1)
{
  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputData(ToPolyData(mesh));
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetToPaper();
  vectors->SetInputConnection(occluders->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetTargetNumberOfVectors(20000);
  vtkNew<vtkConeSetFilter> cones;
  cones->SetToPaper();
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetNumberOfNeighbors(10000);
  cones->SetPointsPerRing(100);
  cones->SetVarianceThreshold(2.0);
  cones->SetPlanarityThreshold(0.0);
  cones->SetExpansionToLightGeometry();
  cones->SetOverlap(true);
  vtkNew<vtkShadowVolume> solids;
  solids->SetInputConnection(cones->GetOutputPort());
  solids->SetBounds(-50.0, 50.0, -50.0, 50.0, z0, z1);
  solids->SetResolution(48);
  solids->SetUmbraToBaseDiscs();
  solids->Update();
  return { VolumeOf(solids->GetOutput(0)), VolumeOf(solids->GetOutput(1)) };
}
} // namespace

TEST(ShadowVolumes, DiscBehindDisc)
{
  const double L = 2.0;
  const double height = 1.5;
  for (const auto& radii : { std::array<double, 2>{ 0.5, 0.3 }, { 0.2, 0.5 } })
  {
    const double R = radii[0];
    const double r = radii[1];
    TestMesh mesh;
    mesh.AddDisc({ 0.0, 0.0, L }, r);
    vtkNew<vtkAreaLightSource> light;
    light->SetRadius(R);
    const Volumes volumes = MeasuredVolumes(mesh, light, L, L + height);
    const double penumbra = Frustum(height, r, closedforms::DiscPenumbraRadius(R, r, L, L + height));
    EXPECT_NEAR(volumes.Penumbra / penumbra, 1.0, PenumbraTolerance) << R;
    const double tip = R > r ? std::min(height, closedforms::DiscUmbraLength(R, r, L)) : height;
    const double umbra = Frustum(tip, r, closedforms::DiscUmbraRadius(R, r, L, L + tip));
    EXPECT_NEAR(volumes.Umbra / umbra, 1.0, UmbraTolerance) << R;
  }
}

TEST(ShadowVolumes, SphereBehindSphere)
{
  const double R = 0.3;
  const double r = 0.5;
  const double D = 5.0;
  const double z0 = D + r;
  const double z1 = z0 + 2.0;
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, D }, r);
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToSphere();
  light->SetRadius(R);
  const Volumes volumes = MeasuredVolumes(mesh, light, z0, z1);
  const double outer = std::tan(closedforms::SpherePenumbraHalfAngle(R, r, D));
  const double outerTip = R * D / (R + r); // of the cone around both spheres, seen from the light
  EXPECT_NEAR(
    volumes.Penumbra / Frustum(z1 - z0, (z0 - outerTip) * outer, (z1 - outerTip) * outer), 1.0, PenumbraTolerance);
  const double inner = -std::tan(closedforms::SphereUmbraHalfAngle(R, r, D));
  const double innerTip = -R * D / (r - R);
  EXPECT_NEAR(volumes.Umbra / Frustum(z1 - z0, (z0 - innerTip) * inner, (z1 - innerTip) * inner), 1.0, UmbraTolerance);
}
