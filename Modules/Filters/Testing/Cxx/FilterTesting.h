// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterTesting.h
 * @brief What tests of filters share: messages caught, small labelled meshes, lights, arrays by name.
 */
#ifndef FilterTesting_h
#define FilterTesting_h

#include "vtkAlgorithm.h"
#include "vtkAreaLightSource.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace filtertesting
{

/// Collects the errors and warnings of a filter and of its executive instead of printing them.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* algorithm)
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* messages = static_cast<Messages*>(self);
        (event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings) += static_cast<const char*>(text);
      });
    this->Algorithm = algorithm;
    for (vtkObject* object : this->Speakers())
    {
      object->AddObserver(vtkCommand::ErrorEvent, this->Callback);
      object->AddObserver(vtkCommand::WarningEvent, this->Callback);
    }
  }
  ~Messages()
  {
    for (vtkObject* object : this->Speakers())
    {
      object->RemoveObserver(this->Callback);
    }
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  std::string Errors;
  std::string Warnings;

private:
  std::array<vtkObject*, 2> Speakers() { return { this->Algorithm, this->Algorithm->GetExecutive() }; }

  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> Callback;
};

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

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "said: " << (text)

} // namespace filtertesting

#endif
