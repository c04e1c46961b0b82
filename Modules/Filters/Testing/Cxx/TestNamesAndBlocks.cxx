// SPDX-License-Identifier: BSD-3-Clause
// Meshes of blocks, names of occluders, fingerprints and hidden cells, from the mesh to the last filter.
#include "Messages.h"
#include "TestPolyData.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "scOccluderNames.h"
#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStructuredGrid.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{

using Names = std::vector<std::string>;

/// A sheet z = 2 over x from @p low to @p high and y in +-2, facing up, without ids.
vtkSmartPointer<vtkPolyData> Wall(double low, double high)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double y : { -2.0, 2.0 })
  {
    points->InsertNextPoint(y < 0.0 ? low : high, y, 2.0);
    points->InsertNextPoint(y < 0.0 ? high : low, y, 2.0);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  auto wall = vtkSmartPointer<vtkPolyData>::New();
  wall->SetPoints(points);
  wall->SetPolys(polys);
  return wall;
}

/// Two walls that each hide half of a lamp above the origin, and together all of it.
vtkSmartPointer<vtkMultiBlockDataSet> Walls()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Wall(-2.0, 0.0));
  blocks->SetBlock(1, Wall(0.0, 2.0));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "west");
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "east");
  return blocks;
}

/// One cone that holds all of the scene: Exact asks everywhere.
vtkSmartPointer<vtkPolyData> ConeAroundAll()
{
  return ConeSetOf({ MakeCone({ 0.0, 0.0, 50.0 }, { 0.0, 0.0, -1.0 }, 50.0, 0.3) });
}

Names NamesIn(vtkDataObject* data)
{
  return shadowcones::ReadOccluderNames(data->GetFieldData());
}

void SetMarks(vtkDataSetAttributes* data, const std::vector<unsigned char>& marks)
{
  shadowcones::AddByteArray(data, vtkDataSetAttributes::GhostArrayName(), marks);
}

/// Everything from the mesh to the last filter.
struct Chain
{
  explicit Chain(vtkDataObject* mesh)
  {
    this->Light = LampAbove(4.0);
    this->Vectors->SetInputDataObject(0, mesh);
    this->Vectors->SetLightConnection(this->Light->GetOutputPort());
    this->Vectors->SetTargetNumberOfVectors(1500);
    this->Cones->SetInputConnection(this->Vectors->GetOutputPort());
    this->Geometry->SetInputConnection(this->Cones->GetOutputPort());
    this->Volume->SetInputConnection(this->Cones->GetOutputPort());
    this->Volume->SetResolution(8);
    this->Probe->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
    this->Probe->SetConeSetConnection(this->Cones->GetOutputPort());
    this->Probe->SetLightConnection(this->Light->GetOutputPort());
    this->Probe->SetMeshData(mesh);
    this->Accuracy->SetConeSetConnection(this->Cones->GetOutputPort());
    this->Accuracy->SetLightConnection(this->Light->GetOutputPort());
    this->Accuracy->SetMeshData(mesh);
    this->Accuracy->SetNumberOfSamples(2000);
    this->Accuracy->SetNumberOfLightSamples(4);
  }
  std::vector<vtkAlgorithm*> Filters() const
  {
    return { this->Vectors, this->Cones, this->Geometry, this->Volume, this->Probe, this->Accuracy };
  }

  vtkSmartPointer<vtkAreaLightSource> Light;
  vtkNew<vtkShadowVectorFilter> Vectors;
  vtkNew<vtkConeSetFilter> Cones;
  vtkNew<vtkConeSetGeometry> Geometry;
  vtkNew<vtkShadowVolume> Volume;
  vtkNew<vtkConeSetProbe> Probe;
  vtkNew<vtkConeSetAccuracy> Accuracy;
};

} // namespace

TEST(NamesAndBlocks, EveryFilterJoinsBlocksAndPassesNamesOn)
{
  const Chain chain(Walls());
  for (vtkAlgorithm* filter : chain.Filters())
  {
    filter->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = filter->GetOutputDataObject(port);
      ASSERT_FALSE(output->IsA("vtkCompositeDataSet")) << filter->GetClassName();
      EXPECT_EQ(NamesIn(output), (Names{ "west", "east" })) << filter->GetClassName() << " " << port;
      ArrayOf(output->GetFieldData(), "CastersFingerprint", VTK_TYPE_UINT64, 1);
    }
  }
  // Half of the photons meet either wall.
  vtkDataArray* ids =
    vtkPolyData::SafeDownCast(chain.Vectors->GetOutputDataObject(0))->GetPointData()->GetArray("OccluderId");
  double range[2];
  ids->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 1.0);
}

TEST(NamesAndBlocks, TwoWallsHideAllOfALamp)
{
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
  probe->SetConeSetData(ConeAroundAll());
  probe->SetLightConnection(LampAbove(4.0)->GetOutputPort());
  probe->SetMeshData(Walls());
  probe->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("Visibility")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(output->GetPointData()->GetArray("ShadowClass")->GetComponent(0, 0), 2.0);

  // The data set that is asked for may be of blocks too: each is answered.
  vtkNew<vtkMultiBlockDataSet> places;
  places->SetBlock(0, PointsAt({ 0.0, 0.0, 0.0 }));
  places->SetBlock(1, PointsAt({ 0.0, 0.0, 3.0, 0.0, 0.0, 1.0 }));
  probe->SetInputDataObject(0, places);
  probe->Update();
  auto* answer = vtkMultiBlockDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(answer, nullptr);
  vtkDataArray* second = vtkDataSet::SafeDownCast(answer->GetBlock(1))->GetPointData()->GetArray("Visibility");
  EXPECT_EQ(second->GetComponent(0, 0), 1.0) << "between lamp and walls";
  EXPECT_EQ(second->GetComponent(1, 0), 0.0);
}

TEST(NamesAndBlocks, WideIdsCastShadowsWithoutLabels)
{
  const auto wall = Wall(-2.0, 2.0);
  vtkNew<vtkTypeInt64Array> ids;
  ids->SetName("OccluderId");
  ids->InsertNextValue(11223344556);
  wall->GetCellData()->AddArray(ids);
  const Chain chain(wall);
  chain.Probe->SetConeSetData(ConeAroundAll());
  chain.Probe->Update();
  vtkPointData* data = vtkDataSet::SafeDownCast(chain.Probe->GetOutputDataObject(0))->GetPointData();
  EXPECT_EQ(data->GetArray("Visibility")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(data->GetArray("OccluderId")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(NamesIn(chain.Probe->GetOutputDataObject(0)), Names{ "11223344556" });
  ids->SetValue(0, -1);
  ids->Modified();
  wall->Modified();
  chain.Probe->Update();
  data = vtkDataSet::SafeDownCast(chain.Probe->GetOutputDataObject(0))->GetPointData();
  EXPECT_EQ(data->GetArray("Visibility")->GetComponent(0, 0), 1.0);
}

TEST(NamesAndBlocks, ALampThatCastsAShadowLeavesItsFieldsBehind)
{
  // A disc of radius 1 as occluder, with its shape in the field data, under another lamp.
  vtkNew<vtkAreaLightSource> occluder;
  occluder->SetShapeToDisc();
  occluder->SetCenter(0.0, 0.0, 2.0);
  occluder->SetRadius(1.0);
  occluder->SetNumberOfWavelengths(3);
  occluder->Update();
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputConnection(occluder->GetOutputPort());
  labels->Update();
  EXPECT_EQ(labels->GetOutput()->GetFieldData()->GetArray("LightShape"), nullptr);
  const auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->DeepCopy(labels->GetOutput());
  mesh->GetFieldData()->PassData(occluder->GetOutput()->GetFieldData());
  Chain chain(mesh);

  chain.Cones->Update();
  vtkFieldData* field = chain.Cones->GetOutput()->GetFieldData();
  EXPECT_EQ(field->GetArray("LightRadius")->GetComponent(0, 0), 0.5);
  EXPECT_EQ(field->GetArray("LightCenter")->GetComponent(0, 2), 4.0);
  EXPECT_EQ(field->GetArray("LightSpectrum")->GetNumberOfTuples(), 7);

  // A light without an exact shape has none in the outputs either.
  chain.Vectors->SetLightData(Wall(-0.5, 0.5));
  chain.Vectors->Update();
  EXPECT_EQ(chain.Vectors->GetOutputDataObject(0)->GetFieldData()->GetArray("LightShape"), nullptr);
  EXPECT_EQ(chain.Vectors->GetOutputDataObject(1)->GetFieldData()->GetArray("LightRadius"), nullptr);
}

TEST(NamesAndBlocks, ConesOfAnotherMeshAreNoticedOnce)
{
  const auto mesh = MeshBuilder().AddBox(0.0, 0.0, 2.0, 1.0, 1.0, 0.1, 0).AddSquare(0.0, 9.0, -1).Build();
  const Chain chain(mesh);
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(mesh);
  labels->Update();
  // Labelled or not, with or without its receivers: the casters are the same.
  const Messages messages(chain.Probe);
  const Messages others(chain.Accuracy);
  const auto alone = MeshBuilder().AddBox(0.0, 0.0, 2.0, 1.0, 1.0, 0.1, 3).Build();
  for (vtkPolyData* same : { mesh.Get(), labels->GetOutput(), alone.Get() })
  {
    chain.Probe->SetMeshData(same);
    chain.Accuracy->SetMeshData(same);
    chain.Probe->Update();
    chain.Accuracy->Update();
    EXPECT_EQ(messages.Warnings + others.Warnings + messages.Errors, "");
  }
  const auto other = MeshBuilder().AddBox(0.25, 0.0, 2.0, 1.0, 1.0, 0.1, 0).Build();
  chain.Probe->SetMeshData(other);
  chain.Probe->Update();
  const std::string text = "The cone set on input port 1 was made from other casters than those of the mesh on input "
                           "port 3";
  EXPECT_SAYS(messages.Warnings, text);
  EXPECT_EQ(messages.Warnings.find(text, messages.Warnings.find(text) + 1), std::string::npos);
}

TEST(NamesAndBlocks, HiddenPlacesHaveNoAnswer)
{
  // 3 x 3 points in the shadow of a wall over x < -0.25; the middle one is blanked, and is no number.
  vtkNew<vtkStructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 9; ++k)
  {
    points->InsertNextPoint(k % 3 - 1.0, k / 3 - 1.0, 1.9);
  }
  points->SetPoint(4, std::nan(""), 0.0, 0.0);
  grid->SetDimensions(3, 3, 1);
  grid->SetPoints(points);
  grid->BlankPoint(4);
  vtkUnsignedCharArray* marks = grid->GetPointGhostArray();
  marks->SetValue(0, marks->GetValue(0) | vtkDataSetAttributes::DUPLICATEPOINT);

  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(grid);
  probe->SetConeSetData(ConeAroundAll());
  probe->SetLightConnection(LampAbove(4.0, 0.01)->GetOutputPort());
  probe->SetMeshData(Wall(-2.0, -0.25));
  probe->Update();
  vtkPointData* data = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  for (vtkIdType k = 0; k < 9; ++k)
  {
    const double visibility = data->GetArray("Visibility")->GetComponent(k, 0);
    if (k == 4)
    {
      EXPECT_TRUE(std::isnan(visibility));
      EXPECT_TRUE(std::isnan(data->GetArray("VisibilityError")->GetComponent(k, 0)));
      EXPECT_EQ(data->GetArray("ShadowClass")->GetComponent(k, 0), 255.0);
      EXPECT_EQ(data->GetArray("OccluderId")->GetComponent(k, 0), -1.0);
    }
    else
    {
      EXPECT_EQ(visibility, k % 3 == 0 ? 0.0 : 1.0) << k;
    }
  }

  // All four cells touch the point; without it each has an answer, but the one that is blanked.
  probe->SetAssociationToCells();
  probe->Update();
  vtkCellData* cells = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetCellData();
  for (vtkIdType k = 0; k < 4; ++k)
  {
    EXPECT_EQ(cells->GetArray("ShadowClass")->GetComponent(k, 0), 255.0) << k;
  }
  grid->UnBlankPoint(4);
  points->SetPoint(4, 0.0, 0.0, 1.9);
  grid->BlankCell(3);
  grid->Modified();
  probe->Update();
  cells = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetCellData();
  const double classes[4] = { 2.0, 0.0, 2.0, 255.0 };
  for (vtkIdType k = 0; k < 4; ++k)
  {
    EXPECT_EQ(cells->GetArray("ShadowClass")->GetComponent(k, 0), classes[k]) << k;
  }
}

TEST(NamesAndBlocks, HiddenPointsAreNoSamples)
{
  const auto samples = PointsAt({ 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.5, 0.0, 0.0 });
  shadowcones::AddIntArray(samples->GetPointData(), "Own", 1, { 7, 8, 9 });
  shadowcones::AddIntArray(samples->GetPointData(), "ShadowClass", 1, { 2, 255, 2 });
  SetMarks(samples->GetPointData(), { 0, vtkDataSetAttributes::HIDDENPOINT, vtkDataSetAttributes::DUPLICATEPOINT });
  const Chain chain(Wall(-2.0, 2.0));
  chain.Accuracy->SetConeSetData(ConeAroundAll());
  chain.Accuracy->SetInputData(samples);
  chain.Accuracy->Update();
  auto* output = vtkPolyData::SafeDownCast(chain.Accuracy->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfPoints(), 2);
  EXPECT_EQ(output->GetPointData()->GetArray("Own")->GetComponent(1, 0), 9.0);
  EXPECT_EQ(output->GetPointData()->GetArray("Truth")->GetComponent(1, 0), 0.0);
}

TEST(NamesAndBlocks, HiddenCellsCastNothing)
{
  // A sheet of 2 x 1 squares whose second half is hidden: the lamp is seen through it.
  vtkNew<vtkPolyData> sheet;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 6; ++k)
  {
    points->InsertNextPoint(2.0 * (k % 3) - 2.0, 4.0 * (k / 3) - 2.0, 2.0);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 4, 3 });
  polys->InsertNextCell({ 1, 2, 5, 4 });
  sheet->SetPoints(points);
  sheet->SetPolys(polys);
  SetMarks(sheet->GetCellData(), { 0, vtkDataSetAttributes::HIDDENCELL });
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(sheet);
  labels->Update();
  EXPECT_EQ(labels->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(labels->GetOutput()->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()), nullptr);
  for (vtkDataObject* mesh : { static_cast<vtkDataObject*>(sheet), static_cast<vtkDataObject*>(labels->GetOutput()) })
  {
    vtkNew<vtkConeSetProbe> probe;
    probe->SetInputData(PointsAt({ -1.0, 0.0, 1.9, 1.0, 0.0, 1.9 }));
    probe->SetConeSetData(ConeAroundAll());
    probe->SetLightConnection(LampAbove(4.0, 0.1)->GetOutputPort());
    probe->SetMeshData(mesh);
    probe->Update();
    vtkPointData* data = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
    EXPECT_EQ(data->GetArray("Visibility")->GetComponent(0, 0), 0.0);
    EXPECT_EQ(data->GetArray("Visibility")->GetComponent(1, 0), 1.0);
  }
}

TEST(NamesAndBlocks, LabelsByAnArray)
{
  // Two boxes, four ids: the sides of the first are two occluders, both of the second's are below 0 or one.
  const auto mesh =
    MeshBuilder().AddBox(0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0).AddBox(5.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0).Build();
  vtkNew<vtkTypeUInt64Array> keys;
  keys->SetName("key");
  for (const std::uint64_t key : { 7, 7, 7, 5, 5, 5, 7, 7, 7, 7, 7, 7 })
  {
    keys->InsertNextValue(key + 9007199254740992u);
  }
  mesh->GetCellData()->AddArray(keys);
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(mesh);
  labels->SetLabelByToArray();
  labels->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "key");
  labels->Update();
  EXPECT_EQ(FieldValue(labels->GetOutput(), "NumberOfOccluders"), 2.0);
  EXPECT_EQ(NamesIn(labels->GetOutput()), (Names{ "9007199254740999", "9007199254740997" }));
  vtkDataArray* ids = labels->GetOutput()->GetCellData()->GetArray("OccluderId");
  ASSERT_EQ(ids->GetNumberOfTuples(), 24);
  for (vtkIdType t = 0; t < 24; ++t)
  {
    EXPECT_EQ(ids->GetComponent(t, 0), t >= 6 && t < 12 ? 1.0 : 0.0) << t;
  }

  // "OccluderId" unless told, and with its receivers in any case.
  mesh->GetCellData()->GetArray("OccluderId")->SetComponent(11, 0, -1.0);
  mesh->Modified();
  labels->Modified();
  labels->Update();
  EXPECT_EQ(labels->GetOutput()->GetCellData()->GetArray("OccluderId")->GetComponent(23, 0), -1.0);
  vtkNew<vtkLabelOccluders> plain;
  plain->SetInputData(mesh);
  plain->SetLabelByToArray();
  plain->Update();
  EXPECT_EQ(FieldValue(plain->GetOutput(), "NumberOfOccluders"), 1.0) << "two boxes, one id";
  EXPECT_EQ(NamesIn(plain->GetOutput()), Names{ "0" });

  const Messages messages(labels);
  labels->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "missing");
  labels->Update();
  EXPECT_SAYS(messages.Errors, "LabelBy is Array: The mesh has no array \"missing\".");
}

TEST(NamesAndBlocks, NormalsArePassedOn)
{
  // A roof of two squares on the edge x = 0, the second wound the other way: its normals are turned with it.
  vtkNew<vtkPolyData> roof;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double places[8][3] = { { -1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { -1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 },
    { 1, 1, 0 }, { 0, 1, 1 } };
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int k = 0; k < 8; ++k)
  {
    points->InsertNextPoint(places[k]);
    const float half = std::sqrt(0.5f);
    normals->InsertNextTuple3(k < 4 ? -half : -half, 0.0, k < 4 ? half : -half); // the second's as it is wound
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  polys->InsertNextCell({ 7, 6, 5, 4 });
  roof->SetPoints(points);
  roof->SetPolys(polys);
  roof->GetPointData()->SetNormals(normals);
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(roof);
  labels->Update();
  vtkPolyData* output = labels->GetOutput();
  EXPECT_EQ(FieldValue(output, "NumberOfOccluders"), 1.0) << "welded all the same";
  EXPECT_EQ(output->GetNumberOfPoints(), 8) << "the ridge keeps both normals";
  vtkDataArray* passed = output->GetPointData()->GetNormals();
  ASSERT_NE(passed, nullptr);
  EXPECT_STREQ(passed->GetName(), "Normals");
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    output->GetCellPoints(cell, count, ids);
    double p[3][3];
    for (int c = 0; c < 3; ++c)
    {
      output->GetPoint(ids[c], p[c]);
    }
    const shadowcones::Vector3 a{ p[0][0], p[0][1], p[0][2] };
    const shadowcones::Vector3 face = Normalized(Cross(
      shadowcones::Vector3{ p[1][0], p[1][1], p[1][2] } - a, shadowcones::Vector3{ p[2][0], p[2][1], p[2][2] } - a));
    for (int c = 0; c < 3; ++c)
    {
      const shadowcones::Vector3 normal{ passed->GetComponent(ids[c], 0), passed->GetComponent(ids[c], 1),
        passed->GetComponent(ids[c], 2) };
      EXPECT_NEAR(Dot(normal, face), 1.0, 1e-6);
    }
  }
  normals->Modified();
  for (vtkIdType k = 0; k < 8; ++k)
  {
    normals->SetTuple3(k, 0.0, 0.0, k < 4 ? 1.0 : -1.0); // smooth over the ridge
  }
  roof->Modified();
  labels->Update();
  EXPECT_EQ(labels->GetOutput()->GetNumberOfPoints(), 6);
}
