// SPDX-License-Identifier: BSD-3-Clause
#include "scConeClusters.h"

#include "scClusterJoiner.h"
#include "scClusterSplitter.h"
#include "scPartCluster.h"

namespace shadowcones
{
namespace
{
constexpr int mostClusters = 384; ///< before any join

/// The final cone of a cluster, around all points of all its parts.
void Finish(const OccluderParts& mesh, const std::vector<OccluderPart>& parts, const std::vector<Cone>& given,
  PartCluster& cluster)
{
  cluster.Held.clear();
  for (const int part : cluster.Parts)
  {
    const auto points = mesh.CastingPoints(parts[part]);
    cluster.Held.insert(cluster.Held.end(), points.begin(), points.end());
  }
  const Cone* core = cluster.Given >= 0 ? &given[cluster.Given] : nullptr;
  const Vector3 axis = cluster.Bound.Axis;
  cluster.Alive = ConeAlong(axis, mesh.LightParts(), cluster.Held, core, cluster.Bound) ||
    ConeAround(mesh.LightParts(), cluster.Held, core, cluster.Bound);
}
/// What becomes of a finished cluster: a given cone that has grown, one more cone, or parts without a cone.
void Take(PartCluster& cluster, const std::vector<OccluderPart>& parts, ClusterResult& result)
{
  if (!cluster.Alive)
  {
    for (const int part : cluster.Parts)
    {
      result.WithoutCone.push_back(parts[part]);
    }
    return;
  }
  cluster.Bound.OccluderId = cluster.Occluder;
  if (cluster.Given < 0)
  {
    result.Cones.push_back(cluster.Bound);
    return;
  }
  Cone& grown = result.Cones[cluster.Given];
  grown.Center = cluster.Bound.Center;
  grown.Axis = cluster.Bound.Axis;
  grown.BaseRadius = cluster.Bound.BaseRadius;
  grown.HalfAngle = cluster.Bound.HalfAngle;
  result.Grown[cluster.Given] = 1;
}
} // anonymous namespace

bool HoldParts(const OccluderParts& mesh, const std::vector<OccluderPart>& parts, const std::vector<Cone>& given,
  const ClusterOptions& options, const Monitor& monitor, ClusterResult& result)
{
  result = {};
  result.Cones = given;
  result.Grown.assign(given.size(), 0);
  if (parts.empty())
  {
    return true;
  }
  std::vector<PartCluster> clusters = SplitIntoClusters(mesh, parts, options.Region, mostClusters, result.WithoutCone);
  if (clusters.empty())
  {
    return true;
  }
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    PartCluster cluster;
    cluster.Given = static_cast<int>(i);
    cluster.Occluder = given[i].OccluderId;
    cluster.Bound = given[i];
    clusters.push_back(cluster);
  }
  if (!JoinClusters(mesh, given, options, monitor.Part(0.1, 0.9), clusters))
  {
    return false;
  }
  std::vector<std::size_t> last;
  for (std::size_t i = 0; i < clusters.size(); ++i)
  {
    if (clusters[i].Alive && !clusters[i].Parts.empty())
    {
      last.push_back(i);
    }
  }
  const bool finished = ParallelFor(static_cast<vtkIdType>(last.size()), monitor.Part(0.9, 1.0),
    [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Finish(mesh, parts, given, clusters[last[i]]);
      }
    });
  for (const std::size_t i : last)
  {
    Take(clusters[i], parts, result);
  }
  return finished;
}

} // namespace shadowcones
