// SPDX-License-Identifier: BSD-3-Clause
#include "scConeProof.h"

#include "scConeClusters.h"
#include "scOccluderParts.h"

#include <algorithm>
#include <set>

namespace shadowcones
{
namespace
{
constexpr int addedWithoutGiven = 140;
constexpr int fewestAdded = 16;
/// The box that a cone holds where some part has none, in diagonals of the region to each side.
constexpr double heldMargin = 10.0;

Box CastersBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    for (int corner = 0; corner < 3 && mesh.OccluderId(i) >= 0; ++corner)
    {
      bounds.Add(mesh.Corner(i, corner));
    }
  }
  return bounds;
}

Box Grown(const Box& box, double margin)
{
  return { box.Min - Vector3{ margin, margin, margin }, box.Max + Vector3{ margin, margin, margin } };
}

/// A cone that holds a box.
Cone ConeAroundBox(const Box& box)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  cone.Center = { box.Center().X, box.Center().Y, box.Min.Z };
  cone.BaseRadius = 0.51 * std::hypot(box.Size().X, box.Size().Y);
  cone.InnerHalfAngle = -largestProvedAngle;
  return StoredCone(cone);
}

/// What a cone that was grown or added is for the consumers of its other values.
void Describe(const LightExtent& light, Cone& cone)
{
  cone.Normal = cone.Axis;
  double outer = 0.0;
  PenumbraAngles(light, cone.Center, cone.Axis, cone.BaseRadius, outer, cone.InnerHalfAngle);
}
} // anonymous namespace

Cone StoredCone(const Cone& cone)
{
  const auto stored = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const auto direction = [&stored](const Vector3& v) { return Normalized({ stored(v.X), stored(v.Y), stored(v.Z) }); };
  Cone result = cone;
  result.Axis = direction(cone.Axis);
  result.Normal = direction(cone.Normal);
  result.BaseRadius = stored(cone.BaseRadius);
  result.HalfAngle = stored(cone.HalfAngle);
  result.InnerHalfAngle = stored(cone.InnerHalfAngle);
  result.Planarity = stored(cone.Planarity);
  result.Overspill = stored(cone.Overspill);
  return result;
}

bool ProveConeSet(const TriangleMeshView& mesh, const Light& light, const std::vector<Cone>& given,
  const ConeProofOptions& options, const Monitor& monitor, ConeProof& proof)
{
  proof = {};
  for (const Cone& cone : given)
  {
    proof.Cones.push_back(StoredCone(cone));
  }
  proof.Origins.assign(given.size(), ConeOrigin::Fitted);
  const Box casters = CastersBounds(mesh);
  if (casters.Empty())
  {
    proof.Certified = true;
    return true;
  }
  const OccluderParts parts(mesh, light, ProofMarginsOf(MeshBounds(mesh)));
  std::vector<OccluderPart> unproved;
  if (!parts.FindUnproved(proof.Cones, monitor.Part(0.0, 0.4), unproved, proof.NumberOfProvedParts))
  {
    return false;
  }
  proof.NumberOfProvedParts += static_cast<vtkIdType>(unproved.size());

  ClusterOptions clusterOptions;
  clusterOptions.Region = options.Region.Empty() ? Grown(casters, 0.5 * casters.Diagonal()) : options.Region;
  clusterOptions.LargestNumber = options.LargestNumberOfAddedCones > 0 ? options.LargestNumberOfAddedCones
    : given.empty() ? addedWithoutGiven : std::max(fewestAdded, static_cast<int>(given.size()));
  ClusterResult clusters;
  if (!HoldParts(parts, unproved, proof.Cones, clusterOptions, monitor.Part(0.4, 1.0), clusters))
  {
    return false;
  }
  const LightExtent extent = LightExtentOf(light);
  proof.Cones = clusters.Cones;
  proof.Origins.resize(proof.Cones.size(), ConeOrigin::Added);
  for (std::size_t i = 0; i < proof.Cones.size(); ++i)
  {
    if (i < given.size() && clusters.Grown[i])
    {
      proof.Origins[i] = ConeOrigin::Grown;
      ++proof.NumberOfGrownCones;
    }
    if (proof.Origins[i] != ConeOrigin::Fitted)
    {
      Describe(extent, proof.Cones[i]);
    }
  }
  std::set<int> occluders;
  for (const OccluderPart& part : clusters.WithoutCone)
  {
    occluders.insert(mesh.OccluderId(part.Triangle));
  }
  proof.NumberOfOccludersWithoutCone = static_cast<vtkIdType>(occluders.size());
  proof.NumberOfProvedParts -= static_cast<vtkIdType>(clusters.WithoutCone.size());
  if (!occluders.empty())
  {
    proof.CertifiedBounds = Grown(clusterOptions.Region, heldMargin * clusterOptions.Region.Diagonal());
    proof.Cones.push_back(ConeAroundBox(proof.CertifiedBounds));
    proof.Origins.push_back(ConeOrigin::Added);
  }
  proof.NumberOfAddedCones = static_cast<vtkIdType>(proof.Cones.size() - given.size());
  proof.Certified = true;
  return true;
}

} // namespace shadowcones
