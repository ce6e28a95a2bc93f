#include "batch/retries.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "core/error.hpp"

namespace percuss::batch::retries_test {

using std::chrono::milliseconds;

// Work that counts its attempts and fails `failures` times.
struct Work {
  int failures = 0, attempts = 0;
  void operator()() {
    if (++attempts <= failures) throw MachineFault("the disk is full", "x", "free some space");
  }
};

TEST(Retries, RepeatAfterEachWait) {
  const std::vector<milliseconds> waits{milliseconds(1), milliseconds(1)};
  Retries retries(waits);
  Work work{.failures = 2};
  retries.run([&] { work(); });
  EXPECT_EQ(work.attempts, 3);
}

TEST(Retries, TryOnceWhileAFaultLasts) {
  const std::vector<milliseconds> waits{milliseconds(1), milliseconds(1)};
  Retries retries(waits);
  Work first{.failures = 9}, second{.failures = 9}, third{.failures = 9};
  EXPECT_THROW(retries.run([&] { first(); }), MachineFault);
  EXPECT_THROW(retries.run([&] { second(); }), MachineFault);
  retries.end_of_fault();
  EXPECT_THROW(retries.run([&] { third(); }), MachineFault);
  EXPECT_EQ(first.attempts, 3);
  EXPECT_EQ(second.attempts, 1);
  EXPECT_EQ(third.attempts, 3);
}

// Another thread may end the fault between the last failure and the decision to give up.
TEST(Retries, GiveUpAlthoughTheFaultEndsMeanwhile) {
  const std::vector<milliseconds> none;
  Retries retries(none);
  std::atomic<bool> stop = false;
  std::thread other([&] {
    while (!stop) retries.end_of_fault();
  });
  int given_up = 0;
  constexpr int kAttempts = 100'000;
  for (int i = 0; i < kAttempts; ++i) {
    Work work{.failures = 1};
    try {
      retries.run([&] { work(); });
    } catch (const MachineFault&) {
      ++given_up;
    }
    if (work.attempts != 1) break;
  }
  stop = true;
  other.join();
  EXPECT_EQ(given_up, kAttempts);
}

}  // namespace percuss::batch::retries_test
