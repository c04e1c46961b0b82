// SPDX-License-Identifier: BSD-3-Clause
#include "scSeedCovering.h"

#include "scBox.h"
#include "scLoopRecorder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{
/// Deal ids out to processes by place: halves along the longest side, and so on, as many for each.
void DealByPlace(const double* points, vtkIdType* begin, vtkIdType* end, int firstRank, int ranks,
  const std::function<void(vtkIdType id, int rank)>& give)
{
  if (ranks == 1)
  {
    std::for_each(begin, end, [&](vtkIdType id) { give(id, firstRank); });
    return;
  }
  Box box;
  std::for_each(
    begin, end, [&](vtkIdType id) { box.Add(Vector3{ points[3 * id], points[3 * id + 1], points[3 * id + 2] }); });
  const Vector3 size = box.Empty() ? Vector3{} : box.Size();
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
  const int half = ranks / 2;
  vtkIdType* const middle = begin + (end - begin) * half / ranks;
  std::nth_element(begin, middle, end,
    [points, axis](vtkIdType a, vtkIdType b)
    {
      const double x = points[3 * a + axis];
      const double y = points[3 * b + axis];
      return x != y ? x < y : a < b;
    });
  DealByPlace(points, begin, middle, firstRank, half, give);
  DealByPlace(points, middle, end, firstRank + half, ranks - half, give);
}
} // anonymous namespace

void ConeProposals::AddTo(TeamJoin& join)
{
  join.Add(this->Headers);
  join.Add(this->Ids);
  join.Add(this->Cones);
  join.Add(this->Ends);
}

void ConeProposals::Add(vtkIdType seed, const ConeCandidate& candidate)
{
  this->Headers.push_back({ seed, candidate.Radius, static_cast<int>(candidate.Neighbors.size()),
    static_cast<int>(candidate.Members.size()) });
  for (const std::vector<vtkIdType>* ids : { &candidate.Neighbors, &candidate.Members })
  {
    for (const vtkIdType id : *ids)
    {
      this->Ids.push_back(static_cast<int>(id));
    }
  }
  if (!candidate.Members.empty())
  {
    this->Cones.push_back(candidate.Cone);
  }
}

/// What the processes proposed for a window, found by seed, and which of it does not hold.
class SeedCovering::Replay
{
public:
  Replay(const SeedCovering& covering, const Window& window, const ConeProposals& proposals)
    : Covering(covering)
    , TheWindow(window)
    , Proposals(proposals)
    , Places(window.Owners.size())
    , Revived(static_cast<std::size_t>(covering.Workers->GetSize()))
  {
    Place place;
    Box box;
    for (const ConeProposals::Header& header : proposals.Headers)
    {
      place.Header = &header;
      this->Places[static_cast<std::size_t>(header.Seed - window.First)] = place;
      place.Id += static_cast<std::size_t>(header.NumberOfNeighbors + header.NumberOfMembers);
      place.Cone += header.NumberOfMembers > 0;
      box.Add(covering.PointOf(header.Seed));
    }
    this->Margin = 1e-6 * box.Diagonal();
  }

  /// What was proposed for a seed, if it holds.
  bool Find(vtkIdType seed, ConeCandidate& candidate) const
  {
    const Place& place = this->At(seed);
    if (!place.Header)
    {
      return false;
    }
    const int* ids = this->Proposals.Ids.data() + place.Id;
    const int* members = ids + place.Header->NumberOfNeighbors;
    candidate.Neighbors.assign(ids, members);
    candidate.Members.assign(members, members + place.Header->NumberOfMembers);
    candidate.Radius = place.Header->Radius;
    candidate.Cone = candidate.Members.empty() ? Cone{} : this->Proposals.Cones[place.Cone];
    return this->Covering.IsAlive(candidate.Neighbors) && !this->MayLackOne(seed, candidate.Neighbors);
  }

  /// What was proposed for a seed, if anything was, is not so: what it would have covered was taken for dead by its process.
  void Drop(vtkIdType seed)
  {
    const Place& place = this->At(seed);
    if (place.Header && this->Covering.Dying)
    {
      const int* members = this->Proposals.Ids.data() + place.Id + place.Header->NumberOfNeighbors;
      std::copy_if(members, members + place.Header->NumberOfMembers, std::back_inserter(this->Revived[this->OwnerOf(seed)]),
        [this](int id) { return this->Covering.Dying->IsAlive(id); });
    }
  }

private:
  struct Place
  {
    const ConeProposals::Header* Header = nullptr;
    std::size_t Id = 0;
    std::size_t Cone = 0;
  };

  const Place& At(vtkIdType seed) const { return this->Places[static_cast<std::size_t>(seed - this->TheWindow.First)]; }
  std::size_t OwnerOf(vtkIdType seed) const
  {
    return static_cast<std::size_t>(this->TheWindow.Owners[static_cast<std::size_t>(seed - this->TheWindow.First)]);
  }
  /// Could one that its process took for dead be among the neighbours? With a margin, as the tree rounds.
  bool MayLackOne(vtkIdType seed, const std::vector<vtkIdType>& neighbors) const
  {
    const std::vector<vtkIdType>& revived = this->Revived[this->OwnerOf(seed)];
    if (revived.empty() || neighbors.empty())
    {
      return false;
    }
    const Vector3 point = this->Covering.PointOf(seed);
    double reach = 0.0;
    for (const vtkIdType id : neighbors)
    {
      reach = std::max(reach, Length(this->Covering.PointOf(id) - point));
    }
    reach += 1e-5 * reach + this->Margin;
    return std::any_of(revived.begin(), revived.end(), [&](vtkIdType id)
      { return this->Covering.Dying->IsAlive(id) && Length(this->Covering.PointOf(id) - point) <= reach; });
  }

  const SeedCovering& Covering;
  const Window& TheWindow;
  const ConeProposals& Proposals;
  std::vector<Place> Places;                   ///< of each vector of the window
  std::vector<std::vector<vtkIdType>> Revived; ///< by process: what it took for dead and is not
  double Margin = 0.0;
};

SeedCovering::SeedCovering(
  const double* points, const CandidateMaker& make, NearestVectors* dying, Team* workers, ConeSet& result)
  : Points(points)
  , Make(make)
  , Dying(dying)
  , Workers(workers)
  , Result(result)
  , Count(static_cast<vtkIdType>(result.ConeIds.size()))
  , Covered(result.ConeIds.size(), 0)
{
  std::transform(result.ConeIds.begin(), result.ConeIds.end(), this->Covered.begin(),
    [](vtkIdType cone) { return static_cast<unsigned char>(cone >= 0); });
}

bool SeedCovering::Run(const Monitor& monitor)
{
  return AreSeveral(this->Workers) ? this->RunTogether(monitor) : this->TakeSeeds(this->Count, monitor);
}

bool SeedCovering::IsSeed(vtkIdType id) const
{
  return !this->Covered[id] &&
    (!this->Own || this->Own->Owners[static_cast<std::size_t>(id - this->Own->First)] == this->Workers->GetRank());
}

/// Let the seeds before @p end have their turn.
bool SeedCovering::TakeSeeds(vtkIdType end, const Monitor& monitor)
{
  constexpr double step = 1.0 / 256.0; // of progress: one seed may be all that is made at once
  double said = 0.0;
  const Monitor quiet{ nullptr, monitor.Aborted };
  std::vector<vtkIdType> seeds;
  std::vector<ConeCandidate> made;
  while (this->Next < end && !this->IsEnough())
  {
    this->ChooseSeeds(seeds);
    made.resize(seeds.size());
    const auto body = [&](vtkIdType first, vtkIdType last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        this->Make(seeds[i], made[i]);
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
    this->TakeInTurn(end);
    const double done = static_cast<double>(this->Next) / static_cast<double>(this->Count);
    if (monitor.Progress && (this->Next == this->Count || done >= said + step))
    {
      monitor.Progress(done);
      said = done;
    }
  }
  return true;
}

/**
 * The next seed, and some of those that follow: but for those that lie so near to one before them that its base will
 * hold them. Where it does not, they come later, before any that follows them is taken. One thread makes them when it is their turn.
 */
void SeedCovering::ChooseSeeds(std::vector<vtkIdType>& seeds) const
{
  constexpr vtkIdType vectorsPerSeed = 400;
  const bool isAlone = vtkSMPTools::GetEstimatedNumberOfThreads() == 1 && !LoopRecorder::Active();
  const vtkIdType most = isAlone ? 1 : std::clamp<vtkIdType>(this->Count / vectorsPerSeed, 32, 256);
  constexpr vtkIdType looksOfSeed = 4;
  constexpr vtkIdType few = 128; // of more, from many vectors, hardly any two are near
  const double near = this->SumOfRadii / static_cast<double>(std::max<vtkIdType>(1, this->NumberOfBases));
  const vtkIdType end = this->Own ? this->Own->End : this->Count;
  std::vector<Vector3> before;
  const auto isNear = [&](const Vector3& point)
  {
    return most <= few &&
      std::any_of(before.begin(), before.end(),
        [&](const Vector3& other) { return Dot(point - other, point - other) < near * near; });
  };
  seeds.clear();
  vtkIdType looks = 0;
  for (vtkIdType id = this->Next;
       id < end && static_cast<vtkIdType>(seeds.size()) < most && looks < looksOfSeed * most; ++id)
  {
    if (!this->IsSeed(id))
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

/// Take what waits, up to the first seed whose candidate is not there.
void SeedCovering::TakeInTurn(vtkIdType end)
{
  for (; this->Next < end; ++this->Next)
  {
    const auto waiting = this->Waiting.find(this->Next);
    if (this->IsSeed(this->Next))
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
    if (this->Prune() || this->IsEnough())
    {
      ++this->Next;
      return;
    }
  }
}

void SeedCovering::Take(vtkIdType seed, ConeCandidate& candidate)
{
  if (!this->IsAlive(candidate.Neighbors))
  {
    this->Make(seed, candidate);
  }
  this->Accept(seed, candidate);
}

void SeedCovering::Accept(vtkIdType seed, const ConeCandidate& candidate)
{
  if (this->Proposed)
  {
    this->Proposed->Add(seed, candidate);
  }
  if (candidate.Members.empty())
  {
    return;
  }
  const auto id = static_cast<vtkIdType>(this->Result.Cones.size());
  if (!this->Proposed)
  {
    this->Result.Cones.push_back(candidate.Cone);
  }
  this->SumOfRadii += candidate.Radius;
  this->NumberOfBases += 1;
  for (const vtkIdType member : candidate.Members)
  {
    if (this->Proposed && !this->Covered[member])
    {
      this->ToUncover.push_back(member);
    }
    this->Covered[member] = 1;
    if (!this->Proposed && this->Result.ConeIds[member] < 0)
    {
      this->Result.ConeIds[member] = id;
    }
    if (this->Dying)
    {
      this->Dying->Kill(member);
    }
  }
}

bool SeedCovering::IsAlive(const std::vector<vtkIdType>& ids) const
{
  return !this->Dying ||
    std::all_of(ids.begin(), ids.end(), [this](vtkIdType id) { return this->Dying->IsAlive(id); });
}

/**
 * Drop the dead from the tree where that pays. Neighbours as far as each other come in the order of the tree: candidates of
 * the old one are forgotten, so that all have the tree that they would have one after the other.
 */
bool SeedCovering::Prune()
{
  if (this->Proposed || !this->Dying || !this->Dying->Prune())
  {
    return false;
  }
  this->Waiting.clear();
  return true;
}

/// Has this process proposed so much that the tree will be built anew, if the others cover as much? Neighbours are others then.
bool SeedCovering::IsEnough() const
{
  constexpr double margin = 1.1;
  return this->Proposed && this->Dying &&
    static_cast<double>(this->ToUncover.size()) * this->Workers->GetSize() > margin * static_cast<double>(this->Spare);
}

bool SeedCovering::RunTogether(const Monitor& monitor)
{
  Window window;
  ConeProposals proposals;
  do
  {
    Window next;
    ConeProposals own;
    TeamJoin join(this->Workers);
    own.AddTo(join);
    const auto takeAndPropose = [&]
    {
      if (!this->TakeProposals(window, proposals, monitor))
      {
        return false;
      }
      next = this->NextWindow();
      return this->Propose(next, monitor, own);
    };
    if (!join.Run(takeAndPropose))
    {
      return false;
    }
    window = std::move(next);
    proposals = std::move(own);
    if (monitor.Progress)
    {
      monitor.Progress(static_cast<double>(this->Next) / static_cast<double>(this->Count));
    }
  } while (window.First < window.End);
  return true;
}

/// A part of the seeds that are left: what processes do not know of each other is little then.
SeedCovering::Window SeedCovering::NextWindow() const
{
  constexpr vtkIdType part = 32;
  constexpr vtkIdType fewest = 64;
  const int size = this->Workers->GetSize();
  const vtkIdType left = std::count(this->Covered.begin() + this->Next, this->Covered.end(), 0);
  const vtkIdType wanted = std::max(left / part, fewest * size);
  Window window;
  window.First = this->Next;
  std::vector<vtkIdType> seeds;
  for (window.End = this->Next; window.End < this->Count && static_cast<vtkIdType>(seeds.size()) < wanted; ++window.End)
  {
    if (!this->Covered[window.End])
    {
      seeds.push_back(window.End);
    }
  }
  window.Owners.assign(static_cast<std::size_t>(window.End - window.First), -1);
  DealByPlace(this->Points, seeds.data(), seeds.data() + seeds.size(), 0, size,
    [&window](vtkIdType id, int rank) { window.Owners[static_cast<std::size_t>(id - window.First)] = rank; });
  return window;
}

/// Cover the own seeds of a window as if there were no others, and leave no trace but the proposals. @return false where aborted.
bool SeedCovering::Propose(const Window& window, const Monitor& monitor, ConeProposals& proposals)
{
  const double radii = this->SumOfRadii;
  const vtkIdType bases = this->NumberOfBases;
  this->Own = &window;
  this->Proposed = &proposals;
  this->ToUncover.clear();
  this->Spare = this->Dying ? this->Dying->DeathsUntilPrune() : 0;
  const bool finished = this->TakeSeeds(window.End, { nullptr, monitor.Aborted });
  this->Workers->Count(static_cast<vtkIdType>(proposals.Headers.size()));
  proposals.Ends = { this->Next };
  for (const vtkIdType id : this->ToUncover)
  {
    this->Covered[id] = 0;
    if (this->Dying)
    {
      this->Dying->Revive(id);
    }
  }
  this->Waiting.clear();
  this->Proposed = nullptr;
  this->Own = nullptr;
  this->Next = window.First;
  this->SumOfRadii = radii;
  this->NumberOfBases = bases;
  return finished;
}

/// Let the seeds of a window have their turn. @return false where aborted.
bool SeedCovering::TakeProposals(const Window& window, const ConeProposals& proposals, const Monitor& monitor)
{
  Replay replay(*this, window, proposals);
  ConeCandidate candidate;
  const vtkIdType end =
    proposals.Ends.empty() ? window.End : *std::min_element(proposals.Ends.begin(), proposals.Ends.end());
  while (this->Next < end)
  {
    const vtkIdType seed = this->Next;
    const bool isSeed = this->IsSeed(seed);
    const bool isFound = isSeed && replay.Find(seed, candidate);
    if (isSeed && !isFound)
    {
      if (monitor.IsAborted())
      {
        return false;
      }
      this->Make(seed, candidate);
      this->Workers->Count(1);
    }
    if (isSeed)
    {
      this->Accept(seed, candidate);
    }
    if (!isFound)
    {
      replay.Drop(seed);
    }
    ++this->Next;
    if (this->Prune())
    {
      return true;
    }
  }
  return true;
}

} // namespace shadowcones
