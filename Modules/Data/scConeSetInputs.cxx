// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSetInputs.h"

#include "scFieldArrays.h"
#include "scLightData.h"
#include "scSceneLights.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace shadowcones
{

namespace
{

/// The emission points of the vectors of one light; of all where the vectors do not tell.
std::vector<double> EmissionPointsOf(const ShadowVectorArrays& vectors, int light)
{
  if (vectors.LightIds.empty())
  {
    return vectors.EmissionPoints;
  }
  std::vector<double> points;
  for (std::size_t i = 0; i < vectors.LightIds.size() && !vectors.EmissionPoints.empty(); ++i)
  {
    if (vectors.LightIds[i] == light)
    {
      const auto first = vectors.EmissionPoints.begin() + static_cast<std::ptrdiff_t>(3 * i);
      points.insert(points.end(), first, first + 3);
    }
  }
  return points;
}

/// How many of these points cannot lie on the light; a Sun's may lie anywhere.
vtkIdType PointsOffLight(const std::vector<double>& points, const Light& light)
{
  constexpr double roundingOfFloats = 1e-5;
  Vector3 center;
  double radius = 0.0;
  LightBoundingSphere(light, center, radius);
  vtkIdType off = 0;
  for (std::size_t i = 0; i < points.size() && !IsAtInfinity(light); i += 3)
  {
    const Vector3 point{ points[i], points[i + 1], points[i + 2] };
    off += Length(point - center) > 1.001 * radius + roundingOfFloats * Length(point);
  }
  return off;
}

/// The extents of the lights that vectors come from: of exact shapes in the field data, else of the emission points.
bool ReadLightExtents(const ShadowVectorArrays& vectors, const std::vector<Light>& shapes,
  std::vector<LightExtent>& extents, std::string& warning, std::string& error)
{
  const auto last = std::max_element(vectors.LightIds.begin(), vectors.LightIds.end());
  const std::size_t named = last == vectors.LightIds.end() ? 1 : static_cast<std::size_t>(*last) + 1;
  if (!shapes.empty() && shapes.size() < named)
  {
    error = "The shadow-vector input has the \"LightId\" " + std::to_string(named - 1) +
      " and its field data tell of " + std::to_string(shapes.size()) + " lights.";
    return false;
  }
  // Each light is looked for among all vectors, whether it has some or none.
  constexpr std::size_t mostWithoutVectors = 1000;
  if (named > vectors.LightIds.size() + mostWithoutVectors)
  {
    error = "The shadow-vector input has the \"LightId\" " + std::to_string(named - 1) + " and " +
      std::to_string(vectors.LightIds.size()) + " vectors: count lights from 0.";
    return false;
  }
  extents.clear();
  for (std::size_t k = 0; k < std::max(named, shapes.size()); ++k)
  {
    const std::vector<double> points = EmissionPointsOf(vectors, static_cast<int>(k));
    const bool hasShape = k < shapes.size() && shapes[k].Shape != LightShape::Mesh;
    const vtkIdType off = hasShape ? PointsOffLight(points, shapes[k]) : 0;
    if (off > 0)
    {
      warning = std::to_string(off) + " of " + std::to_string(points.size() / 3) + " vectors of light " +
        std::to_string(k) +
        " left a point that is not on it, as the field data tell of it: its extent is taken from "
        "the points instead. Connect all lights to one vtkShadowVectorFilter instead of joining what several made.";
    }
    const bool believed = hasShape && off == 0;
    extents.push_back(
      believed ? LightExtentOf(shapes[k]) : LightExtentOf(points.data(), static_cast<vtkIdType>(points.size() / 3)));
  }
  return true;
}

/// Mesh and lights, where they are connected; else lights as the vectors tell of them.
bool ReadScene(
  vtkInformationVector** inputVector, const std::vector<Light>& shapes, ConeSetInputs& inputs, std::string& error)
{
  vtkDataObject* mesh = vtkDataObject::GetData(inputVector[2]);
  if (mesh && !ReadTriangles(mesh, inputs.Mesh, error))
  {
    return false;
  }
  if (inputVector[3]->GetNumberOfInformationObjects() > 0)
  {
    SceneLights lights;
    if (!ReadLights(inputVector[3], lights, error))
    {
      return false;
    }
    inputs.Lights = lights.Lights;
    inputs.Said.Add(lights.Warnings);
  }
  // The faces of a mesh light do not travel with the vectors.
  else if (inputs.Said.GetSentences().empty() &&
    std::none_of(shapes.begin(), shapes.end(), [](const Light& light) { return light.Shape == LightShape::Mesh; }))
  {
    inputs.Lights = shapes;
  }
  return true;
}

} // namespace

bool ReadConeSetInputs(vtkInformationVector** inputVector, ConeSetInputs& inputs, std::string& error)
{
  vtkPolyData* vectors = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* paths = vtkPolyData::GetData(inputVector[1]);
  std::vector<Light> shapes;
  std::string warning;
  const auto isMesh = [](const Light& light) { return light.Shape == LightShape::Mesh; };
  if (!ReadLightShapes(vectors->GetFieldData(), shapes, error) ||
    !ReadShadowVectors(
      vectors, inputs.Vectors, error, shapes.empty() || std::any_of(shapes.begin(), shapes.end(), isMesh)) ||
    !CheckAttributes(vectors->GetPointData(), vectors->GetNumberOfPoints(), "point", error) ||
    (paths && !ReadPhotonPaths(paths, inputs.Paths, error)) ||
    (vectors->GetNumberOfPoints() > 0 && !ReadLightExtents(inputs.Vectors, shapes, inputs.Extents, warning, error)))
  {
    return false;
  }
  inputs.Said.Add(warning);
  if (inputs.Extents.size() > 1 && paths && paths->GetNumberOfPoints() > 0 && inputs.Paths.LightIds.empty())
  {
    error = "The photon paths have no \"LightId\" and the vectors are of " + std::to_string(inputs.Extents.size()) +
      " lights: connect output port 1 of the vtkShadowVectorFilter that made the vectors.";
    return false;
  }
  return ReadScene(inputVector, shapes, inputs, error);
}

} // namespace shadowcones
