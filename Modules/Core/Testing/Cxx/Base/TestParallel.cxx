// SPDX-License-Identifier: BSD-3-Clause
// Loops, pieces and monitors: what makes results independent of threads.
#include "scParallel.h"

#include "scLoopRecorder.h"

#include "LoopBackends.h"
#include "TimeLimit.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace shadowcones;

TEST(ParallelFor, VisitsEveryIndexOnce)
{
  for (const vtkIdType count : { 0, 1, 2, 63, 64, 65, 1000, 100003 })
  {
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      std::unique_ptr<std::atomic<int>[]> visits(new std::atomic<int>[count + 1]());
      EXPECT_TRUE(ParallelFor(count, {},
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            ++visits[i];
          }
        }));
      for (vtkIdType i = 0; i < count; ++i)
      {
        ASSERT_EQ(visits[i], 1) << i << " of " << count;
      }
      EXPECT_EQ(visits[count], 0);
    }
    vtkSMPTools::Initialize(0);
  }
}

TEST(ParallelFor, ReportsGrowingProgressThatEndsAtOne)
{
  std::vector<double> seen;
  const std::thread::id caller = std::this_thread::get_id();
  Monitor monitor;
  monitor.Progress = [&](double share)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    seen.push_back(share);
  };
  // The items take a while: threads that are awake would else leave none to the caller.
  EXPECT_TRUE(ParallelFor(
    40, monitor, [](vtkIdType, vtkIdType) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }));
  EXPECT_GE(seen.size(), 3u); // even few items give more than one value
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(ParallelFor, StopsSoonAfterAnAbort)
{
  // Ten milliseconds an item, ten seconds in all.
  std::atomic<int> done{ 0 };
  bool stop = false;
  Monitor monitor;
  monitor.Aborted = [&] { return stop; };
  monitor.Progress = [&](double) { stop = true; };
  const auto start = std::chrono::steady_clock::now();
  const bool finished = ParallelFor(1000, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ++done;
      }
    });
  EXPECT_FALSE(finished);
  EXPECT_LT(done, 100);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), TimeLimit(1.0));
}

TEST(ParallelFor, AnAbortDuringTheLastBlockCounts)
{
  std::atomic<bool> stop{ false };
  Monitor monitor;
  monitor.Aborted = [&] { return stop.load(); };
  EXPECT_FALSE(ParallelFor(1, monitor, [&](vtkIdType, vtkIdType) { stop = true; }));
}

TEST(ParallelFor, AnAbortBeforeTheStartDoesNothing)
{
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(ParallelFor(10, monitor, [](vtkIdType, vtkIdType) { FAIL(); }));
}

/// Every backend of vtkSMPTools that this VTK was built with.
class ParallelForWithBackend : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    this->Before = vtkSMPTools::GetBackend();
    if (!testsupport::UseLoopBackend(GetParam()))
    {
      GTEST_SKIP() << "There is no " << GetParam() << " to try";
    }
    vtkSMPTools::Initialize(2);
  }
  void TearDown() override
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Before.c_str());
  }
  std::string Before;
};

TEST_P(ParallelForWithBackend, AnExceptionReachesTheCaller)
{
  const std::thread::id caller = std::this_thread::get_id();
  for (const vtkIdType bad : { vtkIdType(0), vtkIdType(57), vtkIdType(999) })
  {
    std::string said;
    try
    {
      ParallelFor(1000, {},
        [&](vtkIdType begin, vtkIdType end)
        {
          if (begin <= bad && bad < end)
          {
            throw std::runtime_error("item " + std::to_string(bad));
          }
        });
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      said = error.what();
    }
    EXPECT_EQ(said, "item " + std::to_string(bad));
  }
  // Threads are as good as before.
  std::atomic<vtkIdType> sum{ 0 };
  EXPECT_TRUE(ParallelFor(1000, {}, [&](vtkIdType begin, vtkIdType end) { sum += end - begin; }));
  EXPECT_EQ(sum, 1000);
}

TEST_P(ParallelForWithBackend, OneOfManyExceptionsReachesTheCaller)
{
  EXPECT_THROW(
    ParallelFor(1000, {}, [](vtkIdType, vtkIdType) { throw std::length_error("all of them"); }), std::length_error);
}

TEST_P(ParallelForWithBackend, TheMonitorIsServedOnTheCallingThread)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<double> seen;
  Monitor monitor;
  monitor.Progress = [&](double share)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    seen.push_back(share);
  };
  monitor.Aborted = [&]
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return false;
  };
  std::atomic<int> done{ 0 };
  const auto body = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      ++done;
    }
  };
  EXPECT_TRUE(ParallelFor(150, monitor, body));
  EXPECT_EQ(done, 150);
  EXPECT_GE(seen.size(), 4u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);

  monitor.Aborted = [&] { return done > 160; };
  EXPECT_FALSE(ParallelFor(1000, monitor, body));
  EXPECT_LT(done, 400);
}

TEST_P(ParallelForWithBackend, LoopsWithinLoopsEnd)
{
  Monitor monitor;
  monitor.Progress = [](double) {};
  std::atomic<vtkIdType> sum{ 0 };
  const auto inner = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      EXPECT_TRUE(ParallelFor(100, monitor, [&](vtkIdType first, vtkIdType last) { sum += last - first; }));
    }
  };
  ParallelFor(16, monitor, inner);
  EXPECT_EQ(sum, 1600);
  vtkSMPTools::For(0, 16, 1, inner); // a loop of someone else
  EXPECT_EQ(sum, 3200);
}

TEST(ParallelFor, ManyThreadsAreBusyWhateverTheItemsTake)
{
  // Items of a microsecond; of a millisecond; and of 0.2 to 20 ms, the long ones together at the end.
  std::vector<std::vector<double>> loops(3);
  loops[0].assign(2000000, 1e-6);
  loops[1].assign(20000, 1e-3);
  for (int k = 0; k < 6000; ++k)
  {
    loops[2].push_back(2e-4 * std::pow(100.0, k / 5999.0));
  }
  for (const auto& items : loops)
  {
    const double all = std::accumulate(items.begin(), items.end(), 0.0);
    for (const int threads : { 1, 2, 16, 64 })
    {
      const double seconds = LoopRecorder::Replay({ 0.0, items, {}, {} }, threads, 2e-6);
      EXPECT_GE(seconds, all / threads);
      EXPECT_GT(all, 0.9 * threads * seconds) << items.size() << " items on " << threads << " threads";
    }
  }
  // What no order can mend: one item that is longer than the others together.
  EXPECT_NEAR(LoopRecorder::Replay({ 0.0, { 1.0, 0.01, 0.01 }, {}, {} }, 16, 0.0), 1.0, 1e-12);
}

TEST(LoopRecorder, IdleThreadsHelpWithLoopsInsideOfItems)
{
  LoopRecorder::Loop inner;
  inner.Items.assign(100, 0.01);
  LoopRecorder::Loop loop;
  loop.Items = { 1.0, 1.0 };
  loop.Inner = { { inner }, { inner } };
  EXPECT_NEAR(LoopRecorder::Replay(loop, 1, 0.0), 2.0, 1e-9);
  EXPECT_NEAR(LoopRecorder::Replay(loop, 2, 0.0), 1.0, 1e-9);
  EXPECT_NEAR(LoopRecorder::Replay(loop, 16, 0.0), 0.125, 1e-9);
  // What stands outside of them is done by one thread, and no loop ends before its longest item.
  loop.Inner[0][0].Before = 0.5;
  loop.Items[0] = 1.5;
  EXPECT_NEAR(LoopRecorder::Replay(loop, 16, 0.0), 0.5 + 1.0 / 16.0, 1e-9);
  loop.Inner[1][0].Items = { 0.7, 0.3 };
  EXPECT_NEAR(LoopRecorder::Replay(loop, 16, 0.0), 0.7, 1e-9);
}

TEST(LoopRecorder, LoopsInsideOfItemsAreNoted)
{
  const LoopRecorder recorder;
  ParallelFor(3, {}, [](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      ParallelFor(5 + i, {}, [](vtkIdType, vtkIdType) { ParallelFor(7, {}, [](vtkIdType, vtkIdType) {}); });
    }
  });
  ASSERT_EQ(recorder.Loops().size(), 1u);
  const LoopRecorder::Loop& loop = recorder.Loops().front();
  ASSERT_EQ(loop.Inner.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    ASSERT_EQ(loop.Inner[i].size(), 1u);
    EXPECT_EQ(loop.Inner[i].front().Items.size(), 5 + i);
    EXPECT_TRUE(std::all_of(loop.Inner[i].front().Inner.begin(), loop.Inner[i].front().Inner.end(),
      [](const std::vector<LoopRecorder::Loop>& inner) { return inner.empty(); }));
  }
}

TEST(LoopRecorder, ShortItemsAreTimedTogether)
{
  const LoopRecorder recorder;
  std::vector<int> visits(300000, 0);
  const auto start = std::chrono::steady_clock::now();
  ParallelFor(300000, {}, [&visits](vtkIdType begin, vtkIdType end) {
    std::for_each(visits.begin() + begin, visits.begin() + end, [](int& visit) { visit += 1; });
  });
  const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 300000);
  const std::vector<double>& items = recorder.Loops().front().Items;
  ASSERT_EQ(items.size(), 300000u);
  EXPECT_LE(std::accumulate(items.begin(), items.end(), 0.0), all);
  // Far fewer different times than items: the clock was not asked for each of them.
  std::vector<double> different = items;
  different.erase(std::unique(different.begin(), different.end()), different.end());
  EXPECT_LT(different.size(), 30000u);
}

TEST(LoopRecorder, ThreadsHelpWithTheLastGroups)
{
  // Four groups of 16 items, one of them slow: 16 seconds for its thread, if nobody helped.
  LoopRecorder::Loop loop;
  for (vtkIdType item = 0; item < 64; ++item)
  {
    loop.Items.push_back(item < 48 ? 0.01 : 1.0);
  }
  loop.Groups = { 0, 16, 32, 48, 64 };
  EXPECT_NEAR(LoopRecorder::Replay(loop, 1, 0.0), 16.48, 1e-9);
  EXPECT_LT(LoopRecorder::Replay(loop, 4, 0.0), 4.6);
  // The first item prepares the group, which every helper has to do too.
  loop.Items[48] = 3.0;
  EXPECT_NEAR(LoopRecorder::Replay(loop, 1, 0.0), 18.48, 1e-9);
  EXPECT_GT(LoopRecorder::Replay(loop, 4, 0.0), 6.0);
  EXPECT_LT(LoopRecorder::Replay(loop, 4, 0.0), 7.0);
}

TEST_P(ParallelForWithBackend, GroupsAreDoneOnceEach)
{
  std::vector<vtkIdType> groups;
  for (vtkIdType first = 0, size = 1; first < 2000; first += size, size = size % 23 + 1)
  {
    groups.push_back(first);
  }
  groups.push_back(2000);
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    std::unique_ptr<std::atomic<int>[]> visits(new std::atomic<int>[2000]());
    std::atomic<int> bodies{ 0 };
    std::vector<double> seen;
    Monitor monitor;
    monitor.Progress = [&](double share) { seen.push_back(share); };
    EXPECT_TRUE(ParallelForGroups(groups, monitor,
      [&]
      {
        ++bodies;
        return [&](vtkIdType item) { ++visits[item]; };
      }));
    for (vtkIdType i = 0; i < 2000; ++i)
    {
      ASSERT_EQ(visits[i], 1) << i;
    }
    EXPECT_LE(bodies, std::max(threads, 1));
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), 1.0);
  }
  EXPECT_THROW(ParallelForGroups({ 0, 5, 9 }, {},
                 [] { return [](vtkIdType item) { item == 7 ? throw std::length_error("seven") : void(); }; }),
    std::length_error);
  EXPECT_TRUE(ParallelForGroups({}, {}, []() -> ItemBody { throw std::logic_error("nothing to do"); }));
  Monitor stopped;
  stopped.Aborted = [] { return true; };
  EXPECT_FALSE(ParallelForGroups({ 0, 1 }, stopped, []() -> ItemBody { throw std::logic_error("nothing to do"); }));
}

INSTANTIATE_TEST_SUITE_P(Backends, ParallelForWithBackend, testing::Values("Sequential", "STDThread", "TBB", "OpenMP"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });

TEST(LoopRecorder, NotesEveryItemOfOuterLoops)
{
  LoopRecorder recorder;
  const std::thread::id caller = std::this_thread::get_id();
  int inner = 0;
  EXPECT_TRUE(ParallelFor(3, {},
    [&](vtkIdType begin, vtkIdType end)
    {
      EXPECT_EQ(end, begin + 1);
      EXPECT_EQ(std::this_thread::get_id(), caller);
      ParallelFor(5, {}, [&](vtkIdType first, vtkIdType last) { inner += static_cast<int>(last - first); });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }));
  EXPECT_TRUE(ParallelFor(2, {}, [](vtkIdType, vtkIdType) {}));
  EXPECT_EQ(inner, 15);
  ASSERT_EQ(recorder.Loops().size(), 2u);
  ASSERT_EQ(recorder.Loops()[0].Items.size(), 3u);
  EXPECT_EQ(recorder.Loops()[1].Items.size(), 2u);
  for (const double seconds : recorder.Loops()[0].Items)
  {
    EXPECT_GE(seconds, 1e-3);
  }
}

TEST(Monitor, PartMapsItsShareIntoTheWhole)
{
  double seen = -1.0;
  Monitor whole;
  whole.Progress = [&](double share) { seen = share; };
  whole.Aborted = [] { return true; };
  const Monitor part = whole.Part(0.25, 0.75);
  part.Progress(0.0);
  EXPECT_EQ(seen, 0.25);
  part.Progress(1.0);
  EXPECT_EQ(seen, 0.75);
  part.Part(0.5, 1.0).Progress(0.5);
  EXPECT_EQ(seen, 0.625);
  EXPECT_TRUE(part.IsAborted());
  EXPECT_FALSE(Monitor().IsAborted());
  EXPECT_FALSE(Monitor().Part(0.0, 0.5).Progress);
}

TEST(PieceBound, CutsARangeIntoPiecesWithoutGapOrOverlap)
{
  for (const vtkIdType count : { vtkIdType(0), vtkIdType(3), vtkIdType(10), vtkIdType(1000003), vtkIdType(1) << 62 })
  {
    for (const vtkIdType pieces : { 1, 2, 4, 7, 1000 })
    {
      EXPECT_EQ(PieceBound(count, 0, pieces), 0);
      EXPECT_EQ(PieceBound(count, pieces, pieces), count);
      for (vtkIdType piece = 0; piece < pieces; ++piece)
      {
        const vtkIdType size = PieceBound(count, piece + 1, pieces) - PieceBound(count, piece, pieces);
        ASSERT_GE(size, count / pieces);
        ASSERT_LE(size, count / pieces + 1);
      }
    }
  }
}
