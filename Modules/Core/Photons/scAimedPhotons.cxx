// SPDX-License-Identifier: BSD-3-Clause
#include "scAimedPhotons.h"

#include "scScarceOccluders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shadowcones
{
namespace
{
/// Photons of a bundle from here on have other random numbers.
constexpr vtkIdType otherPhotons = vtkIdType(1) << 32;

/// A bundle aimed at scarce occluders, and what its photons found.
struct AimedBundle
{
  std::size_t Bundle = 0;
  std::vector<int> Ids;
  vtkIdType MostPhotons = 0;
  vtkIdType Photons = 0;
  std::vector<vtkIdType> Vectors; ///< of each id
  ShadowVectorResult Found;
  std::array<vtkIdType, numberOfPhotonItems> Items{}; ///< that were found
  double SolidAngle = 0.0;

  vtkIdType Fewest() const { return *std::min_element(this->Vectors.begin(), this->Vectors.end()); }
  vtkIdType Most() const { return *std::max_element(this->Vectors.begin(), this->Vectors.end()); }
  /// Trace more photons, and count the vectors of the occluders it is aimed at.
  void Trace(const PhotonTracing& tracing, vtkIdType first, vtkIdType more)
  {
    const std::size_t before = this->Found.Vectors.OccluderIds.size();
    for (vtkIdType k = this->Photons; k < this->Photons + more; ++k)
    {
      tracing.Trace({ this->Bundle, first + k }, k, this->Found);
    }
    this->Photons += more;
    const std::vector<int>& ids = this->Found.Vectors.OccluderIds;
    for (std::size_t i = before; i < ids.size(); ++i)
    {
      const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), ids[i]);
      if (found != this->Ids.end() && *found == ids[i])
      {
        ++this->Vectors[static_cast<std::size_t>(found - this->Ids.begin())];
      }
    }
  }
  /// Take note of what was found, which may go elsewhere then.
  void CountItems()
  {
    this->Items = { static_cast<vtkIdType>(this->Found.Vectors.PhotonIndices.size()),
      static_cast<vtkIdType>(this->Found.Paths.PhotonIndices.size()),
      static_cast<vtkIdType>(this->Found.Photons.PhotonIndices.size()) };
    this->SolidAngle = this->Found.MeanSolidAngle;
    this->Found.MeanSolidAngle = 0.0;
  }
  /// Forget what was found.
  void Restart()
  {
    this->Photons = 0;
    this->Vectors.assign(this->Ids.size(), 0);
    this->Found = {};
  }
};

/// Which occluders would have too few vectors, and how many each is to have.
class ScarcityGoal
{
public:
  ScarcityGoal(const CasterBoxes& casters, std::size_t lights, const ShadowVectorOptions& options)
    : Casters(casters)
    , Lights(lights)
    , Options(options)
    , InPhotons(options.TargetNumberOfVectors <= 0)
    , Wanted(InPhotons ? options.NumberOfPhotons / 2 : options.TargetNumberOfVectors)
  {
    const auto pairs = static_cast<vtkIdType>(casters.Ids.size() * lights);
    this->EvenShare = pairs > 0 ? (this->Wanted + pairs - 1) / pairs : 0;
    this->Vectors = this->Asked();
  }

  /// Vectors below which an occluder has too few, even where all share evenly and are to have more.
  vtkIdType Asked() const
  {
    return std::min<vtkIdType>(this->Options.MinimumVectorsPerOccluder, this->EvenShare);
  }
  bool IsAsked() const { return this->Vectors > 0 && this->Casters.Ids.size() > 1; }
  vtkIdType PilotPhotons() const
  {
    constexpr vtkIdType fewest = 1024;
    constexpr vtkIdType most = 8192;
    return std::clamp(this->Wanted / 4, fewest, most);
  }

  /**
   * For each light, for each caster: are its photons scarce? The more are aimed at, the fewer photons are left for the others.
   * Where these would hardly meet an occluder any more all are aimed at, and share all evenly.
   */
  std::vector<std::vector<bool>> FindScarce(const ShadowVectorResult& pilot)
  {
    constexpr double poorYield = 0.05; // vectors a photon
    const std::vector<std::vector<double>> counts = this->CountVectors(pilot);
    const auto photons = static_cast<double>(this->PilotPhotons());
    const auto vectors = static_cast<double>(pilot.Vectors.OccluderIds.size());
    std::vector<std::vector<bool>> scarce(this->Lights, std::vector<bool>(this->Casters.Ids.size(), false));
    double left = vectors; // of the pilot's, of occluders that are not aimed at
    for (bool more = true; more && !this->IsPoor;)
    {
      const double scale = this->InPhotons ? 0.5 * static_cast<double>(this->Options.NumberOfPhotons) / photons
                                           : static_cast<double>(this->OfOthers()) / std::max(left, 1.0);
      more = false;
      for (std::size_t light = 0; light < this->Lights; ++light)
      {
        for (std::size_t k = 0; k < counts[light].size(); ++k)
        {
          if (!scarce[light][k] && scale * counts[light][k] < 2.0 * this->Safe())
          {
            scarce[light][k] = true;
            left -= counts[light][k];
            ++this->NumberOfScarce;
            more = true;
          }
        }
      }
      this->IsPoor = this->OfOthers() > 0 && left < poorYield * photons;
    }
    if (this->IsPoor)
    {
      this->Vectors = this->EvenShare;
      this->NumberOfScarce = static_cast<vtkIdType>(this->Lights * this->Casters.Ids.size());
      scarce.assign(this->Lights, std::vector<bool>(this->Casters.Ids.size(), true));
    }
    for (std::size_t light = 0; this->NumberOfScarce > 0 && light < this->Lights; ++light)
    {
      for (std::size_t k = 0; k < counts[light].size(); ++k)
      {
        const double needed = scarce[light][k] ? 0.0 : this->Safe() * left / counts[light][k];
        this->LeastOfOthers = std::max(this->LeastOfOthers, static_cast<vtkIdType>(std::ceil(needed)));
      }
    }
    return scarce;
  }

  /// Vectors that photons of the lights' own bundles would have to give, beside what is needed of the aimed ones.
  vtkIdType OfOthers() const { return std::max(this->Wanted - this->Vectors * this->NumberOfScarce, vtkIdType(0)); }
  /// Vectors that these must give at least, for occluders that are not aimed at.
  vtkIdType GetLeastOfOthers() const { return this->LeastOfOthers; }
  bool IsReached(const AimedBundle& bundle, vtkIdType vectors) const
  {
    constexpr vtkIdType plenty = 3; // times what all of a group need, where one of them is hard to meet
    const vtkIdType all = std::accumulate(bundle.Vectors.begin(), bundle.Vectors.end(), vtkIdType(0));
    return bundle.Fewest() >= vectors ||
      (bundle.Ids.size() > 1 && all >= plenty * vectors * static_cast<vtkIdType>(bundle.Ids.size()));
  }

  /// Photons that one of so many bundles may have, for so many occluders.
  vtkIdType MostPhotons(std::size_t bundles, std::size_t occluders) const
  {
    const vtkIdType enough = photonsPerVector * this->Vectors * static_cast<vtkIdType>(occluders);
    const vtkIdType all = this->IsPoor ? this->Options.NumberOfPhotons / 10 * 9 : this->Options.NumberOfPhotons / 2;
    return this->InPhotons ? std::min(enough, all / static_cast<vtkIdType>(bundles)) : enough;
  }

  /**
   * NumberOfPhotons of which a bundle, one of so many, would have enough for all that it is asked for, as far as its photons
   * tell; 0: it would give up before, or vectors and not photons were asked for.
   */
  vtkIdType PhotonsFor(const AimedBundle& bundle, std::size_t bundles) const
  {
    // Few vectors tell it: there may be fewer the next time.
    const auto few = static_cast<double>(bundle.Fewest());
    const double sure = 0.8 * std::max(few - std::sqrt(few), 0.4 * few);
    const auto asked = static_cast<double>(this->Options.MinimumVectorsPerOccluder);
    const double own = asked * static_cast<double>(bundle.Photons) / sure;
    const double most = static_cast<double>(photonsPerVector) * asked * static_cast<double>(bundle.Ids.size());
    return this->InPhotons && own <= most ? static_cast<vtkIdType>(std::ceil(2.0 * own * static_cast<double>(bundles))) : 0;
  }

  vtkIdType Vectors = 0; ///< that each occluder is to have of each light

private:
  static constexpr vtkIdType photonsPerVector = 256; ///< a bundle gives up beyond

  /// Expected vectors that are hardly ever fewer than the wanted ones.
  double Safe() const
  {
    const auto wanted = static_cast<double>(this->Vectors);
    return wanted + 4.0 * std::sqrt(wanted) + 4.0;
  }
  /// For each light, of each caster.
  std::vector<std::vector<double>> CountVectors(const ShadowVectorResult& pilot) const
  {
    std::vector<std::vector<double>> counts(this->Lights, std::vector<double>(this->Casters.Ids.size(), 0.0));
    const std::vector<int>& ids = pilot.Vectors.OccluderIds;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const auto found = std::lower_bound(this->Casters.Ids.begin(), this->Casters.Ids.end(), ids[i]);
      counts[static_cast<std::size_t>(pilot.Vectors.LightIds[i])]
            [static_cast<std::size_t>(found - this->Casters.Ids.begin())] += 1.0;
    }
    return counts;
  }

  const CasterBoxes& Casters;
  std::size_t Lights;
  const ShadowVectorOptions& Options;
  bool InPhotons;
  vtkIdType Wanted; ///< vectors
  vtkIdType EvenShare = 0;
  vtkIdType NumberOfScarce = 0;
  vtkIdType LeastOfOthers = 0;
  bool IsPoor = false;
};

/// Which bundles a process has.
using BundleDeal = std::vector<std::vector<std::size_t>>;

/// In turn: nobody knows yet how many photons each takes.
BundleDeal DealInTurn(const Team* team, std::size_t count)
{
  BundleDeal deal(static_cast<std::size_t>(team ? team->GetSize() : 1));
  for (std::size_t k = 0; k < count; ++k)
  {
    deal[k % deal.size()].push_back(k);
  }
  return deal;
}

/// Ranges of about as much work each, so that what each process finds joins in order.
BundleDeal DealInRanges(const Team* team, const std::vector<AimedBundle>& aimed, const PhotonBundles& bundles)
{
  BundleDeal deal(static_cast<std::size_t>(team ? team->GetSize() : 1));
  std::vector<double> ends;
  for (std::size_t k = 0; k < aimed.size(); ++k)
  {
    ends.push_back((ends.empty() ? 0.0 : ends.back()) + static_cast<double>(bundles.PhotonsOf(aimed[k].Bundle)));
  }
  for (std::size_t k = 0; k < aimed.size(); ++k)
  {
    const double middle = 0.5 * (ends[k] + (k > 0 ? ends[k - 1] : 0.0));
    const double rank = ends.back() > 0.0 ? middle / ends.back() * static_cast<double>(deal.size()) : 0.0;
    deal[std::min(static_cast<std::size_t>(rank), deal.size() - 1)].push_back(k);
  }
  return deal;
}

/// What is known of each bundle behind its photons, to be sent to the others.
struct BundleNumbers
{
  std::vector<vtkIdType> Photons;
  std::vector<vtkIdType> Vectors;
  std::vector<vtkIdType> Items; ///< that were found: of vectors, paths and shadow photons
  std::vector<double> SolidAngles;

  void Add(TeamJoin& join)
  {
    join.Add(this->Photons);
    join.Add(this->Vectors);
    join.Add(this->Items);
    join.Add(this->SolidAngles);
  }
  void Pack(const AimedBundle& bundle)
  {
    this->Photons.push_back(bundle.Photons);
    this->Vectors.insert(this->Vectors.end(), bundle.Vectors.begin(), bundle.Vectors.end());
    this->Items.insert(this->Items.end(), bundle.Items.begin(), bundle.Items.end());
    this->SolidAngles.push_back(bundle.SolidAngle);
  }
  void Unpack(std::vector<AimedBundle>& aimed, const BundleDeal& deal) const
  {
    std::size_t bundle = 0;
    std::size_t vector = 0;
    for (const std::vector<std::size_t>& ofRank : deal)
    {
      for (const std::size_t k : ofRank)
      {
        aimed[k].Photons = this->Photons[bundle];
        aimed[k].SolidAngle = this->SolidAngles[bundle];
        const auto items = this->Items.begin() + static_cast<std::ptrdiff_t>(numberOfPhotonItems * bundle);
        std::copy(items, items + numberOfPhotonItems, aimed[k].Items.begin());
        ++bundle;
        for (vtkIdType& vectors : aimed[k].Vectors)
        {
          vectors = this->Vectors[vector++];
        }
      }
    }
  }
};

/**
 * Run @p body for each bundle, each process its own. Then all know of all how many photons and vectors they have, and
 * @p result, where there is one, has what was found, in order. @return false where aborted.
 */
template <typename Body>
bool ForEachBundle(std::vector<AimedBundle>& aimed, Team* team, const BundleDeal& deal, ShadowVectorResult* result,
  const Monitor& monitor, const Body& body)
{
  const bool several = AreSeveral(team);
  const std::vector<std::size_t>& own = deal[static_cast<std::size_t>(several ? team->GetRank() : 0)];
  BundleNumbers numbers;
  ShadowVectorResult found;
  TeamJoin join(team);
  numbers.Add(join);
  if (result)
  {
    AddPhotons(join, found, *result);
  }
  const auto work = [&]
  {
    const bool done = ParallelFor(static_cast<vtkIdType>(own.size()), monitor,
      [&](vtkIdType first, vtkIdType last)
      { std::for_each(own.begin() + first, own.begin() + last, [&](std::size_t k) { body(aimed[k]); }); });
    std::vector<ShadowVectorResult*> ranges;
    for (const std::size_t k : own)
    {
      aimed[k].CountItems();
      numbers.Pack(aimed[k]);
      ranges.push_back(&aimed[k].Found);
      if (several)
      {
        team->Count(aimed[k].Photons);
      }
    }
    if (done && result)
    {
      AppendAll(several ? found : *result, ranges);
    }
    if (done && result && several)
    {
      MakeRoomForAll(*team, found, *result);
    }
    return done;
  };
  if (!join.Run(work))
  {
    return false;
  }
  numbers.Unpack(aimed, deal);
  return true;
}

/// A bundle for each box around scarce occluders.
std::vector<AimedBundle> MakeBundles(const CasterBoxes& casters, const std::vector<std::vector<bool>>& scarce,
  const ScarcityGoal& goal, PhotonBundles& bundles)
{
  constexpr std::size_t mostOfLight = 256;
  std::vector<AimedBundle> aimed;
  for (std::size_t light = 0; light < scarce.size(); ++light)
  {
    std::vector<Box> boxes;
    for (const ScarceOccluders& group : BoxesToAimAt(casters, scarce[light], mostOfLight))
    {
      aimed.emplace_back();
      aimed.back().Bundle = bundles.NumberOfBundles() + boxes.size();
      aimed.back().Ids = group.Ids;
      boxes.push_back(group.Bounds);
    }
    bundles.Aim(static_cast<int>(light), boxes);
  }
  for (AimedBundle& bundle : aimed)
  {
    bundles.SetPhotons(bundle.Bundle, 1); // it has its paths from now on
    bundle.MostPhotons = goal.MostPhotons(aimed.size(), bundle.Ids.size());
    bundle.Restart();
  }
  return aimed;
}

/// Number what the bundles found, which lies there one behind the other.
void NumberPhotons(const std::vector<AimedBundle>& aimed, PhotonBundles& bundles, ShadowVectorResult& result)
{
  std::vector<vtkIdType>* const all[numberOfPhotonItems] = { &result.Vectors.PhotonIndices, &result.Paths.PhotonIndices,
    &result.Photons.PhotonIndices };
  std::size_t done[numberOfPhotonItems] = { 0, 0, 0 };
  for (const AimedBundle& bundle : aimed)
  {
    bundles.SetPhotons(bundle.Bundle, bundle.Photons);
    const vtkIdType first = bundles.FirstPhoton(bundle.Bundle);
    for (std::size_t item = 0; item < numberOfPhotonItems; ++item)
    {
      const auto from = all[item]->begin() + static_cast<std::ptrdiff_t>(done[item]);
      std::for_each(from, from + bundle.Items[item], [first](vtkIdType& index) { index += first; });
      done[item] += static_cast<std::size_t>(bundle.Items[item]);
    }
    result.NumberOfScarce += std::count_if(bundle.Vectors.begin(), bundle.Vectors.end(),
      [&](vtkIdType vectors) { return vectors > 0 && vectors < result.MinimumVectors; });
  }
}
} // anonymous namespace

bool TraceAimedPhotons(const PhotonTracing& tracing, const TriangleMeshView& mesh, std::size_t lights,
  const ShadowVectorOptions& options, const Monitor& monitor, ShadowVectorResult& result, vtkIdType& ofOthers)
{
  const CasterBoxes casters = BoxesOfCasters(mesh);
  ScarcityGoal goal(casters, lights, options);
  if (!goal.IsAsked())
  {
    return true;
  }
  ShadowVectorResult pilot;
  if (!tracing.TraceRange(otherPhotons, otherPhotons + goal.PilotPhotons(), monitor.Part(0.0, 0.1), pilot))
  {
    return false;
  }
  const std::vector<std::vector<bool>> scarce = goal.FindScarce(pilot);
  std::vector<AimedBundle> aimed = MakeBundles(casters, scarce, goal, tracing.Bundles);
  const vtkIdType batch = std::clamp<vtkIdType>(goal.Vectors, 8, 64);
  const auto traceUntil = [&](AimedBundle& bundle, vtkIdType first, vtkIdType vectors)
  {
    while (!goal.IsReached(bundle, vectors) && bundle.Photons < bundle.MostPhotons)
    {
      bundle.Trace(tracing, first, std::min(batch, bundle.MostPhotons - bundle.Photons));
    }
  };
  if (!ForEachBundle(aimed, tracing.Workers, DealInTurn(tracing.Workers, aimed.size()), nullptr, monitor.Part(0.1, 0.4),
        [&](AimedBundle& bundle) { traceUntil(bundle, otherPhotons, (goal.Vectors + 1) / 2); }))
  {
    return false;
  }
  for (AimedBundle& bundle : aimed)
  {
    // What no photon met is left to the light's own bundle.
    const double safe = 2.0 + 2.0 * std::min(0.25, 4.0 / std::sqrt(static_cast<double>(goal.Vectors)));
    const double batches = safe * static_cast<double>(bundle.Photons) / static_cast<double>(batch);
    const vtkIdType enough = batch * static_cast<vtkIdType>(std::ceil(batches));
    tracing.Bundles.SetPhotons(bundle.Bundle, bundle.Most() > 0 ? std::min(enough, bundle.MostPhotons) : 0);
  }
  const auto trace = [&](AimedBundle& bundle)
  {
    const vtkIdType photons = tracing.Bundles.PhotonsOf(bundle.Bundle);
    const bool meetsAll = bundle.Fewest() > 0;
    bundle.Restart();
    bundle.Trace(tracing, 0, photons);
    if (photons > 0 && meetsAll)
    {
      traceUntil(bundle, 0, goal.Vectors);
    }
  };
  const BundleDeal deal = DealInRanges(tracing.Workers, aimed, tracing.Bundles);
  if (!ForEachBundle(aimed, tracing.Workers, deal, &result, monitor.Part(0.4, 1.0), trace))
  {
    return false;
  }
  result.MinimumVectors = goal.Asked();
  bool isKnown = true;
  NumberPhotons(aimed, tracing.Bundles, result);
  for (const AimedBundle& bundle : aimed)
  {
    result.MeanSolidAngle += bundle.SolidAngle;
    if (bundle.Fewest() > 0 && bundle.Fewest() < goal.Asked())
    {
      const vtkIdType photons = goal.PhotonsFor(bundle, aimed.size());
      isKnown = isKnown && photons > 0;
      result.PhotonsForScarce = std::max(result.PhotonsForScarce, photons);
    }
  }
  // So many were not enough.
  const auto more = static_cast<vtkIdType>(std::ceil(1.5 * static_cast<double>(options.NumberOfPhotons)));
  result.PhotonsForScarce =
    isKnown && result.PhotonsForScarce > 0 ? std::max(result.PhotonsForScarce, more) : 0;
  ofOthers = goal.GetLeastOfOthers();
  return true;
}

} // namespace shadowcones
