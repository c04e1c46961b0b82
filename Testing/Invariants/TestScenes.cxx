// SPDX-License-Identifier: BSD-3-Clause
// The whole chain on awkward scenes: far away, tiny, empty, a camera inside, and meshes that nobody here made.
#include "Cases.h"
#include "FilterChain.h"
#include "RealMeshes.h"
#include "TestPolyData.h"

#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkPenumbraWidth.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowFootprintWriter.h"

#include "vtkCamera.h"
#include "vtkCleanPolyData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOBJReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace invariants;
using namespace shadowcones::testsupport;

namespace
{

/// The mesh with its points in double precision, scaled and moved along all axes.
vtkSmartPointer<vtkPolyData> Placed(vtkPolyData* mesh, double scale, double offset)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points->InsertNextPoint(scale * p[0] + offset, scale * p[1] + offset, scale * p[2] + offset);
  }
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->ShallowCopy(mesh);
  placed->SetPoints(points);
  return placed;
}

/// The importer splits meshes at creases: what belongs together is joined again.
vtkSmartPointer<vtkPolyData> Read3DS(const std::string& path)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(Import3DS(path));
  clean->Update();
  return clean->GetOutput();
}

/// A disc over the mesh's bounds, as wide as a fifth of them.
vtkSmartPointer<vtkPolyData> LampOver(vtkPolyData* mesh)
{
  const double* b = mesh->GetBounds();
  const double size = mesh->GetLength();
  vtkNew<vtkAreaLightSource> light;
  light->SetCenter(0.5 * (b[0] + b[1]), b[3] + 0.6 * size, 0.5 * (b[4] + b[5]));
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.1 * size);
  light->Update();
  return light->GetOutput();
}

/// The chain works on the mesh, and most of its vectors find a cone; some of very many pieces may go without.
void ExpectCones(vtkPolyData* mesh)
{
  FilterChain chain(mesh, LampOver(mesh), 5000);
  chain.Update();
  EXPECT_EQ(chain.Labels->GetOutput()->GetFieldData()->GetArray("NumberOfOccluders")->GetComponent(0, 0) > 1000.0,
    !chain.Said.empty())
    << chain.Said;
  vtkPolyData* vectors = chain.Vectors->GetOutput();
  EXPECT_GE(vectors->GetNumberOfPoints(), 5000);
  vtkPolyData* cones = chain.Cones->GetOutput();
  EXPECT_GT(cones->GetNumberOfPoints(), 20);
  EXPECT_LT(FieldValue(cones, "DiscardedFraction"), 0.9);
  // Vectors lie in the mesh's bounds and point away from the light, normals too: all lamps shine from above.
  const double* b = mesh->GetBounds();
  const double margin = 1e-3 * mesh->GetLength();
  for (vtkIdType i = 0; i < vectors->GetNumberOfPoints(); ++i)
  {
    double p[3];
    vectors->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_GE(p[axis], b[2 * axis] - margin);
      ASSERT_LE(p[axis], b[2 * axis + 1] + margin);
    }
    double d[3];
    double n[3];
    vectors->GetPointData()->GetArray("Direction")->GetTuple(i, d);
    vectors->GetPointData()->GetArray("Normal")->GetTuple(i, n);
    ASSERT_LT(d[1], 0.0);
    ASSERT_GE(d[0] * n[0] + d[1] * n[1] + d[2] * n[2], 0.0) << i;
  }
}

} // namespace

TEST(Scenes, FarAwayAndTinyGiveTheSameCones)
{
  const auto chair = ReadData("chair.vtp");
  FilterChain reference(chair, RoomLamp(), 3000);
  reference.Update();
  const vtkIdType count = reference.Cones->GetOutput()->GetNumberOfPoints();
  ASSERT_GT(count, 20);
  struct Place
  {
    double Scale;
    double Offset;
  };
  for (const Place& place : { Place{ 1.0, 1e6 }, Place{ 1e-3, 0.0 }, Place{ 1e-3, 1e3 } })
  {
    FilterChain moved(Placed(chair, place.Scale, place.Offset), RoomLamp(place.Scale, place.Offset), 3000);
    moved.Update();
    EXPECT_EQ(moved.Said, "");
    ASSERT_EQ(moved.Cones->GetOutput()->GetNumberOfPoints(), count) << place.Scale << " " << place.Offset;
    for (vtkIdType i = 0; i < count; ++i)
    {
      double a[3];
      double b[3];
      reference.Cones->GetOutput()->GetPoint(i, a);
      moved.Cones->GetOutput()->GetPoint(i, b);
      for (int c = 0; c < 3; ++c)
      {
        // 1 % of the smallest radii, some 0.05.
        ASSERT_NEAR((b[c] - place.Offset) / place.Scale, a[c], 5e-4) << i;
        ASSERT_NEAR(moved.Cone("Axis", i, c), reference.Cone("Axis", i, c), 1e-2);
      }
      const double radius = reference.Cone("BaseRadius", i);
      ASSERT_NEAR(moved.Cone("BaseRadius", i) / place.Scale, radius, 1e-2 * radius);
      for (const char* angle : { "HalfAngle", "InnerHalfAngle" })
      {
        ASSERT_NEAR(moved.Cone(angle, i), reference.Cone(angle, i), 1e-2 * std::abs(reference.Cone(angle, i)) + 1e-4);
      }
      ASSERT_EQ(moved.Cone("VectorCount", i), reference.Cone("VectorCount", i));
      ASSERT_EQ(moved.Cone("OccluderId", i), reference.Cone("OccluderId", i));
    }
  }
}

TEST(Scenes, FarAwayAndTinyGiveTheSameImage)
{
  const auto chair = ReadData("chair.vtp");
  const auto render = [&](double scale, double offset)
  {
    FilterChain chain(Placed(chair, scale, offset), RoomLamp(scale, offset), 3000);
    chain.Update();
    vtkNew<vtkCamera> camera;
    camera->SetPosition(offset, 2.75 * scale + offset, 12.5 * scale + offset);
    camera->SetFocalPoint(offset, 2.75 * scale + offset, offset);
    camera->SetViewAngle(32.0);
    vtkNew<vtkScatteringImageFilter> image;
    image->SetInputConnection(chain.Labels->GetOutputPort());
    image->SetLightData(RoomLamp(scale, offset));
    image->SetConeSetConnection(chain.Cones->GetOutputPort());
    image->SetCamera(camera);
    image->SetModeToMedium();
    image->SetResolution(24, 24);
    image->SetSigmaS(0.12 / scale);
    image->SetMediumBounds(-2.75 * scale + offset, 2.75 * scale + offset, offset, 5.2 * scale + offset,
      -2.75 * scale + offset, 2.75 * scale + offset);
    image->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(image->GetOutput());
    return copy;
  };
  const auto mean = [](vtkImageData* image)
  {
    vtkDataArray* array = image->GetPointData()->GetArray("InScattering");
    double sum = 0.0;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      sum += array->GetComponent(i, 0);
    }
    return sum / static_cast<double>(array->GetNumberOfTuples());
  };
  const double truth = mean(render(1.0, 0.0));
  EXPECT_GT(truth, 0.0);
  EXPECT_NEAR(mean(render(1.0, 1e6)), truth, 1e-2 * truth);
  EXPECT_NEAR(mean(render(1e-3, 0.0)), truth, 1e-2 * truth);
}

TEST(Scenes, AnEmptyMeshIsEmptyAllTheWay)
{
  vtkNew<vtkPolyData> empty;
  FilterChain chain(empty, RoomLamp(), 1000);
  chain.Update();
  EXPECT_EQ(chain.Said, "");
  EXPECT_EQ(chain.Vectors->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(chain.Cones->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkConeSetGeometry> geometry;
  geometry->SetInputConnection(chain.Cones->GetOutputPort());
  Messages messages(geometry);
  geometry->Update();
  EXPECT_EQ(geometry->GetOutput()->GetNumberOfCells(), 0);
  // The image of nothing but medium and light.
  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(chain.Labels->GetOutputPort());
  image->SetLightData(RoomLamp());
  image->SetConeSetConnection(chain.Cones->GetOutputPort());
  image->SetModeToMedium();
  image->SetResolution(8, 8);
  image->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  Messages imageMessages(image);
  image->Update();
  EXPECT_EQ(messages.Errors + imageMessages.Errors, "");
  EXPECT_GT(image->GetOutput()->GetPointData()->GetArray("InScattering")->GetRange()[1], 0.0);
}

TEST(Scenes, ACameraInsideAnOccluderSeesItsInside)
{
  const auto box = MeshBuilder().AddBox(0.0, 2.0, 0.0, 0.5, 0.5, 0.5, 0).Build();
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.1, 2.0, 0.2);
  camera->SetFocalPoint(0.0, 2.1, -3.0);
  for (const int mode :
    { vtkScatteringImageFilter::BruteForce, vtkScatteringImageFilter::Medium, vtkScatteringImageFilter::Fast })
  {
    FilterChain chain(box, RoomLamp(), 1000);
    chain.Update();
    vtkNew<vtkScatteringImageFilter> image;
    image->SetInputConnection(chain.Labels->GetOutputPort());
    image->SetLightData(RoomLamp());
    image->SetConeSetConnection(chain.Cones->GetOutputPort());
    image->SetCamera(camera);
    image->SetMode(mode);
    image->SetLightVisible(false);
    image->SetResolution(12, 12);
    image->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
    Messages messages(image);
    image->Update();
    EXPECT_EQ(messages.Errors, "");
    vtkPointData* data = image->GetOutput()->GetPointData();
    const double* depth = data->GetArray("Depth")->GetRange();
    EXPECT_GT(depth[0], 0.1);
    EXPECT_LT(depth[1], 1.5); // a wall of the box in every pixel
    for (const char* name : { "Radiance", "InScattering", "SurfaceRadiance" })
    {
      const double* range = data->GetArray(name)->GetRange(0);
      EXPECT_TRUE(std::isfinite(range[0]) && std::isfinite(range[1])) << name;
      if (mode == vtkScatteringImageFilter::BruteForce)
      {
        EXPECT_EQ(range[1], 0.0) << name; // no light gets in
      }
    }
  }
}

TEST(Scenes, ALightInsideTheMeshsBoundsWorks)
{
  // Between the slats of the chair.
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToSphere();
  light->SetCenter(0.0, 0.7, 0.0);
  light->SetRadius(0.1);
  light->Update();
  FilterChain chain(ReadData("chair.vtp"), light->GetOutput(), 3000);
  chain.Update();
  EXPECT_EQ(chain.Said, "");
  EXPECT_GE(chain.Vectors->GetOutput()->GetNumberOfPoints(), 3000);
}

TEST(Scenes, ASunWorks)
{
  vtkNew<vtkAreaLightSource> sun;
  sun->SetShapeToSun();
  sun->SetNormal(0.3, -1.0, 0.2);
  sun->Update();
  FilterChain chain(ReadData("chair.vtp"), sun->GetOutput(), 3000);
  chain.Update();
  EXPECT_EQ(chain.Said, "");
  const double* angles = chain.Cones->GetOutput()->GetPointData()->GetArray("HalfAngle")->GetRange();
  const double half = 0.5 * 0.533 * std::acos(-1.0) / 180.0;
  EXPECT_LT(angles[1], half * 1.5); // around their mean
  EXPECT_GT(angles[1], half * 0.8);
  // The umbra of a disc ends where the far rim of the sun, seen from the cone's axis, no longer hides behind it.
  double way[3] = { 0.3, -1.0, 0.2 };
  vtkMath::Normalize(way);
  for (vtkIdType cone = 0; cone < chain.Cones->GetOutput()->GetNumberOfPoints(); ++cone)
  {
    const double axis[3] = { chain.Cone("Axis", cone, 0), chain.Cone("Axis", cone, 1), chain.Cone("Axis", cone, 2) };
    double across[3];
    vtkMath::Cross(way, axis, across);
    const double turn = std::asin(vtkMath::Norm(across));
    EXPECT_NEAR(chain.Cone("InnerHalfAngle", cone), -(half + turn), 2e-6) << "cone " << cone;
  }
}

TEST(Scenes, EveryMeshOfDataHasCones)
{
  for (const char* name : { "chair.vtp", "tree.vtp", "blob.vtp" })
  {
    SCOPED_TRACE(name);
    ExpectCones(ReadData(name));
  }
}

TEST(RealMeshes, TheBunnyIsClosedAndHasCones)
{
  const std::string path = Model("bunny.obj");
  if (path.empty())
  {
    GTEST_SKIP() << "package glmark2-data is not installed";
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ExpectCones(reader->GetOutput());
}

TEST(RealMeshes, TheHorseHasConesDespiteItsNonManifoldEdges)
{
  const std::string path = Model("horse.3ds");
  if (path.empty())
  {
    GTEST_SKIP() << "package glmark2-data is not installed";
  }
  ExpectCones(Read3DS(path));
}

TEST(RealMeshes, TheCatHasConesThoughItIsOpen)
{
  const std::string path = Model("cat.3ds");
  if (path.empty())
  {
    GTEST_SKIP() << "package glmark2-data is not installed";
  }
  ExpectCones(Read3DS(path));
}

TEST(Scenes, CellsOfPointsThatAreNotThere)
{
  // Wherever cells come in, and not in meshes alone.
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 99 });
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ -3 });
  const auto dataOf = [](void (vtkPolyData::*set)(vtkCellArray*), vtkCellArray* broken)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.1, 0.0);
    points->InsertNextPoint(1.0, 0.1, 0.0);
    data->SetPoints(points);
    (data->*set)(broken);
    return data;
  };
  const auto lamp = RoomLamp();
  const auto chair = LabelledMesh(ReadData("chair.vtp"));
  for (const auto& where : { dataOf(&vtkPolyData::SetLines, cells), dataOf(&vtkPolyData::SetPolys, cells) })
  {
    vtkNew<vtkPenumbraWidth> widths;
    widths->SetInputData(where);
    widths->SetLightData(lamp);
    widths->SetMeshData(chair);
    EXPECT_SAYS(ErrorsOf(widths), "Cell 0 uses point 99, but there are 2 points.");
    vtkNew<vtkConeSetProbe> probe;
    probe->SetAssociationToCells();
    probe->SetInputData(where);
    probe->SetLightData(lamp);
    probe->SetMeshData(chair);
    EXPECT_SAYS(ErrorsOf(probe), "Cell 0 uses point 99");
  }
  vtkNew<vtkShadowFootprintWriter> writer;
  writer->SetInputData(dataOf(&vtkPolyData::SetLines, cells));
  writer->SetFileName("nothing.geojson");
  EXPECT_SAYS(ErrorsOf(writer), "Cell 0 uses point 99");
  vtkNew<vtkConeSetProbe> dark;
  dark->SetInputData(chair);
  dark->SetMeshData(chair);
  dark->SetLightData(dataOf(&vtkPolyData::SetVerts, vertex));
  EXPECT_SAYS(ErrorsOf(dark), "The light: Cell 0 uses point -3, but there are 2 points.");
}

TEST(Scenes, NumbersBeyondWhatOutputsHold)
{
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(Placed(ReadData("chair.vtp"), 1e19, 0.0));
  EXPECT_SAYS(ErrorsOf(labels), "has a coordinate that is beyond 1e18.");
  const auto chair = LabelledMesh(ReadData("chair.vtp"));
  vtkNew<vtkAreaLightSource> lamp;
  lamp->SetCenter(0.0, 5.0, 0.0);
  lamp->SetNormal(0.0, -1.0, 0.0);
  lamp->SetRadiance(1e35);
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(chair);
  probe->SetMeshData(chair);
  probe->SetLightConnection(lamp->GetOutputPort());
  probe->ComputeFluenceRateOn();
  EXPECT_SAYS(ErrorsOf(probe), "\"LightSpectrum\" holds 1e+35, which is beyond 1e30.");
  // Lengths and radiance are within their limits, and their product is not.
  lamp->SetRadiance(1e20);
  lamp->SetRadius(1e17);
  lamp->SetCenter(0.0, 5e17, 0.0);
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputData(LabelledMesh(Placed(ReadData("chair.vtp"), 1e17, 0.0)));
  vectors->SetLightConnection(lamp->GetOutputPort());
  EXPECT_SAYS(ErrorsOf(vectors), "a number of \"Power\" is beyond 3.4e38");
}
