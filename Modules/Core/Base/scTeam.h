// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTeam.h
 * @brief Processes that do one task together: each its share of the items, after which all have the whole.
 */
#ifndef scTeam_h
#define scTeam_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "vtkType.h"

#include <cstddef>
#include <exception>
#include <functional>
#include <type_traits>
#include <vector>

namespace shadowcones
{

/// How it goes in one process; the largest of all is how it goes in the team.
enum class TeamState : int
{
  Done = 0,    ///< there is nothing left to do together
  Joining = 1, ///< its share is done, and the others' are wanted
  Stopped = 2, ///< it was aborted
  Failed = 3
};

/**
 * What Core knows of other processes. All run the same task on the same inputs, and so meet equally often. Who leaves the task
 * early says so at the next meeting, in the place of what it would have said: nobody waits for it. A null pointer is a
 * team of one.
 */
class SHADOWCONESCORE_EXPORT Team
{
public:
  Team() = default;
  virtual ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  virtual int GetRank() const = 0;
  virtual int GetSize() const = 0;
  /// Say how it goes. @return the states of all processes; behind one that is not Joining there is no further meeting.
  virtual std::vector<TeamState> Meet(TeamState own) = 0;
  /// The numbers of all, in order of ranks; each has as many.
  virtual std::vector<vtkIdType> GatherNumbers(const std::vector<vtkIdType>& own) = 0;
  /// The bytes of all, in order of ranks; @p lengths is that of each.
  virtual void GatherBytes(const unsigned char* own, const std::vector<vtkIdType>& lengths, unsigned char* all) = 0;
  /// Take note of items that this process does.
  virtual void Count(vtkIdType items) = 0;
};

/// Is there more than one process?
inline bool AreSeveral(const Team* team)
{
  return team && team->GetSize() > 1;
}

/// Which of @p count items a process does: blocks of so many, dealt out in turn.
class SHADOWCONESCORE_EXPORT TeamShare
{
public:
  TeamShare(const Team* team, vtkIdType count, vtkIdType block = 1);

  /// Items of this process, or of another.
  vtkIdType Own() const { return this->Of(this->Rank); }
  vtkIdType Of(int rank) const;
  /// The item that is the k-th of this process, or of another.
  vtkIdType Item(vtkIdType k) const { return this->Item(k, this->Rank); }
  vtkIdType Item(vtkIdType k, int rank) const
  {
    return (k / this->Block * this->Size + rank) * this->Block + k % this->Block;
  }

private:
  int Rank = 0;
  vtkIdType Size = 1;
  vtkIdType Items;
  vtkIdType Block;
};

/// One exchange: which arrays are to be joined, and the work that fills them.
class SHADOWCONESCORE_EXPORT TeamJoin
{
public:
  explicit TeamJoin(Team* team)
    : Members(team)
  {
  }

  /// Each process has a part of this array; then all have all parts, in order of ranks.
  template <typename T>
  void Add(std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable_v<T>, "bytes");
    this->Arrays.push_back({ sizeof(T),
      [&values] { return static_cast<vtkIdType>(values.size()); },
      [&values](vtkIdType size) -> void*
      {
        values.resize(static_cast<std::size_t>(size));
        return values.data();
      },
      nullptr, 1, nullptr });
  }
  /**
   * Each process has a part of this array, in @p own; then all have all parts behind what is in @p all, in order of ranks. They go
   * from place to place without being packed, for arrays that are large; own is freed.
   */
  template <typename T>
  void Append(std::vector<T>& own, std::vector<T>& all)
  {
    static_assert(std::is_trivially_copyable_v<T>, "bytes");
    this->Arrays.push_back({ sizeof(T),
      [&own] { return static_cast<vtkIdType>(own.size()); },
      [&all](vtkIdType size) -> void*
      {
        const std::size_t before = all.size();
        all.resize(before + static_cast<std::size_t>(size));
        return all.data() + before;
      },
      nullptr, 1,
      [&own](bool isSent) -> const void*
      {
        if (isSent)
        {
          own = {};
        }
        return own.data();
      } });
  }
  /// Each process has filled in its items of this array, with so many values each; then all have all. Of an empty array: nothing.
  template <typename T>
  void AddItems(std::vector<T>& values, const TeamShare& share, vtkIdType components = 1)
  {
    static_assert(std::is_trivially_copyable_v<T>, "bytes");
    if (!values.empty())
    {
      this->Arrays.push_back({ sizeof(T), [&share, components] { return share.Own() * components; },
        [&values](vtkIdType) -> void* { return values.data(); }, &share, components, nullptr });
    }
  }

  /**
   * Do this process's work, then join. Where the work of one process is aborted (it returns false) or throws, that ends the task
   * for all. @return false where one was aborted. Throws what the own work threw; std::runtime_error where that of another did.
   */
  bool Run(const std::function<bool()>& work);

private:
  struct Array
  {
    std::size_t ItemSize;
    std::function<vtkIdType()> OwnSize;     ///< values
    std::function<void*(vtkIdType)> Resize; ///< to so many values of all; where they are
    const TeamShare* Share;                 ///< nullptr: parts follow each other
    vtkIdType Components;
    std::function<const void*(bool isSent)> Own; ///< of those that are not packed: the own part, freed once it is sent

    bool IsPacked() const { return !this->Own; }
  };
  /// Bytes that go from all to all.
  struct Parcel
  {
    std::vector<vtkIdType> Lengths; ///< of each process
    vtkIdType Total = 0;
  };

  void Exchange(const std::vector<vtkIdType>& ownSizes);
  void CheckSizes(const std::vector<vtkIdType>& sizes) const;
  Parcel ParcelOf(const std::vector<vtkIdType>& sizes, const std::function<bool(std::size_t)>& isIn) const;
  void Pack(std::vector<unsigned char>& bytes) const;
  void Unpack(const std::vector<unsigned char>& bytes, const std::vector<vtkIdType>& sizes) const;

  Team* Members;
  std::vector<Array> Arrays;
};

/// Throw where a process of the team has failed. @return false where one was stopped.
SHADOWCONESCORE_EXPORT bool GoesOn(const std::vector<TeamState>& states);

/**
 * ParallelFor over this process's share of the items, @p block at a time, then join what the arrays of @p join hold: for items
 * that depend on nothing but their index. @p body is given ranges of items, @p finish comes behind the last.
 */
SHADOWCONESCORE_EXPORT bool TeamFor(Team* team, TeamJoin& join, const TeamShare& share, const Monitor& monitor,
  const std::function<void(vtkIdType begin, vtkIdType end)>& body, const std::function<void()>& finish = nullptr);

} // namespace shadowcones

#endif
