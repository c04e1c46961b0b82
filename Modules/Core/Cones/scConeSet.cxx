// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSet.h"

#include "scBasePartition.h"
#include "scConeExpansion.h"
#include "scConeTree.h"
#include "scLeftoverCones.h"
#include "scNearestVectors.h"
#include "scSeedCovering.h"

#include <algorithm>
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

/// The candidate of a seed among its nearest living neighbours.
void MakeCandidate(const ShadowVectorView& vectors, const LightExtent& light, const ConeSetOptions& options,
  const NearestVectors& tree, vtkIdType seed, ConeCandidate& candidate)
{
  thread_local BasePartition base;
  thread_local std::vector<vtkIdType> neighbors;
  tree.Query(seed, options.NumberOfNeighbors, neighbors);
  PartitionBase(vectors, neighbors, options, base);
  candidate.Neighbors.clear();
  candidate.Members.clear();
  if (!options.Overlap)
  {
    candidate.Neighbors = neighbors;
  }
  if (static_cast<int>(base.Members.size()) < options.MinimumVectorsPerCone)
  {
    return;
  }
  candidate.Members = base.Members;
  candidate.Radius = base.Radius;
  Cone& cone = candidate.Cone;
  cone = {};
  cone.Center = base.Center;
  cone.Normal = base.Normal;
  cone.VectorCount = static_cast<int>(base.Members.size());
  cone.OccluderId = MajorityOccluder(vectors, base.Members);
  ExpandCone(vectors, base.Members, light, options, base.Radius, cone);
  cone.Planarity = cone.BaseRadius > 0.0 ? base.RmsHeight / cone.BaseRadius : 0.0;
}

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

/// Trim the bases, and note which share of the paths through each is lit. Processes of a team have some cones each.
bool MeasureBases(const PhotonPathView& paths, const LightExtent& light, const ConeSetOptions& options,
  const Monitor& monitor, Team* workers, std::vector<Cone>& cones)
{
  const auto insideOut = [](const Crossing& a, const Crossing& b)
  { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Lit < b.Lit; };
  const TeamShare share(workers, static_cast<vtkIdType>(cones.size()));
  TeamJoin join(workers);
  join.AddItems(cones, share);
  const auto measureOwn = [&]
  {
    std::vector<Cone> own;
    for (vtkIdType k = 0; k < share.Own(); ++k)
    {
      own.push_back(cones[static_cast<std::size_t>(share.Item(k))]);
    }
    std::vector<std::vector<Crossing>> crossings;
    if (!CollectCrossings(paths, own, monitor, crossings))
    {
      return false;
    }
    const auto measure = [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      {
        std::sort(crossings[k].begin(), crossings[k].end(), insideOut);
        TrimBase(crossings[k], options.MaximumOverspill, light, options.Expansion, options.ExpansionFraction, own[k]);
        own[k].Overspill = LitFraction(crossings[k]);
        cones[static_cast<std::size_t>(share.Item(static_cast<vtkIdType>(k)))] = own[k];
      }
    };
    return ParallelFor(share.Own(), { nullptr, monitor.Aborted }, measure);
  };
  return join.Run(measureOwn);
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
  const ConeSetOptions& options, const Monitor& monitor, ConeSet& result, Team* workers)
{
  result = {};
  result.ConeIds.assign(static_cast<std::size_t>(vectors.Count), -1);
  if (vectors.Count == 0)
  {
    return true;
  }
  const double part = paths.Count > 0 ? 0.8 : 1.0;
  NearestVectors tree(vectors.Points, vectors.Count);
  const CandidateMaker make = [&](vtkIdType seed, ConeCandidate& candidate)
  { MakeCandidate(vectors, light, options, tree, seed, candidate); };
  SeedCovering covering(vectors.Points, make, options.Overlap ? nullptr : &tree, workers, result);
  if (!covering.Run(monitor.Part(0.0, part)))
  {
    return false;
  }
  if (options.Leftovers == ConeLeftovers::Cover &&
    !CoverLeftovers(vectors, light, options, { nullptr, monitor.Aborted }, workers, result))
  {
    return false;
  }
  result.NumberOfDiscarded = std::count(result.ConeIds.begin(), result.ConeIds.end(), -1);
  return paths.Count == 0 || MeasureBases(paths, light, options, monitor.Part(part, 1.0), workers, result.Cones);
}

bool FitConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const std::vector<LightExtent>& lights,
  const ConeSetOptions& options, const Monitor& monitor, ConeSet& result, Team* workers)
{
  if (lights.size() == 1 && !vectors.LightIds && !paths.LightIds)
  {
    return FitConeSet(vectors, paths, lights.front(), options, monitor, result, workers);
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
    const Monitor ofLight = monitor.Part(done, std::min(next, 1.0));
    if (!FitConeSet(part.Vectors(), pathsOf[light].Paths(), lights[light], options, ofLight, set, workers))
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
