// SPDX-License-Identifier: BSD-3-Clause
#include "scTriangleMesh.h"

#include "scPointWelding.h"

#include <algorithm>
#include <tuple>

namespace shadowcones
{

Box MeshBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    bounds.Add(mesh.Point(mesh.Triangles[i]));
  }
  return bounds;
}

Box CasterBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    if (mesh.OccluderId(i) >= 0)
    {
      bounds.Add(mesh.BoundsOf(i));
    }
  }
  return bounds;
}

std::vector<bool> ClosedOccluders(const TriangleMeshView& mesh)
{
  struct Edge
  {
    vtkIdType Low;
    vtkIdType High;
    int Occluder;
    int Sign;
  };
  // A point may stand several times at its place: once for each of its normals.
  const std::vector<vtkIdType> place = WeldPoints(mesh, nullptr, 0.0);
  std::vector<Edge> edges;
  edges.reserve(static_cast<std::size_t>(3 * mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType a = place[static_cast<std::size_t>(mesh.Triangles[3 * t + corner])];
      const vtkIdType b = place[static_cast<std::size_t>(mesh.Triangles[3 * t + (corner + 1) % 3])];
      edges.push_back({ std::min(a, b), std::max(a, b), mesh.OccluderId(t), a < b ? 1 : -1 });
    }
  }
  const auto key = [](const Edge& e) { return std::tie(e.Occluder, e.Low, e.High); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });

  std::vector<int> open;
  for (std::size_t i = 0; i < edges.size();)
  {
    int balance = 0;
    const std::size_t first = i;
    for (; i < edges.size() && key(edges[i]) == key(edges[first]); ++i)
    {
      balance += edges[i].Sign;
    }
    if (balance != 0 && (open.empty() || open.back() != edges[first].Occluder))
    {
      open.push_back(edges[first].Occluder);
    }
  }
  std::vector<bool> closed(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    closed[t] = !std::binary_search(open.begin(), open.end(), mesh.OccluderId(t));
  }
  return closed;
}

} // namespace shadowcones
