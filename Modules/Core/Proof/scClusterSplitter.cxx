// SPDX-License-Identifier: BSD-3-Clause
#include "scClusterSplitter.h"

#include "scParallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <queue>
#include <utility>

namespace shadowcones
{
namespace
{
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
    this->Middles.reserve(parts.size());
    for (const OccluderPart& part : parts)
    {
      this->Middles.push_back((1.0 / 3.0) * (part.Corners[0] + part.Corners[1] + part.Corners[2]));
    }
  }

  void Run(int number, std::vector<PartCluster>& clusters, std::vector<OccluderPart>& withoutCone)
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
    // Ranges are cut further each by itself.
    std::vector<std::vector<PartCluster>> found(this->Done.size());
    std::vector<std::vector<OccluderPart>> without(this->Done.size());
    ParallelFor(static_cast<vtkIdType>(this->Done.size()), {},
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          this->AddCluster(this->Done[i], found[i], without[i]);
        }
      });
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      std::move(found[i].begin(), found[i].end(), std::back_inserter(clusters));
      withoutCone.insert(withoutCone.end(), without[i].begin(), without[i].end());
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
    const auto less = [this](bool byOccluder)
    {
      return [this, byOccluder](int a, int b)
      {
        const int lightA = this->Parts[a].Light;
        const int lightB = this->Parts[b].Light;
        return lightA != lightB ? lightA < lightB : byOccluder && this->Occluder(a) < this->Occluder(b);
      };
    };
    std::stable_sort(this->Order.begin(), this->Order.end(), less(true));
    const auto addGroups = [&](bool byOccluder)
    {
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
  void AddCluster(const Range& range, std::vector<PartCluster>& clusters, std::vector<OccluderPart>& withoutCone)
  {
    PartCluster cluster;
    cluster.Parts.assign(this->Order.begin() + range.Begin, this->Order.begin() + range.End);
    cluster.Occluder = this->Occluder(cluster.Parts.front());
    for (const int part : cluster.Parts)
    {
      const auto points = this->Mesh.CastingPoints(this->Parts[part]);
      cluster.Held.insert(cluster.Held.end(), points.begin(), points.end());
      if (cluster.Held.size() > 32 * mostHeldPoints)
      {
        KeepOutermost(cluster.Held);
      }
    }
    KeepOutermost(cluster.Held);
    cluster.Held.shrink_to_fit(); // few are left of many
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
} // anonymous namespace

std::vector<PartCluster> SplitIntoClusters(const OccluderParts& mesh, const std::vector<OccluderPart>& parts,
  const Box& region, int number, std::vector<OccluderPart>& withoutCone)
{
  std::vector<PartCluster> clusters;
  ClusterSplitter(mesh, parts, region).Run(number, clusters, withoutCone);
  return clusters;
}

} // namespace shadowcones
