// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSet.h"

#include "scBasePartition.h"
#include "scConeExpansion.h"
#include "scConeTree.h"
#include "scLeftoverCones.h"
#include "scNearestVectors.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

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
  shadowcones::Cone Cone; ///< where the base holds enough vectors
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
   * Candidates of some seeds are made side by side from the state before them, and taken when it is their turn; one whose
   * neighbours died meanwhile is made again. The result is that of one seed after the other, for any number of threads.
   */
  bool Run(const Monitor& monitor)
  {
    const vtkIdType count = this->Vectors.Count;
    const Monitor quiet{ nullptr, monitor.Aborted };
    std::vector<vtkIdType> seeds;
    std::vector<Candidate> made;
    while (this->Next < count)
    {
      this->Neighbors.Prune();
      this->ChooseSeeds(seeds);
      made.resize(seeds.size());
      const auto body = [&](vtkIdType first, vtkIdType last)
      {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        {
          this->MakeCandidate(seeds[i], made[i]);
        }
      };
      if (!ParallelFor(static_cast<vtkIdType>(seeds.size()), quiet, body))
      {
        return false;
      }
      for (std::size_t i = 0; i < seeds.size(); ++i)
      {
        this->Waiting.emplace(seeds[i], std::move(made[i]));
      }
      this->TakeInTurn();
      if (monitor.Progress)
      {
        monitor.Progress(static_cast<double>(this->Next) / static_cast<double>(count));
      }
    }
    this->Result.NumberOfDiscarded = std::count(this->Result.ConeIds.begin(), this->Result.ConeIds.end(), -1);
    return true;
  }

private:
  Vector3 PointOf(vtkIdType id) const
  {
    return { this->Vectors.Points[3 * id], this->Vectors.Points[3 * id + 1], this->Vectors.Points[3 * id + 2] };
  }

  /**
   * The next seed, and some of those that follow: but for those that lie so near to one before them that its base will
   * hold them. Where it does not, they come later, before any that follows them is taken.
   */
  void ChooseSeeds(std::vector<vtkIdType>& seeds) const
  {
    const vtkIdType count = this->Vectors.Count;
    const vtkIdType most = std::clamp<vtkIdType>(count / (vtkIdType(4) * this->Options.NumberOfNeighbors), 32, 256);
    constexpr vtkIdType looksOfSeed = 4;
    constexpr vtkIdType few = 128; // of more, from many vectors, hardly any two are near
    const double near = this->SumOfRadii / static_cast<double>(std::max<std::size_t>(1, this->Result.Cones.size()));
    std::vector<Vector3> before;
    const auto isNear = [&](const Vector3& point)
    {
      return most <= few &&
        std::any_of(before.begin(), before.end(), [&](const Vector3& other)
          { return Dot(point - other, point - other) < near * near; });
    };
    seeds.clear();
    vtkIdType looks = 0;
    for (vtkIdType id = this->Next;
         id < count && static_cast<vtkIdType>(seeds.size()) < most && looks < looksOfSeed * most; ++id)
    {
      if (this->Covered[id])
      {
        continue;
      }
      looks += 1;
      const Vector3 point = this->PointOf(id);
      if (this->Waiting.count(id) > 0)
      {
        before.push_back(point);
      }
      else if (!isNear(point))
      {
        before.push_back(point);
        seeds.push_back(id);
      }
    }
  }

  void MakeCandidate(vtkIdType seed, Candidate& candidate) const
  {
    this->Neighbors.Query(seed, this->Options.NumberOfNeighbors, candidate.Neighbors);
    PartitionBase(this->Vectors, candidate.Neighbors, this->Options, candidate.Base);
    const std::vector<vtkIdType>& members = candidate.Base.Members;
    if (!this->IsEnough(members))
    {
      return;
    }
    Cone& cone = candidate.Cone;
    cone = {};
    cone.Center = candidate.Base.Center;
    cone.Normal = candidate.Base.Normal;
    cone.VectorCount = static_cast<int>(members.size());
    cone.OccluderId = MajorityOccluder(this->Vectors, members);
    ExpandCone(this->Vectors, members, this->Light, this->Options, candidate.Base.Radius, cone);
    cone.Planarity = cone.BaseRadius > 0.0 ? candidate.Base.RmsHeight / cone.BaseRadius : 0.0;
  }
  bool IsEnough(const std::vector<vtkIdType>& members) const
  {
    return static_cast<int>(members.size()) >= this->Options.MinimumVectorsPerCone;
  }

  /// Take what waits, up to the first seed whose candidate is not there.
  void TakeInTurn()
  {
    for (; this->Next < this->Vectors.Count; ++this->Next)
    {
      const auto waiting = this->Waiting.find(this->Next);
      if (!this->Covered[this->Next])
      {
        if (waiting == this->Waiting.end())
        {
          return;
        }
        this->Take(this->Next, waiting->second);
      }
      if (waiting != this->Waiting.end())
      {
        this->Waiting.erase(waiting);
      }
    }
  }

  void Take(vtkIdType seed, Candidate& candidate)
  {
    if (!this->Options.Overlap &&
      !std::all_of(candidate.Neighbors.begin(), candidate.Neighbors.end(),
        [this](vtkIdType id) { return this->Neighbors.IsAlive(id); }))
    {
      this->MakeCandidate(seed, candidate);
    }
    const std::vector<vtkIdType>& members = candidate.Base.Members;
    if (!this->IsEnough(members))
    {
      return;
    }
    const auto id = static_cast<vtkIdType>(this->Result.Cones.size());
    this->Result.Cones.push_back(candidate.Cone);
    this->SumOfRadii += candidate.Base.Radius;
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
  vtkIdType Next = 0;                 ///< seeds before it had their turn
  std::map<vtkIdType, Candidate> Waiting; ///< of seeds whose turn comes
  double SumOfRadii = 0.0;                ///< of all bases
  ConeSet& Result;
};

/// A photon path through a base disc.
struct Crossing
{
  double Distance; ///< from the disc's centre
  bool Lit;
};

/**
 * The paths through each base disc, in no order. A path is blocked for a disc where it ends before it has passed the disc by a
 * base radius.
 */
bool CollectCrossings(const PhotonPathView& paths, const std::vector<Cone>& cones, const Monitor& monitor,
  std::vector<std::vector<Crossing>>& crossings)
{
  const ConeTree tree = ConeTree::OverBases(cones);
  // Fixed chunks, joined in order: the same for any number of threads.
  constexpr vtkIdType chunk = 512;
  const vtkIdType chunks = (paths.Count + chunk - 1) / chunk;
  std::vector<std::vector<std::pair<int, Crossing>>> found(static_cast<std::size_t>(chunks));
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
        const double distance = Length(origin + t * direction - cone.Center);
        if (slope > 0.0 && distance <= cone.BaseRadius)
        {
          const bool blocked = paths.States[i] != 0 && length <= t + cone.BaseRadius;
          found[i / chunk].push_back({ entry.Cone, { distance, !blocked } });
        }
      });
    }
  });
  crossings.assign(cones.size(), {});
  for (const auto& part : found)
  {
    for (const auto& crossing : part)
    {
      crossings[crossing.first].push_back(crossing.second);
    }
  }
  return finished;
}

/// Cut a base to the largest radius inside which at most @p maximum of the paths are lit.
void TrimBase(std::vector<Crossing>& crossings, double maximum, const LightExtent& light, ConeExpansion expansion,
  double fraction, Cone& cone)
{
  std::size_t kept = 0;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    lit += crossings[i].Lit;
    if (static_cast<double>(lit) <= maximum * static_cast<double>(i + 1))
    {
      kept = i + 1;
    }
  }
  if (kept == crossings.size())
  {
    return;
  }
  crossings.resize(kept);
  const double before = cone.BaseRadius;
  cone.BaseRadius = kept > 0 ? crossings.back().Distance : 0.0;
  cone.Planarity = cone.BaseRadius > 0.0 ? cone.Planarity * before / cone.BaseRadius : 0.0;
  double outer = 0.0;
  PenumbraAngles(light, cone.Center, cone.Axis, cone.BaseRadius, outer, cone.InnerHalfAngle);
  if (expansion == ConeExpansion::LightGeometry)
  {
    cone.HalfAngle = fraction * outer;
  }
}

double LitFraction(const std::vector<Crossing>& crossings)
{
  const auto lit =
    std::count_if(crossings.begin(), crossings.end(), [](const Crossing& crossing) { return crossing.Lit; });
  return crossings.empty() ? 0.0 : static_cast<double>(lit) / static_cast<double>(crossings.size());
}

/// What one light has of some rays, in their order; holds what views point to.
class RaysOfLight
{
public:
  void Add(const ShadowVectorView& vectors, vtkIdType i)
  {
    this->AddRay(vectors.Points, vectors.EmissionPoints, vectors.Directions, i);
    this->Values.push_back(vectors.OccluderIds ? vectors.OccluderIds[i] : 0);
    this->Indices.push_back(i);
  }
  void Add(const PhotonPathView& paths, vtkIdType i)
  {
    this->AddRay(paths.Points, paths.EmissionPoints, paths.Directions, i);
    this->Values.push_back(paths.States[i]);
    this->Indices.push_back(i);
  }
  ShadowVectorView Vectors() const
  {
    return { this->Count(), this->Points.data(), this->Directions.data(),
      this->EmissionPoints.empty() ? nullptr : this->EmissionPoints.data(), this->Values.data(), nullptr };
  }
  PhotonPathView Paths() const
  {
    return { this->Count(), this->Points.data(), this->EmissionPoints.data(), this->Directions.data(),
      this->Values.data(), nullptr };
  }
  vtkIdType Count() const { return static_cast<vtkIdType>(this->Indices.size()); }

  std::vector<vtkIdType> Indices; ///< of the rays among those of all lights

private:
  void AddRay(const double* points, const double* emissionPoints, const float* directions, vtkIdType i)
  {
    this->Points.insert(this->Points.end(), points + 3 * i, points + 3 * i + 3);
    this->Directions.insert(this->Directions.end(), directions + 3 * i, directions + 3 * i + 3);
    if (emissionPoints)
    {
      this->EmissionPoints.insert(this->EmissionPoints.end(), emissionPoints + 3 * i, emissionPoints + 3 * i + 3);
    }
  }

  std::vector<double> Points;
  std::vector<double> EmissionPoints;
  std::vector<float> Directions;
  std::vector<int> Values; ///< occluders of vectors, states of paths
};

template <class View>
std::vector<RaysOfLight> SplitByLight(const View& rays, std::size_t lights, const char* item)
{
  std::vector<RaysOfLight> parts(lights);
  for (vtkIdType i = 0; i < rays.Count; ++i)
  {
    const int light = rays.LightIds ? rays.LightIds[i] : 0;
    if (light < 0 || static_cast<std::size_t>(light) >= lights)
    {
      throw std::invalid_argument("the \"LightId\" of " + std::string(item) + " " + std::to_string(i) + " is " +
        std::to_string(light) + " where there are " + std::to_string(lights) + " lights");
    }
    parts[static_cast<std::size_t>(light)].Add(rays, i);
  }
  return parts;
}

} // anonymous namespace

const char* CheckConeSetOptions(const ConeSetOptions& options)
{
  if (options.NumberOfNeighbors < 3 || options.NumberOfNeighbors > 1000000)
  {
    return "NumberOfNeighbors (p1) must lie in 3..1000000";
  }
  if (options.NumberOfSectors < 1 || options.NumberOfSectors > 65536)
  {
    return "NumberOfSectors (p2) must lie in 1..65536";
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
  if (options.PointsPerRing >= options.NumberOfNeighbors)
  {
    return "PointsPerRing (p3) must be below NumberOfNeighbors (p1): not even one ring could be filled beside the seed";
  }
  const int rings = (options.NumberOfNeighbors - 1) / options.PointsPerRing;
  if (1 + rings * options.PointsPerRing < options.MinimumVectorsPerCone)
  {
    return "MinimumVectorsPerCone (p4) must not be above 1 + PointsPerRing (p3) times the whole rings among "
           "NumberOfNeighbors - 1 (p1): no cone could ever hold enough vectors";
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
  if (options.Leftovers != ConeLeftovers::Discard && options.Leftovers != ConeLeftovers::Cover)
  {
    return "Leftovers must be 0 (Discard) or 1 (Cover)";
  }
  if (!(options.ExpansionFraction >= 0.0 && options.ExpansionFraction <= 1.0))
  {
    return "ExpansionFraction must lie in 0..1";
  }
  if (!(options.MaximumOverspill >= 0.0 && options.MaximumOverspill <= 1.0))
  {
    return "MaximumOverspill must lie in 0..1";
  }
  if (!(options.RadiusScale > 0.0 && std::isfinite(options.RadiusScale)))
  {
    return "RadiusScale must be above 0 and finite";
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
  const double part = paths.Count > 0 ? 0.8 : 1.0;
  if (!fitter.Run(monitor.Part(0.0, part)))
  {
    return false;
  }
  if (options.Leftovers == ConeLeftovers::Cover)
  {
    CoverLeftovers(vectors, light, options, result);
  }
  if (paths.Count == 0)
  {
    return true;
  }
  std::vector<std::vector<Crossing>> crossings;
  if (!CollectCrossings(paths, result.Cones, monitor.Part(part, 1.0), crossings))
  {
    return false;
  }
  const auto insideOut = [](const Crossing& a, const Crossing& b)
  { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Lit < b.Lit; };
  return ParallelFor(static_cast<vtkIdType>(result.Cones.size()), { nullptr, monitor.Aborted },
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        std::sort(crossings[i].begin(), crossings[i].end(), insideOut);
        TrimBase(
          crossings[i], options.MaximumOverspill, light, options.Expansion, options.ExpansionFraction, result.Cones[i]);
        result.Cones[i].Overspill = LitFraction(crossings[i]);
      }
    });
}

bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const std::vector<LightExtent>& lights,
  const ConeSetOptions& options, const Monitor& monitor, ConeSet& result)
{
  if (lights.size() == 1 && !vectors.LightIds && !paths.LightIds)
  {
    return FitConeSet(vectors, paths, lights.front(), options, monitor, result);
  }
  result = {};
  result.ConeIds.assign(static_cast<std::size_t>(vectors.Count), -1);
  if (vectors.Count == 0)
  {
    return true;
  }
  const std::vector<RaysOfLight> vectorsOf = SplitByLight(vectors, lights.size(), "vector");
  const std::vector<RaysOfLight> pathsOf = SplitByLight(paths, lights.size(), "path");
  double done = 0.0;
  for (std::size_t light = 0; light < lights.size(); ++light)
  {
    const RaysOfLight& part = vectorsOf[light];
    const double next = done + static_cast<double>(part.Count()) / std::max<double>(1.0, vectors.Count);
    ConeSet set;
    if (!FitConeSet(
          part.Vectors(), pathsOf[light].Paths(), lights[light], options, monitor.Part(done, std::min(next, 1.0)), set))
    {
      return false;
    }
    done = std::min(next, 1.0);
    const auto first = static_cast<vtkIdType>(result.Cones.size());
    for (Cone& cone : set.Cones)
    {
      cone.LightId = static_cast<int>(light);
      result.Cones.push_back(cone);
    }
    for (std::size_t i = 0; i < set.ConeIds.size(); ++i)
    {
      result.ConeIds[static_cast<std::size_t>(part.Indices[i])] = set.ConeIds[i] < 0 ? -1 : first + set.ConeIds[i];
    }
    result.NumberOfDiscarded += set.NumberOfDiscarded;
  }
  return true;
}

} // namespace shadowcones
