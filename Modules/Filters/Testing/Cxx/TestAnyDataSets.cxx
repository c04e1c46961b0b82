// SPDX-License-Identifier: BSD-3-Clause
// vtkLabelOccluders on data sets that are no poly data: areas, volumes and counts by hand.
#include "vtkLabelOccluders.h"

#include "Messages.h"
#include "TestPolyData.h"

#include "vtkAMRBox.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMassProperties.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// An image of so many voxels, each a unit cube.
vtkSmartPointer<vtkImageData> Voxels(int x, int y, int z, double originX = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x + 1, y + 1, z + 1);
  image->SetOrigin(originX, 0.0, 0.0);
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    heat->InsertNextValue(100.0 + static_cast<double>(cell));
  }
  image->GetCellData()->AddArray(heat);
  return image;
}

/// The same cells as hexahedra, or each as six tetrahedra.
vtkSmartPointer<vtkUnstructuredGrid> Solids(vtkImageData* image, bool tetrahedra)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  // Six around the diagonal from corner 0 to 6; every face is cut alike from both of its sides.
  constexpr int paths[6][2] = { { 1, 2 }, { 2, 3 }, { 3, 7 }, { 7, 4 }, { 4, 5 }, { 5, 1 } };
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> voxel;
    image->GetCellPoints(cell, voxel);
    const vtkIdType corners[8] = { voxel->GetId(0), voxel->GetId(1), voxel->GetId(3), voxel->GetId(2), voxel->GetId(4),
      voxel->GetId(5), voxel->GetId(7), voxel->GetId(6) };
    if (!tetrahedra)
    {
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
      continue;
    }
    for (const auto& path : paths)
    {
      const vtkIdType tetrahedron[4] = { corners[0], corners[path[0]], corners[path[1]], corners[6] };
      grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
    }
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> Labelled(vtkDataObject* input, int labelBy = vtkLabelOccluders::Automatic)
{
  vtkNew<vtkLabelOccluders> filter;
  filter->SetLabelBy(labelBy);
  filter->SetInputDataObject(0, input);
  EXPECT_EQ(ErrorsOf(filter), "");
  return filter->GetOutput();
}

double Volume(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  mass->Update();
  return mass->GetVolume();
}

double Area(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  mass->Update();
  return mass->GetSurfaceArea();
}

/// Every triangle lies on the boundary of the cell that it says it is of, and has its value.
void ExpectOriginalCells(vtkDataSet* input, vtkPolyData* mesh)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("vtkOriginalCellIds"));
  ASSERT_NE(ids, nullptr);
  vtkDataArray* heat = mesh->GetCellData()->GetArray("Heat");
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    double cell[6];
    double triangle[6];
    input->GetCellBounds(ids->GetValue(t), cell);
    mesh->GetCellBounds(t, triangle);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(triangle[2 * axis], cell[2 * axis] - 1e-12);
      EXPECT_LE(triangle[2 * axis + 1], cell[2 * axis + 1] + 1e-12);
    }
    if (heat)
    {
      EXPECT_EQ(heat->GetComponent(t, 0), 100.0 + static_cast<double>(ids->GetValue(t)));
    }
  }
}

} // namespace

TEST(AnyDataSets, ABoxOfEveryKind)
{
  // 2 x 3 x 4 units: 52 unit squares of surface, 24 of volume.
  const auto image = Voxels(2, 3, 4, 1e7 + 0.25); // single precision would lose the quarter
  vtkNew<vtkRectilinearGrid> rectilinear;
  vtkNew<vtkStructuredGrid> structured;
  int dimensions[3];
  image->GetDimensions(dimensions);
  rectilinear->SetDimensions(dimensions);
  structured->SetDimensions(dimensions);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  structured->SetPoints(points);
  const std::function<void(vtkDataArray*)> setters[3] = { [&](vtkDataArray* a) { rectilinear->SetXCoordinates(a); },
    [&](vtkDataArray* a) { rectilinear->SetYCoordinates(a); },
    [&](vtkDataArray* a) { rectilinear->SetZCoordinates(a); } };
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int k = 0; k < dimensions[axis]; ++k)
    {
      coordinates->InsertNextValue(image->GetOrigin()[axis] + k);
    }
    setters[axis](coordinates);
  }
  rectilinear->GetCellData()->ShallowCopy(image->GetCellData());
  const auto hexahedra = Solids(image, false);
  hexahedra->GetCellData()->ShallowCopy(image->GetCellData());
  const auto tetrahedra = Solids(image, true);
  const std::vector<vtkDataSet*> sets = { image, rectilinear, structured, hexahedra, tetrahedra };
  for (vtkDataSet* set : sets)
  {
    SCOPED_TRACE(set->GetClassName());
    const auto mesh = Labelled(set);
    EXPECT_EQ(mesh->GetNumberOfCells(), 104);
    EXPECT_NEAR(Area(mesh), 52.0, 1e-6);
    EXPECT_EQ(FieldValue(mesh, "ExtractedSurfaces"), 1.0);
    EXPECT_EQ(FieldValue(mesh, "NumberOfOccluders"), 1.0);
    EXPECT_EQ(FieldValue(mesh, "OccluderClosed"), 1.0);
    EXPECT_EQ(FieldValue(mesh, "BoundaryEdges"), 0.0);
    EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(mesh->GetBounds()[0], 1e7 + 0.25);
    ExpectOriginalCells(set, mesh);
    // Outward: seen from the origin of an own frame the volume is positive.
    double volume = 0.0;
    for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(t, ids);
      Vector3 p[3];
      for (int c = 0; c < 3; ++c)
      {
        double x[3];
        mesh->GetPoint(ids->GetId(c), x);
        p[c] = { x[0] - 1e7, x[1], x[2] };
      }
      volume += Dot(p[0], Cross(p[1], p[2])) / 6.0;
    }
    EXPECT_NEAR(volume, 24.0, 1e-6);
  }
}

TEST(AnyDataSets, PolyDataStayAsTheyAre)
{
  MeshBuilder builder;
  builder.AddBox(0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 5);
  const auto mesh = Labelled(builder.Build());
  EXPECT_EQ(FieldValue(mesh, "ExtractedSurfaces"), 0.0);
  EXPECT_FALSE(mesh->GetCellData()->HasArray("vtkOriginalCellIds"));
}

TEST(AnyDataSets, HiddenCellsShowWhatTheyHid)
{
  // Of 3 x 3 x 3 the middle and a corner are hidden, and another corner is another rank's: the middle is a cavity of
  // six squares, and a corner shows three where it hid three.
  const auto image = Voxels(3, 3, 3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(27);
  ghosts->FillValue(0);
  ghosts->SetValue(13, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(26, vtkDataSetAttributes::DUPLICATECELL);
  image->GetCellData()->AddArray(ghosts);
  const auto mesh = Labelled(image, vtkLabelOccluders::Whole);
  EXPECT_NEAR(Area(mesh), 54.0 + 6.0, 1e-9);
  ExpectOriginalCells(image, mesh);
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("vtkOriginalCellIds"));
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    EXPECT_TRUE(ids->GetValue(t) != 0 && ids->GetValue(t) != 13 && ids->GetValue(t) != 26);
  }
  // A hidden point takes the cells that use it: a corner of the box is a corner of one.
  const auto other = Voxels(2, 2, 2);
  vtkNew<vtkUnsignedCharArray> points;
  points->SetName(vtkDataSetAttributes::GhostArrayName());
  points->SetNumberOfValues(27);
  points->FillValue(0);
  points->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  other->GetPointData()->AddArray(points);
  EXPECT_NEAR(Volume(Labelled(other)), 7.0, 1e-6);
}

TEST(AnyDataSets, BlocksOfAllKinds)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Voxels(1, 1, 1));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "tower");
  MeshBuilder builder;
  builder.AddBox(8.0, 0.0, 0.0, 1.0, 1.0, 1.0, 5);
  auto house = builder.Build();
  house->GetCellData()->RemoveArray("OccluderId");
  blocks->SetBlock(1, house);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "house");
  blocks->SetBlock(2, Solids(Voxels(2, 1, 1, 20.0), true));
  const auto mesh = Labelled(blocks);
  EXPECT_EQ(FieldValue(mesh, "ExtractedSurfaces"), 2.0);
  EXPECT_EQ(FieldValue(mesh, "NumberOfOccluders"), 3.0);
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("OccluderNames"));
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetValue(0), "tower");
  EXPECT_EQ(names->GetValue(1), "house");
  EXPECT_EQ(names->GetValue(2), "2");
  EXPECT_NEAR(Area(mesh), 6.0 + 24.0 + 10.0, 1e-9);

  // Partitions are one occluder; a collection has one for each.
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Voxels(1, 1, 1));
  parts->SetPartition(1, Voxels(1, 1, 1, 5.0));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  collection->SetPartition(1, 0, Solids(Voxels(1, 1, 1, 9.0), false));
  const auto collected = Labelled(collection);
  EXPECT_EQ(FieldValue(collected, "ExtractedSurfaces"), 3.0);
  EXPECT_EQ(FieldValue(collected, "NumberOfOccluders"), 2.0);
}

TEST(AnyDataSets, ArraysLabelCells)
{
  // Two ids side by side: each is one occluder, open where they meet, and together they are as dark as the whole.
  const auto image = Voxels(2, 1, 1);
  vtkNew<vtkIdTypeArray> buildings;
  buildings->SetName("OccluderId");
  buildings->InsertNextValue(70);
  buildings->InsertNextValue(30);
  image->GetCellData()->AddArray(buildings);
  const auto mesh = Labelled(image, vtkLabelOccluders::Array);
  EXPECT_EQ(FieldValue(mesh, "NumberOfOccluders"), 2.0);
  EXPECT_EQ(FieldValue(mesh, "BoundaryEdges"), 8.0);
  EXPECT_NEAR(Area(mesh), 10.0, 1e-9);
}

TEST(AnyDataSets, FlatAndCurvedCells)
{
  vtkNew<vtkImageData> picture; // a flat image is a sheet
  picture->SetDimensions(4, 3, 1);
  EXPECT_NEAR(Area(Labelled(picture)), 6.0, 1e-9);

  // A triangle of six points, its middles raised: four triangles.
  vtkNew<vtkUnstructuredGrid> curved;
  vtkNew<vtkPoints> points;
  for (const auto& p :
    { std::array<double, 3>{ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0.5 }, { 1, 1, 0.5 }, { 0, 1, 0.5 } })
  {
    points->InsertNextPoint(p.data());
  }
  curved->SetPoints(points);
  const vtkIdType six[6] = { 0, 1, 2, 3, 4, 5 };
  curved->InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, six);
  EXPECT_EQ(Labelled(curved)->GetNumberOfCells(), 4);
}

TEST(AnyDataSets, AdaptiveGrids)
{
  // One coarse grid of 4 x 4 x 4; its first eighth is refined by two: hidden there, and shown by the finer one.
  vtkNew<vtkOverlappingAMR> grids;
  const int counts[2] = { 1, 1 };
  grids->Initialize(2, counts);
  double origin[3] = { 0.0, 0.0, 0.0 };
  grids->SetOrigin(origin);
  grids->SetGridDescription(VTK_XYZ_GRID);
  for (int level = 0; level < 2; ++level)
  {
    double spacing[3] = { 1.0 / (1 + level), 1.0 / (1 + level), 1.0 / (1 + level) };
    grids->SetSpacing(static_cast<unsigned int>(level), spacing);
    const int low[3] = { 0, 0, 0 };
    const int high[3] = { 3, 3, 3 };
    grids->SetAMRBox(static_cast<unsigned int>(level), 0, vtkAMRBox(low, high));
    vtkNew<vtkUniformGrid> grid;
    grid->SetDimensions(5, 5, 5);
    grid->SetOrigin(origin);
    grid->SetSpacing(spacing);
    grids->SetDataSet(static_cast<unsigned int>(level), 0, grid);
    if (level == 0)
    {
      for (vtkIdType cell = 0; cell < 64; ++cell)
      {
        if (cell % 4 < 2 && cell / 4 % 4 < 2 && cell / 16 < 2)
        {
          grid->BlankCell(cell);
        }
      }
    }
  }
  const auto mesh = Labelled(grids);
  EXPECT_EQ(FieldValue(mesh, "ExtractedSurfaces"), 2.0);
  EXPECT_NEAR(Area(mesh), 96.0 + 24.0, 1e-9); // a bite has the surface of what was bitten off
}

TEST(AnyDataSets, WhatIsNoSurfaceIsSaid)
{
  vtkNew<vtkUnstructuredGrid> line;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  line->SetPoints(points);
  const vtkIdType two[2] = { 0, 1 };
  line->InsertNextCell(VTK_LINE, 2, two);
  vtkNew<vtkLabelOccluders> filter;
  filter->SetInputData(line);
  EXPECT_SAYS(ErrorsOf(filter), "The mesh has no polygons: only polygons and strips cast shadows.");
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputData(empty);
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  vtkNew<vtkImageData> nothing;
  filter->SetInputData(nothing);
  EXPECT_EQ(ErrorsOf(filter), "");
}
