// SPDX-License-Identifier: BSD-3-Clause
#include "scLeftoverCones.h"

#include "scBasePartition.h"
#include "scConeExpansion.h"
#include "scNearestVectors.h"
#include "scSeedCovering.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// A neighbour this many times as far as the one half as many before it lies beyond a gap: on a surface that is 1.4, on a line 2.
constexpr double gap = 4.0;

Vector3 PointOf(const ShadowVectorView& vectors, vtkIdType id)
{
  return { vectors.Points[3 * id], vectors.Points[3 * id + 1], vectors.Points[3 * id + 2] };
}

/// The seed and its neighbours on the same occluder, nearest first, up to a gap; the seed alone where it lies beyond one.
std::vector<vtkIdType> Companions(const ShadowVectorView& vectors, const NearestVectors& tree, vtkIdType seed, int number)
{
  std::vector<vtkIdType> members{ seed };
  std::vector<double> distances{ 0.0 };
  std::vector<vtkIdType> neighbors;
  tree.Query(seed, number, neighbors);
  for (const vtkIdType id : neighbors)
  {
    if (id == seed || (vectors.OccluderIds && vectors.OccluderIds[id] != vectors.OccluderIds[seed]))
    {
      continue;
    }
    const double distance = Length(PointOf(vectors, id) - PointOf(vectors, seed));
    if (members.size() == 1)
    {
      // The nearest one's own neighbours tell what is far here.
      std::vector<vtkIdType> around;
      tree.Query(id, number, around);
      if (distance > gap * Length(PointOf(vectors, around.back()) - PointOf(vectors, id)))
      {
        break;
      }
    }
    const double before = distances[distances.size() / 2];
    if (before > 0.0 && distance > gap * before)
    {
      break;
    }
    members.push_back(id);
    distances.push_back(distance);
  }
  return members;
}

/// A cone that holds its members: base through the foremost, across their mean direction.
Cone ConeOf(const ShadowVectorView& vectors, const std::vector<vtkIdType>& members, const LightExtent& light,
  const ConeSetOptions& options)
{
  Cone cone;
  cone.Normal = MeanDirection(vectors, members);
  double front = HUGE_VAL;
  Box box;
  for (const vtkIdType id : members)
  {
    const Vector3 p = PointOf(vectors, id);
    front = std::min(front, Dot(p, cone.Normal));
    box.Add(p);
  }
  cone.Center = box.Center() + (front - Dot(box.Center(), cone.Normal)) * cone.Normal;
  double radius = 0.0;
  double squares = 0.0;
  for (const vtkIdType id : members)
  {
    const Vector3 offset = PointOf(vectors, id) - cone.Center;
    const double height = Dot(offset, cone.Normal);
    radius = std::max(radius, Length(offset - height * cone.Normal));
    squares += height * height;
  }
  cone.VectorCount = static_cast<int>(members.size());
  cone.OccluderId = vectors.OccluderIds ? vectors.OccluderIds[members.front()] : 0;
  ConeSetOptions bound = options;
  bound.CosineCorrection = false;
  bound.RadiusScale = 1.0;
  ExpandCone(vectors, members, light, bound, radius, cone);
  cone.Planarity = radius > 0.0 ? std::sqrt(squares / static_cast<double>(members.size())) / radius : 0.0;
  return cone;
}
} // anonymous namespace

bool CoverLeftovers(const ShadowVectorView& vectors, const LightExtent& light, const ConeSetOptions& options,
  const Monitor& monitor, Team* workers, ConeSet& result)
{
  if (std::none_of(result.ConeIds.begin(), result.ConeIds.end(), [](vtkIdType cone) { return cone < 0; }))
  {
    return true;
  }
  const NearestVectors tree(vectors.Points, vectors.Count);
  const int number = std::max(options.MinimumVectorsPerCone, 4);
  const CandidateMaker make = [&](vtkIdType seed, ConeCandidate& candidate)
  {
    candidate.Members = Companions(vectors, tree, seed, number);
    candidate.Cone = ConeOf(vectors, candidate.Members, light, options);
    candidate.Radius = candidate.Cone.BaseRadius;
  };
  return SeedCovering(vectors.Points, make, nullptr, workers, result).Run(monitor);
}

} // namespace shadowcones
