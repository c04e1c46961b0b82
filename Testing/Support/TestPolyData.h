// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPolyData.h
 * @brief Small labelled meshes, cone sets and lamps as VTK data, the meshes of Data/, and arrays by name.
 */
#ifndef TestPolyData_h
#define TestPolyData_h

#include "TestCones.h"
#include "TestMeshes.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "vtkAreaLightSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// Polygons with the cell array "OccluderId".
class MeshBuilder
{
public:
  MeshBuilder()
  {
    this->Points->SetDataTypeToDouble();
    this->OccluderIds->SetName("OccluderId");
  }
  vtkIdType AddPoint(double x, double y, double z) { return this->Points->InsertNextPoint(x, y, z); }
  void AddQuad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d, int occluder)
  {
    this->Polygons->InsertNextCell({ a, b, c, d });
    this->OccluderIds->InsertNextValue(occluder);
  }
  /// A closed box around a point, normals outward.
  MeshBuilder& AddBox(double x, double y, double z, double halfX, double halfY, double halfZ, int occluder)
  {
    const vtkIdType f = this->Points->GetNumberOfPoints();
    for (int i = 0; i < 8; ++i)
    {
      this->AddPoint(x + (i & 1 ? halfX : -halfX), y + (i & 2 ? halfY : -halfY), z + (i & 4 ? halfZ : -halfZ));
    }
    constexpr int quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
      { 4, 5, 7, 6 } };
    for (const auto& q : quads)
    {
      this->AddQuad(f + q[0], f + q[1], f + q[2], f + q[3], occluder);
    }
    return *this;
  }
  /// A square in a plane of constant z, facing up.
  MeshBuilder& AddSquare(double z, double half, int occluder)
  {
    const vtkIdType f = this->AddPoint(-half, -half, z);
    this->AddPoint(half, -half, z);
    this->AddPoint(half, half, z);
    this->AddPoint(-half, half, z);
    this->AddQuad(f, f + 1, f + 2, f + 3, occluder);
    return *this;
  }
  vtkSmartPointer<vtkPolyData> Build() const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polygons);
    mesh->GetCellData()->AddArray(this->OccluderIds);
    return mesh;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkIntArray> OccluderIds;
};

/// Points and triangles, without ids.
inline vtkSmartPointer<vtkPolyData> ToPolyData(const TestMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t k = 0; k < mesh.Points.size(); k += 3)
  {
    points->InsertNextPoint(mesh.Points.data() + k);
  }
  vtkNew<vtkCellArray> triangles;
  for (std::size_t k = 0; k < mesh.Triangles.size(); k += 3)
  {
    triangles->InsertNextCell(3, mesh.Triangles.data() + k);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

/// A corner and two edges.
inline vtkSmartPointer<vtkPolyData> Plane(const Vector3& origin, const Vector3& u, const Vector3& v)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(origin.X, origin.Y, origin.Z);
  plane->SetPoint1(origin.X + u.X, origin.Y + u.Y, origin.Z + u.Z);
  plane->SetPoint2(origin.X + v.X, origin.Y + v.Y, origin.Z + v.Z);
  plane->Update();
  return plane->GetOutput();
}

/// Vertices at three coordinates each.
inline vtkSmartPointer<vtkPolyData> PointsAt(const std::vector<double>& coordinates)
{
  auto points = vtkSmartPointer<vtkPolyData>::New();
  SetVertices(points, coordinates);
  return points;
}

inline vtkSmartPointer<vtkPolyData> ConeSetOf(const std::vector<Cone>& cones)
{
  auto set = vtkSmartPointer<vtkPolyData>::New();
  WriteConeSet(cones, set);
  return set;
}

/// A mesh of the folder Data.
inline vtkSmartPointer<vtkPolyData> ReadData(const std::string& name)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((std::string(SHADOWCONES_DATA_DIR) + "/" + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// A disc above the origin that faces down the z axis.
inline vtkSmartPointer<vtkAreaLightSource> LampAbove(double z, double radius = 0.5)
{
  auto light = vtkSmartPointer<vtkAreaLightSource>::New();
  light->SetShapeToDisc();
  light->SetCenter(0.0, 0.0, z);
  light->SetNormal(0.0, 0.0, -1.0);
  light->SetRadius(radius);
  return light;
}

/// The array of that name, of that type and number of components; else a failure and nullptr.
inline vtkDataArray* ArrayOf(vtkFieldData* data, const char* name, int type, int components)
{
  vtkDataArray* array = data->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  if (array)
  {
    EXPECT_EQ(array->GetDataType(), type) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
  }
  return array;
}

inline double FieldValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : -1e300;
}

} // namespace testsupport
} // namespace shadowcones

#endif
