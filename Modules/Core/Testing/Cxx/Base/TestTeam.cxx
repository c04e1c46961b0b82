// SPDX-License-Identifier: BSD-3-Clause
// Work shared by processes: who has which items, what all have behind it, and what happens where one fails.
#include "scLargePages.h"
#include "scTeam.h"

#include "ThreadTeam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>

using namespace shadowcones;
using namespace testsupport;

TEST(TeamShare, EveryItemBelongsToOneProcess)
{
  for (const int size : { 1, 2, 3, 4 })
  {
    for (const vtkIdType count : { 0, 1, 2, 5, 64, 65, 127, 1000 })
    {
      for (const vtkIdType block : { 1, 3, 64 })
      {
        MeetingPlace place(size);
        const ThreadTeam first(place, 0, size);
        const TeamShare share(&first, count, block);
        std::vector<int> owners(static_cast<std::size_t>(count), 0);
        for (int rank = 0; rank < size; ++rank)
        {
          for (vtkIdType k = 0; k < share.Of(rank); ++k)
          {
            ++owners.at(static_cast<std::size_t>(share.Item(k, rank)));
          }
        }
        EXPECT_EQ(owners, std::vector<int>(owners.size(), 1)) << size << " " << count << " " << block;
      }
    }
  }
}

TEST(TeamJoin, AllHaveWhatEachDid)
{
  for (const int size : { 1, 2, 3, 4 })
  {
    RunAsTeam(size,
      [size](ThreadTeam& team)
      {
        std::vector<double> squares(2 * 101, -1.0);
        std::vector<int> ranks;
        const TeamShare share(&team, 101, 4);
        TeamJoin join(&team);
        join.AddItems(squares, share, 2);
        join.Add(ranks);
        const auto square = [&](vtkIdType begin, vtkIdType end)
        {
          for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          {
            squares[2 * i] = static_cast<double>(i * i);
            squares[2 * i + 1] = static_cast<double>(i);
          }
        };
        // As many entries as its rank: parts of any length, none among them.
        const auto finish = [&] { ranks.assign(static_cast<std::size_t>(team.GetRank()), team.GetRank()); };
        EXPECT_TRUE(TeamFor(&team, join, share, {}, square, finish));
        for (std::size_t i = 0; i < 101; ++i)
        {
          EXPECT_EQ(squares[2 * i], static_cast<double>(i * i));
          EXPECT_EQ(squares[2 * i + 1], static_cast<double>(i));
        }
        std::vector<int> expected;
        for (int rank = 0; rank < size; ++rank)
        {
          expected.insert(expected.end(), static_cast<std::size_t>(rank), rank);
        }
        EXPECT_EQ(ranks, expected);
        EXPECT_EQ(team.Items, size > 1 ? share.Own() : 0);
      });
  }
}

TEST(TeamJoin, WhereOneFailsNobodyWaits)
{
  std::atomic<int> told{ 0 };
  RunAsTeam(3,
    [&told](ThreadTeam& team)
    {
      std::vector<int> values;
      TeamJoin join(&team);
      join.Add(values);
      try
      {
        join.Run(
          [&]
          {
            if (team.GetRank() == 1)
            {
              throw std::bad_alloc();
            }
            return true;
          });
        ADD_FAILURE() << "went on";
      }
      catch (const std::bad_alloc&)
      {
        EXPECT_EQ(team.GetRank(), 1);
        ++told;
      }
      catch (const std::runtime_error& error)
      {
        EXPECT_EQ(std::string(error.what()), "process 1 of 3 failed");
        ++told;
      }
    });
  EXPECT_EQ(told, 3);
}

TEST(TeamJoin, WhereOneIsStoppedAllStop)
{
  RunAsTeam(2,
    [](ThreadTeam& team)
    {
      std::vector<int> values;
      TeamJoin join(&team);
      join.Add(values);
      EXPECT_FALSE(join.Run([&] { return team.GetRank() != 0; }));
    });
}

TEST(TeamJoin, OneThatLeftOrHasOtherItemsIsAFailure)
{
  RunAsTeam(2,
    [](ThreadTeam& team)
    {
      if (team.GetRank() == 0)
      {
        team.Meet(TeamState::Done); // where the other joins
        return;
      }
      TeamJoin join(&team);
      EXPECT_THROW(join.Run([] { return true; }), std::runtime_error);
    });
  RunAsTeam(2,
    [](ThreadTeam& team)
    {
      std::vector<int> values(team.GetRank() == 0 ? 10 : 20, 0);
      const TeamShare share(&team, static_cast<vtkIdType>(values.size()));
      TeamJoin join(&team);
      join.AddItems(values, share);
      EXPECT_THROW(join.Run([] { return true; }), std::runtime_error);
    });
}

TEST(LargePages, ValuesStayWhereTheyWere)
{
  for (const std::size_t count : { std::size_t(0), std::size_t(3), std::size_t(1) << 20 })
  {
    std::vector<double> values{ 1.0, 2.0, 3.0 };
    ReserveLarge(values, count);
    EXPECT_GE(values.capacity(), count);
    values.resize(std::max<std::size_t>(count, 3), 4.0);
    EXPECT_EQ(values[2], 3.0);
    EXPECT_EQ(std::count(values.begin() + 3, values.end(), 4.0), static_cast<std::ptrdiff_t>(values.size() - 3));
  }
  PreferLargePages(nullptr, 0);
}
