#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
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

TEST(ParallelFor, RunsHereAndInOrderOnOneThread) {
  std::vector<std::size_t> order;  // unguarded: a second thread would be a race
  const auto here = std::this_thread::get_id();
  parallel_for(50, 1, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    order.push_back(i);
  });
  std::vector<std::size_t> expected(50);
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(order, expected);
}

TEST(ParallelFor, PassesATasksExceptionOn) {
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

TEST(ShareOut, StaysHereWhereItWouldNotPayOrIsNotAllowed) {
  const auto here = std::this_thread::get_id();
  const auto stays = [&](std::size_t operations) {
    share_out(100, operations, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
  };
  stays(10);
  const ThreadLimit limit(1);
  stays(1'000'000'000);
}

TEST(ShareOut, KeepsItsLimitWithinTasksAndGivesItBack) {
  std::vector<std::atomic<int>> calls(64);
  {
    const ThreadLimit limit(2);
    share_out(8, 1'000'000, [&](std::size_t i) {
      const auto here = std::this_thread::get_id();
      const ThreadLimit one(1);
      share_out(8, 1'000'000, [&](std::size_t j) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        ++calls.at(8 * i + j);
      });
    });
  }
  for (const auto& number : calls) EXPECT_EQ(number, 1);
  std::atomic<int> after{0};
  share_out(8, 1'000'000, [&](std::size_t) { ++after; });
  EXPECT_EQ(after, 8);
}

}  // namespace percuss::parallel_test
