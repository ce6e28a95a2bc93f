#include "core/budget.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "core/parallel/parallel.hpp"
#include "core/sanitized.hpp"

namespace percuss::budget_test {

void wait_s(double time_s) { std::this_thread::sleep_for(std::chrono::duration<double>(time_s)); }

// The resource that `work` runs out of.
template <class Work>
Resource spent_by(BudgetMeter& meter, const Work& work) {
  const BudgetScope scope(meter);
  try {
    work();
  } catch (const BudgetSpent& error) {
    return error.resource();
  }
  throw std::logic_error("the budget was not spent");
}

TEST(Budget, IsAtLeastTwoMinutesAndTwoGibibytesAndGrowsWithTheInput) {
  EXPECT_EQ(default_budget(0).time_s, 120 * kSlowness);
  EXPECT_EQ(default_budget(0).memory_bytes, std::uint64_t{1} << 31U);
  EXPECT_EQ(default_budget(100'000'000).time_s, 320 * kSlowness);
  EXPECT_EQ(default_budget(100'000'000).memory_bytes, (std::uint64_t{1} << 31U) + 1'600'000'000);
}

TEST(Budget, EndsWorkThatTakesLonger) {
  BudgetMeter meter({.time_s = 0.01}, "a.h5");
  const auto endless = [] {
    for (;;) check_budget();
  };
  EXPECT_EQ(spent_by(meter, endless), Resource::time);
}

TEST(Budget, EndsTheTasksOfAllThreads) {
  BudgetMeter meter({.time_s = 0.01}, "a.h5");
  const auto endless = [] {
    parallel_for(4, 0, [](std::size_t) {
      for (;;) check_budget();
    });
  };
  EXPECT_EQ(spent_by(meter, endless), Resource::time);
}

TEST(Budget, IsCheckedBeforeEachTaskOfALoop) {
  for (const std::size_t threads : {1U, 2U}) {
    BudgetMeter meter({.time_s = 0.01}, "a.h5");
    const auto many = [&] { parallel_for(1'000'000, threads, [](std::size_t) { wait_s(0.001); }); };
    EXPECT_EQ(spent_by(meter, many), Resource::time);
  }
}

TEST(Budget, CountsTheTimeWithinItsScopesOnly) {
  BudgetMeter meter({.time_s = 0.05}, "a.h5");
  for (int i = 0; i < 3; ++i) {
    wait_s(0.03);
    const BudgetScope scope(meter);
    EXPECT_NO_THROW(check_budget());
  }
}

TEST(Budget, AddsTheTimeOfItsScopes) {
  BudgetMeter meter({.time_s = 0.05}, "a.h5");
  for (int i = 0; i < 3; ++i) {
    const BudgetScope scope(meter);
    const BudgetScope within_it(meter);  // is not counted twice
    wait_s(0.02);
  }
  EXPECT_EQ(spent_by(meter, check_budget), Resource::time);
}

TEST(Budget, EndsWorkThatTakesMoreMemory) {
  constexpr std::size_t kBlock_bytes = 33U << 20U;  // above 32 MiB, malloc maps each block anew
  BudgetMeter meter({.memory_bytes = 5 * kBlock_bytes}, "a.h5");
  std::vector<std::vector<char>> held;
  const auto greedy = [&] {
    for (;;) {
      held.emplace_back(kBlock_bytes, 'x');  // writes to every page
      wait_s(0.011);                         // longer than the interval between two measurements
      check_budget();
    }
  };
  EXPECT_EQ(spent_by(meter, greedy), Resource::memory);
  EXPECT_LE(held.size(), 7U);  // one block within an interval, and rounding
}

TEST(Budget, AddsTheMemoryLimitsOfConcurrentAnalyses) {
  constexpr std::size_t kBlock_bytes = 1U << 24U;
  BudgetMeter small({.memory_bytes = 2 * kBlock_bytes}, "a.h5");
  const BudgetMeter large({.memory_bytes = 100 * kBlock_bytes}, "b.h5");
  std::vector<std::vector<char>> held;
  const BudgetScope scope(small);
  for (int i = 0; i < 8; ++i) held.emplace_back(kBlock_bytes, 'x');
  EXPECT_NO_THROW(check_budget());
}

TEST(Budget, NamesItsLimitTheInputAndTheOptions) {
  BudgetMeter meter({.time_s = 1e-9}, "a.h5");
  const BudgetScope scope(meter);
  wait_s(0.001);
  try {
    check_budget();
    FAIL();
  } catch (const BudgetSpent& error) {
    EXPECT_STREQ(error.what(),
                 "the analysis is not finished after its budget of 1e-09 s (a.h5); limit the band, choose a lower "
                 "effort, or raise the budget");
    EXPECT_EQ(error.options(), (std::vector<OptionId>{"band", "effort", "budget"}));
  }
}

TEST(Budget, OfAModelNamesItsOptionOnly) {
  BudgetMeter meter({.time_s = 0}, "model bat", BudgetedWork::model);
  const BudgetScope scope(meter);
  wait_s(0.001);
  try {
    check_budget();
    FAIL();
  } catch (const BudgetSpent& error) {
    EXPECT_STREQ(error.what(),
                 "the model is not finished after its budget of 0 s (model bat); ask for fewer values, modes or steps, "
                 "or raise the budget");
    EXPECT_EQ(error.options(), std::vector<OptionId>{"budget"});
  }
}

TEST(Budget, DoesNotLimitWithoutAScope) { EXPECT_NO_THROW(check_budget()); }

thread_local int polls_until_interrupt = 0;
bool interrupt_after_polls() { return --polls_until_interrupt <= 0; }

TEST(Interrupt, EndsTheComputationsOfAllThreads) {
  const InterruptScope polled(&interrupt_after_polls);
  polls_until_interrupt = 2;
  std::vector<std::unique_ptr<BudgetMeter>> meters;
  for (int i = 0; i < 4; ++i) meters.push_back(std::make_unique<BudgetMeter>(Budget{.time_s = 60}, "a.h5"));
  EXPECT_THROW(parallel_for(4, 0,
                            [&](std::size_t i) {
                              const BudgetScope scope(*meters[i]);
                              for (;;) check_budget();
                            }),
               Interrupted);
  EXPECT_LE(polls_until_interrupt, 0);
}

TEST(Interrupt, LeavesAMeterUsableInALaterScope) {
  BudgetMeter meter({.time_s = 60}, "a.h5");
  const auto work = [&meter](int checks) {
    const BudgetScope scope(meter);
    for (int i = 0; i < checks; ++i) check_budget();
  };
  {
    const InterruptScope polled(&interrupt_after_polls);
    polls_until_interrupt = 1;
    EXPECT_THROW(work(1'000'000'000), Interrupted);
    EXPECT_THROW(work(1), Interrupted);
  }
  const InterruptScope polled(&interrupt_after_polls);
  polls_until_interrupt = 1'000'000;
  EXPECT_NO_THROW(work(1000));
}

TEST(Interrupt, PollsOnlyTheThreadOfTheScope) {
  const InterruptScope polled(&interrupt_after_polls);
  polls_until_interrupt = 1;  // of this thread; a new thread begins with 0 and would interrupt at once
  BudgetMeter meter({.time_s = 60}, "a.h5");
  std::thread([&meter] {
    const BudgetScope scope(meter);
    EXPECT_NO_THROW(for (int i = 0; i < 1000; ++i) check_budget());
  }).join();
}

}  // namespace percuss::budget_test
