#include "core/lazy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace percuss::lazy_test {

TEST(Lazy, ComputesOnceAndOnlyOnDemand) {
  Lazy<int> slot;
  int calls = 0;
  EXPECT_FALSE(slot.ready());
  EXPECT_EQ(slot.get([&] { return ++calls; }), 1);
  EXPECT_EQ(slot.get([&] { return ++calls; }), 1);
  EXPECT_EQ(calls, 1);
}

TEST(Lazy, StaysEmptyWhenTheComputationThrows) {
  Lazy<int> slot;
  EXPECT_THROW(slot.get([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_FALSE(slot.ready());
  EXPECT_EQ(slot.get([] { return 7; }), 7);
}

TEST(Lazy, RejectsAComputationThatUsesItself) {
  Lazy<int> slot;
  const auto self = [&]() -> int { return slot.get([&] { return slot.get([] { return 1; }); }); };
  EXPECT_THROW(self(), std::logic_error);
}

}  // namespace percuss::lazy_test
