#include "core/parallel/per_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace percuss::per_thread_test {

std::atomic<int> alive{0};

struct Counted {
  Counted() { ++alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --alive; }
  int number = 0;
};

TEST(PerThread, KeepsOneValuePerThreadUntilTheThreadEnds) {
  static const PerThread<Counted> counted;
  std::thread([] {
    counted.local().number = 1;
    EXPECT_EQ(counted.local().number, 1);
    std::thread([] {
      EXPECT_EQ(counted.local().number, 0);
      EXPECT_EQ(alive, 2);
    }).join();
    EXPECT_EQ(counted.local().number, 1);
    EXPECT_EQ(alive, 1);
  }).join();
  EXPECT_EQ(alive, 0);
}

}  // namespace percuss::per_thread_test
