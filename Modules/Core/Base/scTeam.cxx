// SPDX-License-Identifier: BSD-3-Clause
#include "scTeam.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace shadowcones
{

Team::~Team() = default;

TeamShare::TeamShare(const Team* team, vtkIdType count, vtkIdType block)
  : Rank(team ? team->GetRank() : 0)
  , Size(team ? team->GetSize() : 1)
  , Items(std::max<vtkIdType>(count, 0))
  , Block(std::max<vtkIdType>(block, 1))
{
}

vtkIdType TeamShare::Of(int rank) const
{
  const vtkIdType round = this->Block * this->Size;
  const vtkIdType rest = this->Items % round - rank * this->Block;
  return this->Items / round * this->Block + std::clamp<vtkIdType>(rest, 0, this->Block);
}

bool GoesOn(const std::vector<TeamState>& states)
{
  const auto worst = std::max_element(states.begin(), states.end());
  // One that is done where others go on took another way than they: its inputs or parameters are others.
  const bool unlike = std::count(states.begin(), states.end(), TeamState::Done) > 0;
  if (*worst == TeamState::Failed || (unlike && *worst == TeamState::Joining))
  {
    const auto who = unlike && *worst == TeamState::Joining ? std::find(states.begin(), states.end(), TeamState::Done) : worst;
    throw std::runtime_error(
      "process " + std::to_string(who - states.begin()) + " of " + std::to_string(states.size()) + " failed");
  }
  return *worst == TeamState::Joining;
}

void TeamJoin::Pack(std::vector<unsigned char>& bytes) const
{
  std::size_t size = 0;
  for (const Array& array : this->Arrays)
  {
    size += array.IsPacked() ? static_cast<std::size_t>(array.OwnSize()) * array.ItemSize : 0;
  }
  bytes.resize(size);
  unsigned char* to = bytes.data();
  for (const Array& array : this->Arrays)
  {
    if (!array.IsPacked())
    {
      continue;
    }
    const vtkIdType own = array.OwnSize();
    const auto* from = static_cast<const unsigned char*>(array.Resize(own));
    const std::size_t tuple = array.ItemSize * static_cast<std::size_t>(array.Components);
    for (vtkIdType k = 0; array.Share && k < array.Share->Own(); ++k, to += tuple)
    {
      std::memcpy(to, from + static_cast<std::size_t>(array.Share->Item(k)) * tuple, tuple);
    }
    if (!array.Share && own > 0)
    {
      std::memcpy(to, from, static_cast<std::size_t>(own) * array.ItemSize);
      to += static_cast<std::size_t>(own) * array.ItemSize;
    }
  }
}

/// @param sizes of the arrays of the first process, of the second, and so on.
void TeamJoin::Unpack(const std::vector<unsigned char>& bytes, const std::vector<vtkIdType>& sizes) const
{
  const std::size_t count = this->Arrays.size();
  const int ranks = this->Members->GetSize();
  std::vector<unsigned char*> targets;
  for (std::size_t a = 0; a < count; ++a)
  {
    if (!this->Arrays[a].IsPacked())
    {
      targets.push_back(nullptr);
      continue;
    }
    vtkIdType all = 0;
    for (int rank = 0; rank < ranks; ++rank)
    {
      all += sizes[static_cast<std::size_t>(rank) * count + a];
    }
    targets.push_back(static_cast<unsigned char*>(this->Arrays[a].Resize(all)));
  }
  const unsigned char* from = bytes.data();
  for (int rank = 0; rank < ranks; ++rank)
  {
    for (std::size_t a = 0; a < count; ++a)
    {
      const Array& array = this->Arrays[a];
      if (!array.IsPacked())
      {
        continue;
      }
      const auto size = static_cast<std::size_t>(sizes[static_cast<std::size_t>(rank) * count + a]) * array.ItemSize;
      const std::size_t tuple = array.ItemSize * static_cast<std::size_t>(array.Components);
      for (vtkIdType k = 0; array.Share && k < array.Share->Of(rank); ++k)
      {
        std::memcpy(targets[a] + static_cast<std::size_t>(array.Share->Item(k, rank)) * tuple,
          from + static_cast<std::size_t>(k) * tuple, tuple);
      }
      if (!array.Share && size > 0)
      {
        std::memcpy(targets[a], from, size);
        targets[a] += size;
      }
      from += size;
    }
  }
}

void TeamJoin::CheckSizes(const std::vector<vtkIdType>& sizes) const
{
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const Array& array = this->Arrays[i % this->Arrays.size()];
    const int rank = static_cast<int>(i / this->Arrays.size());
    if (array.Share && sizes[i] != array.Share->Of(rank) * array.Components)
    {
      throw std::runtime_error("process " + std::to_string(rank) + " has other inputs or parameters");
    }
  }
}

TeamJoin::Parcel TeamJoin::ParcelOf(
  const std::vector<vtkIdType>& sizes, const std::function<bool(std::size_t)>& isIn) const
{
  Parcel parcel;
  parcel.Lengths.assign(static_cast<std::size_t>(this->Members->GetSize()), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const std::size_t a = i % this->Arrays.size();
    const vtkIdType bytes = isIn(a) ? sizes[i] * static_cast<vtkIdType>(this->Arrays[a].ItemSize) : 0;
    parcel.Lengths[i / this->Arrays.size()] += bytes;
    parcel.Total += bytes;
  }
  return parcel;
}

void TeamJoin::Exchange(const std::vector<vtkIdType>& ownSizes)
{
  // What may fail for lack of memory in one process is done before a meeting, which tells the others.
  std::vector<unsigned char> own;
  std::vector<unsigned char> all;
  std::vector<vtkIdType> sizes;
  Parcel packed;
  std::vector<Parcel> others(this->Arrays.size());
  std::vector<void*> places(this->Arrays.size(), nullptr);
  std::exception_ptr thrown;
  try
  {
    sizes = this->Members->GatherNumbers(ownSizes);
    this->CheckSizes(sizes);
    packed = this->ParcelOf(sizes, [this](std::size_t a) { return this->Arrays[a].IsPacked(); });
    this->Pack(own);
    all.resize(static_cast<std::size_t>(packed.Total));
    for (std::size_t a = 0; a < this->Arrays.size(); ++a)
    {
      if (!this->Arrays[a].IsPacked())
      {
        others[a] = this->ParcelOf(sizes, [a](std::size_t b) { return a == b; });
        places[a] = this->Arrays[a].Resize(others[a].Total / static_cast<vtkIdType>(this->Arrays[a].ItemSize));
      }
    }
  }
  catch (...)
  {
    thrown = std::current_exception();
  }
  const std::vector<TeamState> states = this->Members->Meet(thrown ? TeamState::Failed : TeamState::Joining);
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  GoesOn(states);
  if (packed.Total > 0)
  {
    this->Members->GatherBytes(own.data(), packed.Lengths, all.data());
  }
  own = {};
  for (std::size_t a = 0; a < this->Arrays.size(); ++a)
  {
    if (others[a].Total > 0)
    {
      const auto* from = static_cast<const unsigned char*>(this->Arrays[a].Own(false));
      this->Members->GatherBytes(from, others[a].Lengths, static_cast<unsigned char*>(places[a]));
      this->Arrays[a].Own(true);
    }
  }
  this->Unpack(all, sizes);
}

bool TeamJoin::Run(const std::function<bool()>& work)
{
  if (!AreSeveral(this->Members))
  {
    return work();
  }
  TeamState state = TeamState::Failed;
  std::vector<vtkIdType> sizes;
  std::exception_ptr thrown;
  try
  {
    const bool done = work();
    for (const Array& array : this->Arrays)
    {
      sizes.push_back(array.OwnSize());
    }
    state = done ? TeamState::Joining : TeamState::Stopped;
  }
  catch (...)
  {
    thrown = std::current_exception();
  }
  const std::vector<TeamState> states = this->Members->Meet(state);
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  if (!GoesOn(states))
  {
    return false;
  }
  if (!this->Arrays.empty())
  {
    this->Exchange(sizes);
  }
  return true;
}

bool TeamFor(Team* team, TeamJoin& join, const TeamShare& share, const Monitor& monitor,
  const std::function<void(vtkIdType begin, vtkIdType end)>& body, const std::function<void()>& finish)
{
  const bool several = AreSeveral(team);
  const auto ranges = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType k = begin; k < end;)
    {
      // Items that follow each other go together.
      const vtkIdType first = share.Item(k);
      vtkIdType last = first + 1;
      for (++k; k < end && share.Item(k) == last; ++k)
      {
        ++last;
      }
      body(first, last);
    }
  };
  if (several)
  {
    team->Count(share.Own());
  }
  return join.Run(
    [&]
    {
      const bool done = several ? ParallelFor(share.Own(), monitor, ranges) : ParallelFor(share.Own(), monitor, body);
      if (finish)
      {
        finish();
      }
      return done;
    });
}

} // namespace shadowcones
