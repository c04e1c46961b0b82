// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSet.h"

#include "scBasePartition.h"
#include "scConeExpansion.h"
#include "scConeTree.h"
#include "scNearestVectors.h"

#include <algorithm>

namespace shadowcones
{
namespace
{

/// Most frequent occluder among the vectors of a cone; the smallest id where several are.
int MajorityOccluder(const ShadowVectorView& vectors, const std::vector<vtkIdType>& ids)
{
  if (!vectors.OccluderIds)
  {
    return 0;
  }
  std::vector<int> occluders;
  for (const vtkIdType id : ids)
  {
    occluders.push_back(vectors.OccluderIds[id]);
  }
  std::sort(occluders.begin(), occluders.end());
  int best = occluders[0];
  std::size_t most = 0;
  for (std::size_t i = 0; i < occluders.size();)
  {
    std::size_t end = i;
    while (end < occluders.size() && occluders[end] == occluders[i])
    {
      ++end;
    }
    if (end - i > most)
    {
      most = end - i;
      best = occluders[i];
    }
    i = end;
  }
  return best;
}

/// A seed's cone, and what it was made from.
struct Candidate
{
  std::vector<vtkIdType> Neighbors; ///< K, nearest first
  BasePartition Base;
};

/// The greedy covering of section 3.2.1: seeds in index order, each covering the vectors inside its base.
class ConeFitter
{
public:
  ConeFitter(const ShadowVectorView& vectors, const LightExtent& light, const ConeSetOptions& options, ConeSet& result)
    : Vectors(vectors)
    , Light(light)
    , Options(options)
    , Neighbors(vectors.Points, vectors.Count)
    , Covered(static_cast<std::size_t>(vectors.Count), 0)
    , Result(result)
  {
  }

  /**
   * Candidates of a batch of seeds are made side by side from the state before the batch, then taken in order; one whose
   * neighbours died meanwhile is made again. The result is that of one seed after the other, for any number of threads.
   */
  bool Run(const Monitor& monitor)
  {
    const vtkIdType count = this->Vectors.Count;
    const vtkIdType batch = std::clamp<vtkIdType>(count / (8 * this->Options.NumberOfNeighbors), 16, 1024);
    std::vector<vtkIdType> seeds;
    std::vector<Candidate> candidates(static_cast<std::size_t>(batch));
    const Monitor quiet{ nullptr, monitor.Aborted };
    for (vtkIdType next = 0; next < count;)
    {
      this->Neighbors.Prune();
      seeds.clear();
      for (; next < count && static_cast<vtkIdType>(seeds.size()) < batch; ++next)
      {
        if (!this->Covered[next])
        {
          seeds.push_back(next);
        }
      }
      const auto body = [&](vtkIdType first, vtkIdType last) {
        for (vtkIdType i = first; i < last; ++i)
        {
          this->MakeCandidate(seeds[i], candidates[i]);
        }
      };
      if (!ParallelFor(static_cast<vtkIdType>(seeds.size()), quiet, body))
      {
        return false;
      }
      for (std::size_t i = 0; i < seeds.size(); ++i)
      {
        this->Take(seeds[i], candidates[i]);
      }
      if (monitor.Progress)
      {
        monitor.Progress(static_cast<double>(next) / static_cast<double>(count));
      }
    }
    this->Result.NumberOfDiscarded = std::count(this->Result.ConeIds.begin(), this->Result.ConeIds.end(), -1);
    return true;
  }

private:
  void MakeCandidate(vtkIdType seed, Candidate& candidate) const
  {
    this->Neighbors.Query(seed, this->Options.NumberOfNeighbors, candidate.Neighbors);
    PartitionBase(this->Vectors, candidate.Neighbors, this->Options, candidate.Base);
  }

  void Take(vtkIdType seed, Candidate& candidate)
  {
    if (this->Covered[seed])
    {
      return;
    }
    if (!this->Options.Overlap &&
      !std::all_of(candidate.Neighbors.begin(), candidate.Neighbors.end(),
        [this](vtkIdType id) { return this->Neighbors.IsAlive(id); }))
    {
      this->MakeCandidate(seed, candidate);
    }
    const std::vector<vtkIdType>& members = candidate.Base.Members;
    if (static_cast<int>(members.size()) < this->Options.MinimumVectorsPerCone)
    {
      return;
    }

    Cone cone;
    cone.Center = candidate.Base.Center;
    cone.Normal = candidate.Base.Normal;
    cone.VectorCount = static_cast<int>(members.size());
    cone.OccluderId = MajorityOccluder(this->Vectors, members);
    ExpandCone(this->Vectors, members, this->Light, this->Options, candidate.Base.Radius, cone);
    cone.Planarity = cone.BaseRadius > 0.0 ? candidate.Base.RmsHeight / cone.BaseRadius : 0.0;

    const auto id = static_cast<vtkIdType>(this->Result.Cones.size());
    this->Result.Cones.push_back(cone);
    for (const vtkIdType member : members)
    {
      this->Covered[member] = 1;
      if (this->Result.ConeIds[member] < 0)
      {
        this->Result.ConeIds[member] = id;
      }
      if (!this->Options.Overlap)
      {
        this->Neighbors.Kill(member);
      }
    }
  }

  const ShadowVectorView& Vectors;
  const LightExtent& Light;
  const ConeSetOptions& Options;
  NearestVectors Neighbors;
  std::vector<unsigned char> Covered; ///< no longer a seed
  ConeSet& Result;
};

/**
 * Share of lit paths among the paths through each base disc. A path is blocked for a disc where it ends before it has
 * passed the disc by a base radius.
 */
bool MeasureOverspill(const PhotonPathView& paths, const Monitor& monitor, std::vector<Cone>& cones)
{
  const ConeTree tree = ConeTree::OverBases(cones);
  std::vector<vtkIdType> lit(cones.size(), 0);
  std::vector<vtkIdType> all(cones.size(), 0);
  // Counts are sums of integers over fixed chunks: the same for any number of threads.
  constexpr vtkIdType chunk = 4096;
  const vtkIdType chunks = (paths.Count + chunk - 1) / chunk;
  using Crossing = std::pair<int, bool>;
  std::vector<std::vector<Crossing>> crossings(static_cast<std::size_t>(chunks));
  const bool finished = ParallelFor(chunks, monitor, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first * chunk; i < std::min(last * chunk, paths.Count); ++i)
    {
      const double* e = paths.EmissionPoints + 3 * i;
      const double* p = paths.Points + 3 * i;
      const float* d = paths.Directions + 3 * i;
      const Vector3 origin{ e[0], e[1], e[2] };
      const Vector3 direction = Normalized({ d[0], d[1], d[2] });
      const double length = Length(Vector3{ p[0], p[1], p[2] } - origin);
      tree.ForEachOnRay(origin, direction, 0.0, HUGE_VAL, [&](const ConeTree::Entry& entry) {
        const Cone& cone = cones[entry.Cone];
        const double slope = Dot(direction, cone.Axis);
        const double t = Dot(cone.Center - origin, cone.Axis) / slope;
        if (slope > 0.0 && Length(origin + t * direction - cone.Center) <= cone.BaseRadius)
        {
          const bool blocked = paths.States[i] != 0 && length <= t + cone.BaseRadius;
          crossings[i / chunk].emplace_back(entry.Cone, !blocked);
        }
      });
    }
  });
  for (const auto& part : crossings)
  {
    for (const Crossing& crossing : part)
    {
      ++all[crossing.first];
      lit[crossing.first] += crossing.second;
    }
  }
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    cones[i].Overspill = all[i] > 0 ? static_cast<double>(lit[i]) / static_cast<double>(all[i]) : 0.0;
  }
  return finished;
}

} // anonymous namespace

const char* CheckConeSetOptions(const ConeSetOptions& options)
{
  if (options.NumberOfNeighbors < 3)
  {
    return "NumberOfNeighbors (p1) must be at least 3";
  }
  if (options.NumberOfSectors < 1)
  {
    return "NumberOfSectors (p2) must be at least 1";
  }
  if (options.PointsPerRing < 1)
  {
    return "PointsPerRing (p3) must be at least 1";
  }
  if (options.MinimumVectorsPerCone < 1)
  {
    return "MinimumVectorsPerCone (p4) must be at least 1";
  }
  if (options.NumberOfNeighbors < options.MinimumVectorsPerCone)
  {
    return "NumberOfNeighbors (p1) must not be below MinimumVectorsPerCone (p4): no cone could ever hold enough vectors";
  }
  if (!(options.VarianceThreshold >= 0.0))
  {
    return "VarianceThreshold must be 0 or more";
  }
  if (!(options.PlanarityThreshold >= 0.0))
  {
    return "PlanarityThreshold must be 0 (no test) or more";
  }
  if (options.Expansion < ConeExpansion::MaximumDeviation || options.Expansion > ConeExpansion::LightGeometry)
  {
    return "Expansion must be 0 (MaximumDeviation), 1 (RadiusRatio) or 2 (LightGeometry)";
  }
  if (!(options.ExpansionFraction >= 0.0 && options.ExpansionFraction <= 1.0))
  {
    return "ExpansionFraction must lie in 0..1";
  }
  if (!(options.RadiusScale > 0.0))
  {
    return "RadiusScale must be above 0";
  }
  return nullptr;
}

bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const LightExtent& light,
  const ConeSetOptions& options, const Monitor& monitor, ConeSet& result)
{
  result = {};
  result.ConeIds.assign(static_cast<std::size_t>(vectors.Count), -1);
  if (vectors.Count == 0)
  {
    return true;
  }
  ConeFitter fitter(vectors, light, options, result);
  const double share = paths.Count > 0 ? 0.8 : 1.0;
  return fitter.Run(monitor.Part(0.0, share)) &&
    (paths.Count == 0 || MeasureOverspill(paths, monitor.Part(share, 1.0), result.Cones));
}

} // namespace shadowcones
