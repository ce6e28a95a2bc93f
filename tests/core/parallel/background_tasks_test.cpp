#include "core/parallel/background_tasks.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/parallel/parallel.hpp"
#include "core/parallel/task_arena.hpp"

namespace percuss::meanwhile_test {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMuch = 1'000'000'000;  // operations: worth other threads

void loop(std::size_t count = 4) {
  parallel_for_cost(count, kMuch, [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
}

TEST(BackgroundTasks, DoesEachTaskOnceOnAnyNumberOfThreads) {
  for (const std::size_t threads : {0U, 1U, 2U, 8U}) {
    const ThreadLimit limit(threads);
    for (const std::size_t count : {0U, 1U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      BackgroundTasks work(count, [&](std::size_t i) { ++calls.at(i); });
      loop();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      loop();
      work.finish();
      for (const auto& number : calls) EXPECT_EQ(number, 1);
    }
  }
}

TEST(BackgroundTasks, BeginsNothingByItselfOnOneThread) {
  const ThreadLimit limit(1);
  int calls = 0;  // unguarded: a second thread would be a race
  {
    const BackgroundTasks work(10, [&](std::size_t) { ++calls; });
    loop();
  }
  EXPECT_EQ(calls, 0);
}

TEST(BackgroundTasks, HasOtherThreadsWorkWhileThisOneIsBusy) {
  if (arena_concurrency(2) < 2) return;  // this process has one processor
  const ThreadLimit limit(2);
  const auto here = std::this_thread::get_id();
  std::atomic<int> calls{0};
  BackgroundTasks work(10, [&](std::size_t) {
    EXPECT_NE(std::this_thread::get_id(), here);
    ++calls;
  });
  loop();
  const auto patience = Clock::now() + std::chrono::seconds(60);
  while (calls < 10 && Clock::now() < patience) std::this_thread::yield();
  EXPECT_EQ(calls, 10);
  work.finish();
}

// Without waiting for what is left: each task takes longer than the loops.
TEST(BackgroundTasks, LeavesOffWhereALoopBegins) {
  const ThreadLimit limit(2);
  std::atomic<int> in_loop{0}, begun_in_loop{0};
  BackgroundTasks work(1000, [&](std::size_t) {
    if (in_loop > 0) ++begun_in_loop;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  });
  for (int i = 0; i < 10; ++i) {
    parallel_for_cost(4, kMuch, [&](std::size_t) {
      ++in_loop;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      --in_loop;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_LE(begun_in_loop, 10);  // one that was just being begun
}

TEST(BackgroundTasks, EndsWithWhatHasBegun) {
  const ThreadLimit limit(2);
  std::atomic<int> begun{0}, ended{0};
  {
    const BackgroundTasks work(1000, [&](std::size_t) {
      ++begun;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++ended;
    });
    loop();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const int at_end = begun;
  EXPECT_EQ(ended, at_end);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(begun, at_end);
  EXPECT_LT(at_end, 1000);
}

TEST(BackgroundTasks, PassesOnTheErrorOfTheLowestIndex) {
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const ThreadLimit limit(threads);
    BackgroundTasks work(100, [](std::size_t i) {
      if (i % 10 == 3) throw std::runtime_error("task " + std::to_string(i));
    });
    loop();
    try {
      work.finish();
      FAIL() << "no exception on " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "task 3");
    }
  }
}

TEST(BackgroundTasks, StaysOnItsThreadWithWhatATaskSharesOut) {
  const ThreadLimit limit(2);
  std::atomic<int> elsewhere{0};
  BackgroundTasks work(20, [&](std::size_t) {
    const auto here = std::this_thread::get_id();
    parallel_for_cost(10, kMuch, [&](std::size_t) {
      if (std::this_thread::get_id() != here) ++elsewhere;
    });
  });
  loop();
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_EQ(elsewhere, 0);
}

TEST(BackgroundTasks, MayStandWithinAnother) {
  const ThreadLimit limit(2);
  std::atomic<int> outer_calls{0}, inner_calls{0};
  BackgroundTasks outer(100, [&](std::size_t) { ++outer_calls; });
  {
    BackgroundTasks inner(100, [&](std::size_t) { ++inner_calls; });
    loop();
    inner.finish();
  }
  loop();
  outer.finish();
  EXPECT_EQ(outer_calls, 100);
  EXPECT_EQ(inner_calls, 100);
}

}  // namespace percuss::meanwhile_test
