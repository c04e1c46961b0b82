// SPDX-License-Identifier: BSD-3-Clause
#include "scClusterJoiner.h"

#include "scVolumeSample.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace shadowcones
{
namespace
{
using Mask = VolumeSample::Mask;

constexpr int neighborsPerCluster = 8;
constexpr int givenPerCluster = 6;    ///< given cones that a cluster may join
constexpr int mostRounds = 5;         ///< what a join adds changes with others: neighbours are measured anew
constexpr double volumeWeight = 1e-3; ///< of the cones' own volume, where the sample points see no difference

/// Joins clusters, those first that add least to the volume held: one cone around two may well hold less than theirs did.
class ClusterJoiner
{
public:
  ClusterJoiner(const OccluderParts& mesh, const std::vector<Cone>& given, const ClusterOptions& options,
    std::vector<PartCluster>& clusters)
    : Mesh(mesh)
    , Given(given)
    , Options(options)
    , Clusters(clusters)
    , Sample(options.Region)
  {
    this->Sample.KeepNear(ConesOf(clusters));
    for (PartCluster& cluster : clusters)
    {
      this->Complete(cluster);
      this->Holders.resize(cluster.Points.size(), 0);
      this->CountHolders(cluster.Points, 1);
      this->Added += cluster.Given < 0 ? 1 : 0;
    }
    this->Whole = static_cast<double>(
      this->Holders.size() - std::count(this->Holders.begin(), this->Holders.end(), 0));
  }

  bool Run(const Monitor& monitor)
  {
    for (int round = 0; round < mostRounds; ++round)
    {
      this->FindNeighbors();
      bool joined = false;
      const double begin = static_cast<double>(round) / mostRounds;
      if (!this->JoinNeighbors(monitor.Part(begin, begin + 1.0 / mostRounds), joined))
      {
        return false;
      }
      if (!joined)
      {
        break;
      }
    }
    return true;
  }

private:
  struct Join
  {
    double Cost = 0.0;
    int A = 0;
    int B = 0;

    /// The cheapest comes first in a priority queue.
    bool operator<(const Join& other) const
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost
        : this->A != other.A          ? this->A > other.A
                                      : this->B > other.B;
    }
  };

  static std::vector<Cone> ConesOf(const std::vector<PartCluster>& clusters)
  {
    std::vector<Cone> cones;
    for (const PartCluster& cluster : clusters)
    {
      cones.push_back(cluster.Bound);
    }
    return cones;
  }

  void Complete(PartCluster& cluster) const
  {
    cluster.Points = this->Sample.MaskOf(cluster.Bound);
    cluster.Volume = VolumeIn(this->Options.Region, cluster.Bound);
  }

  void CountHolders(const Mask& mask, int step)
  {
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      this->Holders[i] += step * mask[i];
    }
  }

  /// Points that the joint cone holds and no other does, less those that @p a and @p b alone hold and it does not.
  int Gained(const Mask& joint, const Mask& a, const Mask& b) const
  {
    int gained = 0;
    for (std::size_t i = 0; i < joint.size(); ++i)
    {
      const int others = this->Holders[i] - a[i] - b[i];
      gained += others == 0 ? joint[i] - (a[i] | b[i]) : 0;
    }
    return gained;
  }

  /// Joins of neighbours, as they are now.
  void FindNeighbors()
  {
    this->Queue = {};
    const auto count = static_cast<vtkIdType>(this->Clusters.size());
    std::vector<Vector3> middles;
    for (PartCluster& cluster : this->Clusters)
    {
      middles.push_back(cluster.Middle());
      cluster.Neighbors.clear();
    }
    std::vector<std::vector<Join>> joins(this->Clusters.size());
    ParallelFor(count, {},
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          this->NeighborsOf(static_cast<int>(i), middles, joins[i]);
        }
      });
    for (const auto& some : joins)
    {
      for (const Join& join : some)
      {
        this->Clusters[join.A].Neighbors.push_back(join.B);
        this->Clusters[join.B].Neighbors.push_back(join.A);
        this->Queue.push(join);
      }
    }
  }

  void NeighborsOf(int i, const std::vector<Vector3>& middles, std::vector<Join>& joins) const
  {
    if (this->Clusters[i].Given >= 0 || !this->Clusters[i].Alive)
    {
      return;
    }
    std::vector<std::pair<double, int>> near;
    std::vector<std::pair<double, int>> nearGiven;
    for (std::size_t k = 0; k < this->Clusters.size(); ++k)
    {
      const PartCluster& other = this->Clusters[k];
      if (!other.Alive)
      {
        continue;
      }
      if (other.Given >= 0)
      {
        nearGiven.push_back({ -BoundingCone(other.Bound).Depth(middles[i]), static_cast<int>(k) });
      }
      else if (static_cast<int>(k) != i)
      {
        near.push_back({ Length(middles[k] - middles[i]), static_cast<int>(k) });
      }
    }
    const auto keep = [](std::vector<std::pair<double, int>>& some, int number)
    {
      const auto end = some.begin() + std::min<std::ptrdiff_t>(number, static_cast<std::ptrdiff_t>(some.size()));
      std::partial_sort(some.begin(), end, some.end());
      some.erase(end, some.end());
    };
    keep(near, neighborsPerCluster);
    keep(nearGiven, givenPerCluster);
    near.insert(near.end(), nearGiven.begin(), nearGiven.end());
    for (const auto& other : near)
    {
      Join join{ 0.0, std::min(i, other.second), std::max(i, other.second) };
      PartCluster joint;
      if (this->Measure(join, joint))
      {
        joins.push_back(join);
      }
    }
  }

  /// Join those that add least, until none is worth it or left. @return false where aborted.
  bool JoinNeighbors(const Monitor& monitor, bool& joined)
  {
    const auto start = static_cast<double>(this->Queue.size());
    while (!this->Queue.empty())
    {
      if (monitor.IsAborted())
      {
        return false;
      }
      if (monitor.Progress)
      {
        monitor.Progress(1.0 - std::min(1.0, static_cast<double>(this->Queue.size()) / std::max(1.0, start)));
      }
      Join best = this->Queue.top();
      this->Queue.pop();
      const double old = best.Cost;
      PartCluster joint;
      if (!this->Clusters[best.A].Alive || !this->Clusters[best.B].Alive || !this->Measure(best, joint))
      {
        continue;
      }
      if (best.Cost > old && !this->Queue.empty() && this->Queue.top() < best)
      {
        this->Queue.push(best);
        continue;
      }
      const bool must = this->Added > this->Options.LargestNumber;
      if (!must && best.Cost > this->Options.FreeFraction * this->Whole)
      {
        break;
      }
      this->Take(best, joint);
      joined = true;
    }
    return true;
  }

  /// The joint cone, and what it adds. @return false where there is none.
  bool Measure(Join& join, PartCluster& joint) const
  {
    const PartCluster& a = this->Clusters[join.A];
    const PartCluster& b = this->Clusters[join.B];
    if (a.Given >= 0 && b.Given >= 0)
    {
      return false;
    }
    joint.Held = a.Held;
    joint.Held.insert(joint.Held.end(), b.Held.begin(), b.Held.end());
    KeepOutermost(joint.Held);
    joint.Given = std::max(a.Given, b.Given);
    joint.Occluder = a.Given >= 0 || a.Parts.size() >= b.Parts.size() ? a.Occluder : b.Occluder;
    const Cone* core = joint.Given >= 0 ? &this->Given[joint.Given] : nullptr;
    if (!ConeAround(this->Mesh.LightParts(), joint.Held, core, joint.Bound))
    {
      return false;
    }
    this->Complete(joint);
    join.Cost = this->Gained(joint.Points, a.Points, b.Points) +
      volumeWeight * std::max(0.0, joint.Volume - std::max(a.Volume, b.Volume)) / this->Sample.VolumeOfPoint();
    return true;
  }

  void Take(const Join& join, PartCluster& joint)
  {
    PartCluster& a = this->Clusters[join.A];
    PartCluster& b = this->Clusters[join.B];
    joint.Parts = a.Parts;
    joint.Parts.insert(joint.Parts.end(), b.Parts.begin(), b.Parts.end());
    joint.Neighbors = a.Neighbors;
    joint.Neighbors.insert(joint.Neighbors.end(), b.Neighbors.begin(), b.Neighbors.end());
    std::sort(joint.Neighbors.begin(), joint.Neighbors.end());
    joint.Neighbors.erase(std::unique(joint.Neighbors.begin(), joint.Neighbors.end()), joint.Neighbors.end());
    a.Alive = false;
    b.Alive = false;
    --this->Added;
    if (joint.Given < 0)
    {
      TurnAxis(this->Mesh.LightParts(), joint.Held, this->Options.Region, joint.Bound);
      this->Complete(joint);
    }
    this->CountHolders(a.Points, -1);
    this->CountHolders(b.Points, -1);
    this->CountHolders(joint.Points, 1);
    const auto index = static_cast<int>(this->Clusters.size());
    std::vector<int> neighbors;
    for (const int other : joint.Neighbors)
    {
      if (this->Clusters[other].Alive)
      {
        neighbors.push_back(other);
      }
    }
    joint.Neighbors = neighbors;
    this->Clusters.push_back(std::move(joint));
    for (const int other : neighbors)
    {
      this->Clusters[other].Neighbors.push_back(index);
      Join next{ 0.0, other, index };
      PartCluster unused;
      if (this->Measure(next, unused))
      {
        this->Queue.push(next);
      }
    }
  }

  const OccluderParts& Mesh;
  const std::vector<Cone>& Given;
  const ClusterOptions& Options;
  std::vector<PartCluster>& Clusters;
  VolumeSample Sample;
  std::vector<int> Holders; ///< for each sample point the living clusters whose cones hold it
  int Added = 0;
  double Whole = 0.0;
  std::priority_queue<Join> Queue;
};
} // anonymous namespace

bool JoinClusters(const OccluderParts& mesh, const std::vector<Cone>& given, const ClusterOptions& options,
  const Monitor& monitor, std::vector<PartCluster>& clusters)
{
  return ClusterJoiner(mesh, given, options, clusters).Run(monitor);
}

} // namespace shadowcones
