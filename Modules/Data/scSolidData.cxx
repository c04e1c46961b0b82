// SPDX-License-Identifier: BSD-3-Clause
#include "scSolidData.h"

#include "scFieldArrays.h"
#include "scSentence.h"
#include "scShadowClass.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr vtkIdType largestNumberOfSamples = vtkIdType(1) << 28;
/// A surface keeps this share of a cell away from grid points: neighbours of a point then have room for triangles.
constexpr double smallestShare = 0.02;
/// Cells smaller than this share of their coordinates lose their digits.
constexpr double smallestCell = 1e-13;

/// In units of cells: the contour's points are in single precision.
vtkSmartPointer<vtkPolyData> ContourOf(const RegularGrid& grid, vtkDataArray* scalars, double value)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.Dimensions.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// The contour faces the way the field falls; @p call gets corners in the opposite order where @p turn is set.
template <typename Call>
void ForEachTriangle(vtkPolyData* surface, bool turn, Call&& call)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* triangles = surface->GetPolys();
  for (triangles->InitTraversal(); triangles->GetNextCell(count, ids);)
  {
    call(ids[0], turn ? ids[2] : ids[1], turn ? ids[1] : ids[2]);
  }
}
} // anonymous namespace

GridSurface SurfaceBetween(const RegularGrid& grid, std::vector<unsigned char>& inside)
{
  GridSurface surface;
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetArray(inside.data(), static_cast<vtkIdType>(inside.size()), 1);
  const auto contour = ContourOf(grid, scalars, 0.5);
  const vtkIdType steps[3] = { 1, grid.Dimensions[0], static_cast<vtkIdType>(grid.Dimensions[0]) * grid.Dimensions[1] };
  surface.Crossings.reserve(static_cast<std::size_t>(contour->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < contour->GetNumberOfPoints(); ++i)
  {
    double p[3];
    contour->GetPoint(i, p);
    vtkIdType low = 0;
    vtkIdType step = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double floor = std::floor(p[axis] + 0.25);
      low += static_cast<vtkIdType>(floor) * steps[axis];
      step = p[axis] - floor > 0.25 ? steps[axis] : step;
    }
    const bool lowInside = inside[static_cast<std::size_t>(low)] != 0;
    surface.Crossings.push_back({ lowInside ? low : low + step, lowInside ? low + step : low, 0.5 });
  }
  ForEachTriangle(contour, false,
    [&surface](vtkIdType a, vtkIdType b, vtkIdType c) {
      surface.Triangles.push_back({ a, b, c });
    });
  return surface;
}

SolidBuilder::SolidBuilder()
{
  this->Points->SetDataTypeToDouble();
}

SolidBuilder::~SolidBuilder() = default;

void SolidBuilder::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, const SolidKey& key)
{
  const vtkIdType triangle[3] = { a, b, c };
  this->Triangles->InsertNextCell(3, triangle);
  this->LightIds.push_back(key.first);
  this->OccluderIds.push_back(key.second);
}

void SolidBuilder::AddContour(const RegularGrid& grid, std::vector<float>& values, const SolidKey& key)
{
  const double nearest = smallestShare * std::min({ grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z });
  for (float& value : values)
  {
    value = static_cast<float>(value < 0.0f ? std::min<double>(value, -nearest) : std::max<double>(value, nearest));
  }
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1);
  const auto contour = ContourOf(grid, scalars, 0.0);
  const vtkIdType first = this->Points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < contour->GetNumberOfPoints(); ++i)
  {
    double p[3];
    contour->GetPoint(i, p);
    this->Points->InsertNextPoint(grid.Origin.X + p[0] * grid.Spacing.X, grid.Origin.Y + p[1] * grid.Spacing.Y,
      grid.Origin.Z + p[2] * grid.Spacing.Z);
  }
  ForEachTriangle(contour, true,
    [&](vtkIdType a, vtkIdType b, vtkIdType c) { this->AddTriangle(first + a, first + b, first + c, key); });
}

void SolidBuilder::Add(const RegularGrid& grid, const GridSurface& surface, const SolidKey& key)
{
  const vtkIdType first = this->Points->GetNumberOfPoints();
  for (const GridCrossing& crossing : surface.Crossings)
  {
    const Vector3 p = surface.PointOf(grid, crossing);
    this->Points->InsertNextPoint(p.X, p.Y, p.Z);
  }
  for (const auto& t : surface.Triangles)
  {
    this->AddTriangle(first + t[0], first + t[1], first + t[2], key);
  }
}

void SolidBuilder::Add(const ProjectedShadow& shadow, const SolidKey& key)
{
  const vtkIdType first = this->Points->GetNumberOfPoints();
  for (const Vector3& p : shadow.Points)
  {
    this->Points->InsertNextPoint(p.X, p.Y, p.Z);
  }
  for (const auto& t : shadow.Triangles)
  {
    this->AddTriangle(first + t[0], first + t[1], first + t[2], key);
  }
}

void SolidBuilder::Finish(vtkPolyData* output, vtkFieldData* fieldData)
{
  output->SetPoints(this->Points);
  output->SetPolys(this->Triangles);
  AddIntArray(output->GetCellData(), "OccluderId", 1, this->OccluderIds);
  AddIntArray(output->GetCellData(), "LightId", 1, this->LightIds);
  output->GetFieldData()->PassData(fieldData);
}

std::map<int, TriangleMesh> SplitOccluders(const TriangleMesh& mesh, bool each)
{
  std::map<int, TriangleMesh> parts;
  std::map<int, std::map<vtkIdType, vtkIdType>> ids;
  const TriangleMeshView view = mesh.View();
  for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
  {
    const int occluder = view.OccluderId(t);
    if (occluder < 0)
    {
      continue;
    }
    const int key = each ? occluder : -1;
    TriangleMesh& part = parts[key];
    auto& known = ids[key];
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType point = view.Triangles[3 * t + corner];
      const auto added = known.emplace(point, static_cast<vtkIdType>(part.Points.size() / 3));
      if (added.second)
      {
        part.Points.insert(part.Points.end(), view.Points + 3 * point, view.Points + 3 * point + 3);
      }
      part.Triangles.push_back(added.first->second);
    }
  }
  return parts;
}

Box BoundsOf(const VisibilityGrid& grid)
{
  return { grid.Origin, grid.Vertex(grid.Dimensions[0] - 1, grid.Dimensions[1] - 1, grid.Dimensions[2] - 1) };
}

Box ShadowOf(const VisibilityGrid& grid)
{
  Box box;
  for (int k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.Dimensions[0]; ++i)
      {
        if (grid.ShadowClasses[grid.VertexIndex(i, j, k)] != static_cast<unsigned char>(ShadowClass::Lit))
        {
          box.Add(grid.Vertex(i, j, k) - grid.Spacing);
          box.Add(grid.Vertex(i, j, k) + grid.Spacing);
        }
      }
    }
  }
  return box;
}

std::string CheckSolidRegion(const Box& region, int resolution)
{
  const Vector3 size = region.Size();
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(region.Min[axis]), std::abs(region.Max[axis]) });
  }
  const double cell = std::max({ size.X, size.Y, size.Z }) / resolution;
  if (!std::isfinite(region.Diagonal()) || !(cell > smallestCell * largest))
  {
    return Sentence(
      "cells of ", cell, " at coordinates up to ", largest, ", beyond double precision: set Bounds or Length.");
  }
  const vtkIdType samples = GridOver(region, resolution).NumberOfPoints();
  return samples > largestNumberOfSamples ? Sentence(samples, " samples at Resolution ", resolution, ", more than ",
                                              largestNumberOfSamples, ": lower Resolution.")
                                          : std::string();
}

} // namespace shadowcones
