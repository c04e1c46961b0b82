// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSolids.h
 * @brief What makes a surface a solid, and its volume.
 */
#ifndef TestSolids_h
#define TestSolids_h

#include "scVector3.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// By the divergence theorem, of VTK; 0 of nothing.
inline double VolumeOf(vtkPolyData* surface)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return 0.0;
  }
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  mass->Update();
  return mass->GetVolume();
}

/// The edges of one triangle (boundary), or of more than two.
inline int Edges(vtkPolyData* surface, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfCells());
}

/**
 * Closed, manifold at edges and at points, consistently oriented, no point twice, no triangle without an area.
 * @return the signed volume: positive where the orientation is outward.
 */
inline double ExpectSolid(vtkPolyData* surface)
{
  EXPECT_EQ(Edges(surface, true), 0);
  EXPECT_EQ(Edges(surface, false), 0);
  const vtkIdType numberOfPoints = surface->GetNumberOfPoints();
  if (numberOfPoints == 0)
  {
    ADD_FAILURE() << "no surface";
    return 0.0;
  }
  // Around a point: from one neighbour to the next. Each directed edge is there once.
  std::unordered_map<vtkIdType, vtkIdType> next;
  std::vector<vtkIdType> degrees(static_cast<std::size_t>(numberOfPoints), 0);
  std::vector<vtkIdType> first(static_cast<std::size_t>(numberOfPoints), -1);
  double volume = 0.0;
  double smallest = HUGE_VAL;
  double origin[3];
  surface->GetPoint(0, origin);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  bool oriented = true;
  for (surface->GetPolys()->InitTraversal(); surface->GetPolys()->GetNextCell(count, ids);)
  {
    Vector3 corners[3];
    for (int k = 0; k < 3; ++k)
    {
      oriented = oriented && next.emplace(ids[k] * numberOfPoints + ids[(k + 1) % 3], ids[(k + 2) % 3]).second;
      ++degrees[ids[k]];
      first[ids[k]] = ids[(k + 1) % 3];
      double p[3];
      surface->GetPoint(ids[k], p);
      corners[k] = { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
    }
    volume += Dot(corners[0], Cross(corners[1], corners[2])) / 6.0;
    smallest = std::min(smallest, Length(Cross(corners[1] - corners[0], corners[2] - corners[0])));
  }
  EXPECT_TRUE(oriented);
  EXPECT_GT(smallest, 0.0);

  // One turn around a point meets all of its triangles: surfaces do not touch in points.
  vtkIdType turns = 0;
  std::vector<std::vector<double>> points;
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    vtkIdType steps = 0;
    vtkIdType neighbor = first[i];
    do
    {
      const auto step = next.find(i * numberOfPoints + neighbor);
      neighbor = step == next.end() ? -1 : step->second;
      ++steps;
    } while (neighbor >= 0 && neighbor != first[i] && steps <= degrees[i]);
    turns += neighbor == first[i] && steps == degrees[i];
    double p[3];
    surface->GetPoint(i, p);
    points.push_back({ p[0], p[1], p[2] });
  }
  EXPECT_EQ(turns, numberOfPoints);
  std::sort(points.begin(), points.end());
  EXPECT_EQ(std::adjacent_find(points.begin(), points.end()), points.end());
  return volume;
}

} // namespace testsupport
} // namespace shadowcones

#endif
