// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreadTeam.h
 * @brief Threads that play the processes of a team, each with its own memory of what it did.
 */
#ifndef ThreadTeam_h
#define ThreadTeam_h

#include "scTeam.h"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// Where they meet.
class MeetingPlace
{
public:
  explicit MeetingPlace(int size)
    : Bytes(static_cast<std::size_t>(size))
  {
  }
  /// The bytes of all, once all have come.
  std::vector<std::vector<unsigned char>> Exchange(int rank, const void* own, std::size_t length)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    const auto* first = static_cast<const unsigned char*>(own);
    this->Bytes[static_cast<std::size_t>(rank)].assign(first, first + length);
    const int round = this->Round;
    if (++this->Arrived == static_cast<int>(this->Bytes.size()))
    {
      this->Arrived = 0;
      ++this->Round;
      this->Last = this->Bytes;
      this->Changed.notify_all();
    }
    this->Changed.wait(lock, [&] { return this->Round != round; });
    return this->Last;
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<std::vector<unsigned char>> Bytes;
  std::vector<std::vector<unsigned char>> Last;
  int Arrived = 0;
  int Round = 0;
};

class ThreadTeam : public Team
{
public:
  ThreadTeam(MeetingPlace& place, int rank, int size)
    : Place(place)
    , Rank(rank)
    , Size(size)
  {
  }
  int GetRank() const override { return this->Rank; }
  int GetSize() const override { return this->Size; }
  std::vector<TeamState> Meet(TeamState own) override
  {
    std::vector<TeamState> states;
    for (const auto& bytes : this->Place.Exchange(this->Rank, &own, sizeof(own)))
    {
      states.emplace_back();
      std::memcpy(&states.back(), bytes.data(), sizeof(own));
    }
    return states;
  }
  std::vector<vtkIdType> GatherNumbers(const std::vector<vtkIdType>& own) override
  {
    std::vector<vtkIdType> all;
    for (const auto& bytes : this->Place.Exchange(this->Rank, own.data(), own.size() * sizeof(vtkIdType)))
    {
      all.resize(all.size() + own.size());
      std::memcpy(all.data() + all.size() - own.size(), bytes.data(), bytes.size());
    }
    return all;
  }
  void GatherBytes(const unsigned char* own, const std::vector<vtkIdType>& lengths, unsigned char* all) override
  {
    for (const auto& bytes :
      this->Place.Exchange(this->Rank, own, static_cast<std::size_t>(lengths[static_cast<std::size_t>(this->Rank)])))
    {
      std::copy(bytes.begin(), bytes.end(), all);
      all += bytes.size();
    }
  }
  void Count(vtkIdType items) override { this->Items += items; }

  vtkIdType Items = 0;

private:
  MeetingPlace& Place;
  int Rank;
  int Size;
};

/// Run a task as each process of a team.
inline void RunAsTeam(int size, const std::function<void(ThreadTeam& team)>& task)
{
  MeetingPlace place(size);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < size; ++rank)
  {
    threads.emplace_back(
      [&place, &task, rank, size]
      {
        ThreadTeam team(place, rank, size);
        task(team);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

} // namespace testsupport
} // namespace shadowcones

#endif
