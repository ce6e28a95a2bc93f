#include "core/parallel/parallel.hpp"
#include "core/parallel/thread_limit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace percuss::parallel_test {

constexpr std::array<std::size_t, 6> kAnyThreads = {0, 1, 2, 7, 1000, std::numeric_limits<std::size_t>::max()};

TEST(ParallelFor, CallsEachTaskOnceOnAnyNumberOfThreads) {
  for (const std::size_t threads : kAnyThreads) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, threads, [&](std::size_t i) { ++calls.at(i); });
      for (const auto& number : calls) EXPECT_EQ(number, 1);
    }
  }
}

TEST(ParallelFor, RunsInOrderOnTheCallingThreadWithOneThread) {
  std::vector<std::size_t> order;  // without a lock: a second thread would be a data race
  const auto here = std::this_thread::get_id();
  parallel_for(50, 1, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    order.push_back(i);
  });
  std::vector<std::size_t> expected(50);
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(order, expected);
}

TEST(ParallelFor, RethrowsTheExceptionOfATask) {
  for (const std::size_t threads : kAnyThreads) {
    const auto work = [&] {
      parallel_for(20, threads, [](std::size_t i) {
        if (i == 13) throw std::runtime_error("task 13");
      });
    };
    try {
      work();
      FAIL() << "no exception on " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "task 13");
    }
  }
}

TEST(ParallelFor, MayBeNested) {
  std::vector<std::atomic<int>> calls(100);
  parallel_for(10, 0, [&](std::size_t i) { parallel_for(10, 0, [&](std::size_t j) { ++calls.at(10 * i + j); }); });
  for (const auto& number : calls) EXPECT_EQ(number, 1);
}

// A cancelled nested loop would return with its work undone and without an error.
TEST(ParallelFor, FinishesANestedLoopWhenTheOuterLoopFails) {
  std::atomic<bool> begun{false}, failed{false};
  std::size_t calls = 0;
  const auto work = [&] {
    parallel_for(2, 2, [&](std::size_t outer) {
      if (outer == 0) {
        for (int ms = 0; ms < 1000 && !begun; ++ms) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        failed = true;
        throw std::runtime_error("outer");
      }
      begun = true;
      while (!failed) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // until the library has cancelled the outer loop
      std::atomic<std::size_t> inner{0};
      parallel_for(1000, 2, [&](std::size_t) { ++inner; });
      calls = inner;
    });
  };
  EXPECT_THROW(work(), std::runtime_error);
  EXPECT_EQ(calls, begun ? 1000U : 0U);
}

TEST(ParallelForChunks, CoversEachIndexOnce) {
  for (const std::size_t size : {0U, 1U, 511U, 512U, 513U, 5000U}) {
    std::vector<int> calls(size);
    parallel_for_chunks(size, 1'000'000, [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) ++calls.at(i);
    });
    EXPECT_EQ(calls, std::vector<int>(size, 1)) << size;
  }
}

TEST(ParallelForCost, RunsShortOrLimitedLoopsOnTheCallingThread) {
  const auto here = std::this_thread::get_id();
  const auto expect_calling_thread = [&](std::size_t flops) {
    parallel_for_cost(100, flops, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
  };
  expect_calling_thread(10);
  const ThreadLimit limit(1);
  expect_calling_thread(1'000'000'000);
}

TEST(ParallelForCost, ObeysAThreadLimitThatATaskSets) {
  std::vector<std::atomic<int>> calls(64);
  {
    const ThreadLimit limit(2);
    parallel_for_cost(8, 1'000'000, [&](std::size_t i) {
      const auto here = std::this_thread::get_id();
      const ThreadLimit one(1);
      parallel_for_cost(8, 1'000'000, [&](std::size_t j) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        ++calls.at(8 * i + j);
      });
    });
  }
  for (const auto& number : calls) EXPECT_EQ(number, 1);
  std::atomic<int> after{0};
  parallel_for_cost(8, 1'000'000, [&](std::size_t) { ++after; });
  EXPECT_EQ(after, 8);
}

TEST(ThreadLimit, RestoresTheLimitThatItReplaced) {
  EXPECT_EQ(current_thread_limit(), 0U);
  {
    const ThreadLimit two(2);
    {
      const ThreadLimit one(1);
      EXPECT_EQ(current_thread_limit(), 1U);
    }
    EXPECT_EQ(current_thread_limit(), 2U);
    EXPECT_THROW(
        {
          const ThreadLimit three(3);
          throw std::runtime_error("work");
        },
        std::runtime_error);
    EXPECT_EQ(current_thread_limit(), 2U);
  }
  EXPECT_EQ(current_thread_limit(), 0U);
}

// The first tasks wait for each other, so that two threads take part if the machine has them.
TEST(ThreadLimit, AppliesToTheTasksOfALoopOnEveryThread) {
  constexpr std::size_t kLimit = 2;
  std::mutex lock;
  std::set<std::thread::id> threads;
  std::atomic<int> wrong{0};
  {
    const ThreadLimit limit(kLimit);
    parallel_for_cost(8, 1'000'000, [&](std::size_t) {
      if (current_thread_limit() != kLimit) ++wrong;
      const auto taking_part = [&] {
        const std::scoped_lock held(lock);
        threads.insert(std::this_thread::get_id());
        return threads.size();
      };
      for (int ms = 0; ms < 1000 && taking_part() < 2; ++ms) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  }
  EXPECT_EQ(wrong, 0);
  // The threads that took part keep no limit. On a machine of one processor, only the calling thread took part.
  std::atomic<int> limited{0};
  parallel_for_cost(8, 1'000'000, [&](std::size_t) {
    if (current_thread_limit() != 0) ++limited;
  });
  EXPECT_EQ(limited, 0);
}

}  // namespace percuss::parallel_test
