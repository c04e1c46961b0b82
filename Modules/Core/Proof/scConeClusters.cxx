// SPDX-License-Identifier: BSD-3-Clause
#include "scConeClusters.h"

#include "scVolumeSample.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>

namespace shadowcones
{
namespace
{
using Mask = VolumeSample::Mask;

constexpr int mostClusters = 384;       ///< before any join
constexpr std::size_t mostHeld = 40;    ///< points that stand for a cluster while clusters join
constexpr int neighborsPerCluster = 8;
constexpr int givenPerCluster = 6;      ///< given cones that a cluster may join
constexpr double volumeWeight = 1e-3; ///< of the cones' own volume, where the sample points see no difference

/// Volume of a cone from its base to where its axis leaves the region.
double VolumeIn(const Box& region, const Cone& cone)
{
  double begin = 0.0;
  double end = HUGE_VAL;
  const double length = region.Clip(cone.Center, cone.Axis, begin, end) ? end : region.Diagonal();
  const double slope = length * std::tan(cone.HalfAngle);
  return 3.141592653589793 * length * (cone.BaseRadius * (cone.BaseRadius + slope) + slope * slope / 3.0);
}

/// Parts that are to have one cone, or a given cone and parts that it is to hold as well.
struct Cluster
{
  std::vector<int> Parts;
  std::vector<HeldPoint> Held; ///< outermost points of the parts
  int Given = -1;              ///< index of a given cone
  int Occluder = 0;
  Cone Bound;
  Mask Points;
  double Volume = 0.0;
  bool Alive = true;
  std::vector<int> Neighbors;

  Vector3 Middle() const
  {
    Box box;
    for (const HeldPoint& held : this->Held)
    {
      box.Add(held.Point);
    }
    return box.Empty() ? this->Bound.Center : box.Center();
  }
};

/// The points that lie farthest along some directions, for each part of the light.
void KeepOutermost(std::vector<HeldPoint>& points)
{
  if (points.size() <= mostHeld)
  {
    return;
  }
  std::vector<unsigned char> kept(points.size(), 0);
  std::map<int, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    groups[points[i].Part].push_back(i);
  }
  for (const auto& group : groups)
  {
    for (int d = 0; d < 27; ++d)
    {
      const Vector3 along{ d % 3 - 1.0, d / 3 % 3 - 1.0, d / 9 - 1.0 };
      std::size_t best = group.second.front();
      for (const std::size_t i : group.second)
      {
        best = Dot(points[i].Point, along) > Dot(points[best].Point, along) ? i : best;
      }
      kept[best] = 1;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (kept[i])
    {
      points[count++] = points[i];
    }
  }
  points.resize(count);
}

/// Cuts the parts into small clusters by light, occluder and place, the one whose cone is largest first.
class ClusterSplitter
{
public:
  ClusterSplitter(const OccluderParts& mesh, const std::vector<OccluderPart>& parts, const Box& region)
    : Mesh(mesh)
    , Parts(parts)
    , Region(region)
    , Order(parts.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    for (const OccluderPart& part : parts)
    {
      this->Middles.push_back((1.0 / 3.0) * (part.Corners[0] + part.Corners[1] + part.Corners[2]));
    }
  }

  void Run(int number, std::vector<Cluster>& clusters, std::vector<OccluderPart>& withoutCone)
  {
    this->AddGroups(number);
    while (!this->Queue.empty() && static_cast<int>(this->Queue.size() + this->Done.size()) < number)
    {
      this->SplitFirst();
    }
    for (; !this->Queue.empty(); this->Queue.pop())
    {
      this->Done.push_back(this->Queue.top());
    }
    std::sort(this->Done.begin(), this->Done.end(), [](const Range& a, const Range& b) { return a.Begin < b.Begin; });
    for (const Range& range : this->Done)
    {
      this->AddCluster(range, clusters, withoutCone);
    }
  }

private:
  struct Range
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
    Box Middles;
    double Volume = 0.0;

    bool operator<(const Range& other) const
    {
      return this->Volume != other.Volume ? this->Volume < other.Volume : this->Begin > other.Begin;
    }
  };

  int Occluder(int part) const { return this->Mesh.Mesh().OccluderId(this->Parts[part].Triangle); }

  void AddGroups(int number)
  {
    const auto less = [this](bool byOccluder) {
      return [this, byOccluder](int a, int b) {
        const int lightA = this->Parts[a].Light;
        const int lightB = this->Parts[b].Light;
        return lightA != lightB ? lightA < lightB : byOccluder && this->Occluder(a) < this->Occluder(b);
      };
    };
    std::stable_sort(this->Order.begin(), this->Order.end(), less(true));
    const auto addGroups = [&](bool byOccluder) {
      const auto before = less(byOccluder);
      for (std::size_t begin = 0; begin < this->Order.size();)
      {
        std::size_t end = begin + 1;
        while (end < this->Order.size() && !before(this->Order[begin], this->Order[end]))
        {
          ++end;
        }
        this->Push(begin, end);
        begin = end;
      }
    };
    addGroups(true);
    if (static_cast<int>(this->Queue.size()) > number / 4)
    {
      this->Queue = {};
      addGroups(false);
    }
  }

  void Push(std::size_t begin, std::size_t end)
  {
    Range range{ begin, end, {}, 0.0 };
    for (std::size_t i = begin; i < end; ++i)
    {
      range.Middles.Add(this->Middles[this->Order[i]]);
    }
    const LightPart& light = this->Mesh.LightParts()[this->Parts[this->Order[begin]].Light];
    const Vector3 center = range.Middles.Center();
    Cone cone;
    cone.Center = center;
    cone.BaseRadius = 0.5 * range.Middles.Diagonal();
    cone.Axis = light.AtInfinity ? light.Center : Normalized(center - light.Center);
    cone.HalfAngle = light.AtInfinity
      ? std::min(light.Radius, largestProvedAngle)
      : std::min(std::atan2(cone.BaseRadius + light.Radius, Length(center - light.Center)), largestProvedAngle);
    range.Volume = end - begin > 1 && cone.BaseRadius > 0.0 ? VolumeIn(this->Region, cone) : 0.0;
    this->Queue.push(range);
  }

  /// Cut at the middle of the longest side of the box of middles. @return false where all middles are one.
  bool Split(const Range& range, std::size_t& half)
  {
    const Vector3 size = range.Middles.Size();
    const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
    const double middle = range.Middles.Center()[axis];
    const auto at = std::stable_partition(this->Order.begin() + range.Begin, this->Order.begin() + range.End,
      [&](int part) { return this->Middles[part][axis] < middle; });
    half = static_cast<std::size_t>(at - this->Order.begin());
    return half > range.Begin && half < range.End;
  }

  void SplitFirst()
  {
    const Range range = this->Queue.top();
    this->Queue.pop();
    std::size_t half = 0;
    if (range.Volume > 0.0 && this->Split(range, half))
    {
      this->Push(range.Begin, half);
      this->Push(half, range.End);
    }
    else
    {
      this->Done.push_back(range);
    }
  }

  /// A cluster of the range, or of its halves where its cone would be too wide.
  void AddCluster(const Range& range, std::vector<Cluster>& clusters, std::vector<OccluderPart>& withoutCone)
  {
    Cluster cluster;
    cluster.Parts.assign(this->Order.begin() + range.Begin, this->Order.begin() + range.End);
    cluster.Occluder = this->Occluder(cluster.Parts.front());
    for (const int part : cluster.Parts)
    {
      const auto points = this->Mesh.CastingPoints(this->Parts[part]);
      cluster.Held.insert(cluster.Held.end(), points.begin(), points.end());
      if (cluster.Held.size() > 32 * mostHeld)
      {
        KeepOutermost(cluster.Held);
      }
    }
    KeepOutermost(cluster.Held);
    std::size_t half = 0;
    if (ConeAround(this->Mesh.LightParts(), cluster.Held, nullptr, cluster.Bound))
    {
      clusters.push_back(std::move(cluster));
    }
    else if (cluster.Parts.size() == 1)
    {
      withoutCone.push_back(this->Parts[cluster.Parts.front()]);
    }
    else
    {
      half = this->Split(range, half) ? half : range.Begin + (range.End - range.Begin) / 2;
      for (const auto& ends : { std::make_pair(range.Begin, half), std::make_pair(half, range.End) })
      {
        Range part{ ends.first, ends.second, {}, 0.0 };
        for (std::size_t i = part.Begin; i < part.End; ++i)
        {
          part.Middles.Add(this->Middles[this->Order[i]]);
        }
        this->AddCluster(part, clusters, withoutCone);
      }
    }
  }

  const OccluderParts& Mesh;
  const std::vector<OccluderPart>& Parts;
  const Box& Region;
  std::vector<int> Order;
  std::vector<Vector3> Middles;
  std::priority_queue<Range> Queue;
  std::vector<Range> Done;
};

/// Joins clusters, those first that add least to the volume held.
class ClusterJoiner
{
public:
  ClusterJoiner(const OccluderParts& mesh, const std::vector<Cone>& given, const ClusterOptions& options,
    std::vector<Cluster>& clusters)
    : Mesh(mesh)
    , Given(given)
    , Options(options)
    , Clusters(clusters)
    , Sample(options.Region)
  {
    this->Sample.KeepNear(ConesOf(clusters));
    this->Union = this->Sample.MaskOf(clusters.front().Bound);
    for (Cluster& cluster : clusters)
    {
      this->Complete(cluster);
      this->AddToUnion(cluster.Points);
      this->Added += cluster.Given < 0 ? 1 : 0;
    }
    this->Whole = CountBeyond(this->Union, Mask(this->Union.size(), 0));
    this->FindNeighbors();
  }

  bool Run(const Monitor& monitor)
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
      if (!this->Clusters[best.A].Alive || !this->Clusters[best.B].Alive)
      {
        continue;
      }
      const double old = best.Cost;
      Cluster joint;
      if (!this->Measure(best, joint))
      {
        continue;
      }
      if (best.Cost > old && !this->Queue.empty() && this->Queue.top() < best)
      {
        this->Queue.push(best);
        continue;
      }
      const bool must = this->Added > this->Options.LargestNumber;
      if (!must && best.Cost > this->Options.FreeShare * this->Whole)
      {
        break;
      }
      this->Take(best, joint);
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
                                      : this->A != other.A ? this->A > other.A : this->B > other.B;
    }
  };

  static std::vector<Cone> ConesOf(const std::vector<Cluster>& clusters)
  {
    std::vector<Cone> cones;
    for (const Cluster& cluster : clusters)
    {
      cones.push_back(cluster.Bound);
    }
    return cones;
  }

  void Complete(Cluster& cluster) const
  {
    cluster.Points = this->Sample.MaskOf(cluster.Bound);
    cluster.Volume = VolumeIn(this->Options.Region, cluster.Bound);
  }

  void AddToUnion(const Mask& mask)
  {
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      this->Union[i] |= mask[i];
    }
  }

  void FindNeighbors()
  {
    const auto count = static_cast<vtkIdType>(this->Clusters.size());
    std::vector<Vector3> middles;
    for (const Cluster& cluster : this->Clusters)
    {
      middles.push_back(cluster.Middle());
    }
    std::vector<std::vector<Join>> joins(this->Clusters.size());
    ParallelFor(count, {}, [&](vtkIdType first, vtkIdType last) {
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
    if (this->Clusters[i].Given >= 0)
    {
      return;
    }
    std::vector<std::pair<double, int>> near;
    std::vector<std::pair<double, int>> nearGiven;
    for (std::size_t k = 0; k < this->Clusters.size(); ++k)
    {
      const Cluster& other = this->Clusters[k];
      if (other.Given >= 0)
      {
        nearGiven.push_back({ -BoundingCone(other.Bound).Depth(middles[i]), static_cast<int>(k) });
      }
      else if (static_cast<int>(k) != i)
      {
        near.push_back({ Length(middles[k] - middles[i]), static_cast<int>(k) });
      }
    }
    const auto keep = [](std::vector<std::pair<double, int>>& some, int number) {
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
      Cluster joint;
      if (this->Measure(join, joint))
      {
        joins.push_back(join);
      }
    }
  }

  /// The joint cone, and what it adds. @return false where there is none.
  bool Measure(Join& join, Cluster& joint) const
  {
    const Cluster& a = this->Clusters[join.A];
    const Cluster& b = this->Clusters[join.B];
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
    join.Cost = CountBeyond(joint.Points, this->Union) +
      volumeWeight * std::max(0.0, joint.Volume - std::max(a.Volume, b.Volume)) / this->Sample.VolumeOfPoint();
    return true;
  }

  void Take(const Join& join, Cluster& joint)
  {
    Cluster& a = this->Clusters[join.A];
    Cluster& b = this->Clusters[join.B];
    joint.Parts = a.Parts;
    joint.Parts.insert(joint.Parts.end(), b.Parts.begin(), b.Parts.end());
    joint.Neighbors = a.Neighbors;
    joint.Neighbors.insert(joint.Neighbors.end(), b.Neighbors.begin(), b.Neighbors.end());
    std::sort(joint.Neighbors.begin(), joint.Neighbors.end());
    joint.Neighbors.erase(std::unique(joint.Neighbors.begin(), joint.Neighbors.end()), joint.Neighbors.end());
    a.Alive = false;
    b.Alive = false;
    --this->Added;
    this->AddToUnion(joint.Points);
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
      Cluster unused;
      if (this->Measure(next, unused))
      {
        this->Queue.push(next);
      }
    }
  }

  const OccluderParts& Mesh;
  const std::vector<Cone>& Given;
  const ClusterOptions& Options;
  std::vector<Cluster>& Clusters;
  VolumeSample Sample;
  Mask Union;
  int Added = 0;
  double Whole = 0.0;
  std::priority_queue<Join> Queue;
};

/// The final cone of a cluster, around all points of all its parts.
void Finish(const OccluderParts& mesh, const std::vector<OccluderPart>& parts, const std::vector<Cone>& given,
  Cluster& cluster)
{
  cluster.Held.clear();
  for (const int part : cluster.Parts)
  {
    const auto points = mesh.CastingPoints(parts[part]);
    cluster.Held.insert(cluster.Held.end(), points.begin(), points.end());
  }
  const Cone* core = cluster.Given >= 0 ? &given[cluster.Given] : nullptr;
  cluster.Alive = ConeAround(mesh.LightParts(), cluster.Held, core, cluster.Bound);
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
  std::vector<Cluster> clusters;
  ClusterSplitter(mesh, parts, options.Region).Run(mostClusters, clusters, result.WithoutCone);
  if (clusters.empty())
  {
    return true;
  }
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    Cluster cluster;
    cluster.Given = static_cast<int>(i);
    cluster.Occluder = given[i].OccluderId;
    cluster.Bound = given[i];
    clusters.push_back(cluster);
  }
  if (!ClusterJoiner(mesh, given, options, clusters).Run(monitor.Part(0.1, 0.9)))
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
    Cluster& cluster = clusters[i];
    if (!cluster.Alive)
    {
      for (const int part : cluster.Parts)
      {
        result.WithoutCone.push_back(parts[part]);
      }
      continue;
    }
    cluster.Bound.OccluderId = cluster.Occluder;
    if (cluster.Given >= 0)
    {
      Cone grown = given[cluster.Given];
      grown.Center = cluster.Bound.Center;
      grown.Axis = cluster.Bound.Axis;
      grown.BaseRadius = cluster.Bound.BaseRadius;
      grown.HalfAngle = cluster.Bound.HalfAngle;
      result.Cones[cluster.Given] = grown;
      result.Grown[cluster.Given] = 1;
    }
    else
    {
      result.Cones.push_back(cluster.Bound);
    }
  }
  return finished;
}

} // namespace shadowcones
