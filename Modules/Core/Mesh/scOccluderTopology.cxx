// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderTopology.h"

#include "scDisjointSets.h"
#include "scPointWelding.h"
#include "scSurfacePatches.h"
#include "scUnitFrame.h"

#include <algorithm>
#include <array>

namespace shadowcones
{
namespace
{
using Ids = std::vector<vtkIdType>;

/// No area: the height above the longest edge is a matter of rounding.
bool IsDegenerate(const UnitFrame& frame, vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (a == b || b == c || c == a)
  {
    return true;
  }
  const Vector3 u = frame.Between(a, b);
  const Vector3 v = frame.Between(a, c);
  const double longest = std::max({ Length(u), Length(v), Length(u - v) });
  const double rounding = std::max({ frame.Rounding(a), frame.Rounding(b), frame.Rounding(c) });
  return !(Length(Cross(u, v)) > rounding * longest);
}

/// Fill Triangles (of input point ids) and InputTriangles with what is neither degenerate nor there twice.
void KeepProperTriangles(
  const TriangleMeshView& mesh, const UnitFrame& frame, const Ids& weld, OccluderTopology& result)
{
  struct Face
  {
    std::array<vtkIdType, 3> Sorted;
    bool Receiver;
    vtkIdType Input;
  };
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    const vtkIdType* ids = mesh.Triangles + 3 * t;
    std::array<vtkIdType, 3> sorted{ weld[ids[0]], weld[ids[1]], weld[ids[2]] };
    if (IsDegenerate(frame, sorted[0], sorted[1], sorted[2]))
    {
      ++result.DegenerateTriangles;
      continue;
    }
    std::sort(sorted.begin(), sorted.end());
    faces.push_back({ sorted, mesh.OccluderId(t) < 0, t });
  }
  std::sort(faces.begin(), faces.end(),
    [](const Face& a, const Face& b)
    {
      return a.Sorted != b.Sorted  ? a.Sorted < b.Sorted
        : a.Receiver != b.Receiver ? a.Receiver < b.Receiver
                                   : a.Input < b.Input;
    });
  const auto last = std::unique(faces.begin(), faces.end(),
    [](const Face& a, const Face& b) { return a.Sorted == b.Sorted && a.Receiver == b.Receiver; });
  result.DuplicateTriangles = static_cast<vtkIdType>(faces.end() - last);
  faces.erase(last, faces.end());

  result.InputTriangles.reserve(faces.size());
  for (const Face& face : faces)
  {
    result.InputTriangles.push_back(face.Input);
  }
  std::sort(result.InputTriangles.begin(), result.InputTriangles.end());
  result.Triangles.reserve(3 * faces.size());
  for (const vtkIdType input : result.InputTriangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles.push_back(weld[mesh.Triangles[3 * input + k]]);
    }
  }
}

/// Renumber the triangles' points from 0, in input order.
void CompactPoints(vtkIdType numberOfPoints, OccluderTopology& result)
{
  Ids numbers(static_cast<std::size_t>(numberOfPoints), -1);
  for (const vtkIdType id : result.Triangles)
  {
    numbers[id] = 0;
  }
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    if (numbers[i] == 0)
    {
      numbers[i] = static_cast<vtkIdType>(result.Points.size());
      result.Points.push_back(i);
    }
  }
  for (vtkIdType& id : result.Triangles)
  {
    id = numbers[id];
  }
}

/// OccluderIds from 0 in order of the first triangle; receivers stay negative. @return the number of occluders.
int LabelOccluders(const int* blocks, OccluderLabel labelBy, OccluderTopology& result)
{
  const auto count = static_cast<vtkIdType>(result.InputTriangles.size());
  DisjointSets components(labelBy == OccluderLabel::Component ? static_cast<vtkIdType>(result.Points.size()) : 0);
  vtkIdType numberOfKeys = 1;
  if (labelBy == OccluderLabel::Component)
  {
    numberOfKeys = static_cast<vtkIdType>(result.Points.size());
    for (vtkIdType t = 0; t < count; ++t)
    {
      if (result.OccluderIds[t] >= 0)
      {
        components.Unite(result.Triangles[3 * t], result.Triangles[3 * t + 1]);
        components.Unite(result.Triangles[3 * t], result.Triangles[3 * t + 2]);
      }
    }
  }
  else if (labelBy == OccluderLabel::Block)
  {
    for (vtkIdType t = 0; t < count; ++t)
    {
      numberOfKeys = std::max<vtkIdType>(numberOfKeys, blocks[result.InputTriangles[t]] + 1);
    }
  }
  std::vector<int> labels(static_cast<std::size_t>(numberOfKeys), -1);
  int numberOfOccluders = 0;
  for (vtkIdType t = 0; t < count; ++t)
  {
    if (result.OccluderIds[t] < 0)
    {
      continue;
    }
    const vtkIdType key = labelBy == OccluderLabel::Component ? components.Root(result.Triangles[3 * t])
      : labelBy == OccluderLabel::Block                       ? blocks[result.InputTriangles[t]]
                                                              : 0;
    labels[key] = labels[key] < 0 ? numberOfOccluders++ : labels[key];
    result.OccluderIds[t] = labels[key];
  }
  return numberOfOccluders;
}
} // anonymous namespace

bool BuildOccluderTopology(const TriangleMeshView& mesh, const int* blocks, const OccluderTopologyOptions& options,
  const Monitor& monitor, OccluderTopology& result)
{
  result = OccluderTopology();
  const auto report = [&monitor](double fraction)
  {
    if (monitor.Progress)
    {
      monitor.Progress(fraction);
    }
    return !monitor.IsAborted();
  };
  if (!report(0.0))
  {
    return false;
  }
  const int* weldBlocks = options.LabelBy == OccluderLabel::Block ? blocks : nullptr;
  const UnitFrame frame(mesh);
  const Ids weld = WeldPoints(mesh, weldBlocks, options.WeldTolerance);
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    result.WeldedPoints += weld[i] >= 0 && weld[i] != i;
  }
  if (!report(0.3))
  {
    return false;
  }
  KeepProperTriangles(mesh, frame, weld, result);
  CompactPoints(mesh.NumberOfPoints, result);
  for (const vtkIdType input : result.InputTriangles)
  {
    result.OccluderIds.push_back(mesh.OccluderId(input) < 0 ? -1 : 0);
  }
  result.Closed.assign(static_cast<std::size_t>(LabelOccluders(blocks, options.LabelBy, result)), 1);
  if (!report(0.5))
  {
    return false;
  }
  Ids opposite = PairSides(result);
  SurfacePatches patches = SpreadWinding(result, opposite);
  if (!report(0.7))
  {
    return false;
  }
  const std::vector<unsigned char> closed = ClosedPatches(result, opposite, patches);
  for (std::size_t patch = 0; patch < patches.Count(); ++patch)
  {
    unsigned char& occluderClosed = result.Closed[result.OccluderIds[patches.Order[patches.Begin[patch]]]];
    occluderClosed = occluderClosed && closed[patch];
  }
  if (options.Orient)
  {
    OrientPatches(mesh, frame, closed, patches, result);
  }
  return report(1.0);
}

} // namespace shadowcones
