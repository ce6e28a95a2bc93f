#include "core/trace.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "core/parallel/parallel.hpp"

namespace percuss::trace_test {

TEST(Trace, IsEmptyBeforeAnythingRan) { EXPECT_TRUE(Trace().stages().empty()); }

TEST(Trace, CountsCallsAndPassesTheResultOn) {
  Trace trace;
  EXPECT_EQ(trace.run("fft", [] { return 7; }), 7);
  EXPECT_EQ(trace.run("fft", [] { return 8; }), 8);
  trace.run("cut", [] {});
  ASSERT_EQ(trace.stages().size(), 2U);
  EXPECT_EQ(trace.stages()[0].name, "cut");  // by name, not by time
  EXPECT_EQ(trace.stages()[0].calls, 1U);
  EXPECT_EQ(trace.stages()[1].name, "fft");
  EXPECT_EQ(trace.stages()[1].calls, 2U);
}

TEST(Trace, AddsUpCallsAndSecondsOfEqualNames) {
  Trace trace;
  const std::string name = "frf";  // another address than the literal's
  trace.add("frf", 3, 0.25);
  trace.add(name.c_str(), 2, 0.5);
  ASSERT_EQ(trace.stages().size(), 1U);
  EXPECT_EQ(trace.stages()[0].calls, 5U);
  EXPECT_EQ(trace.stages()[0].seconds, 0.75);
}

TEST(Trace, MeasuresWallTime) {
  Trace trace;
  const auto start = std::chrono::steady_clock::now();
  trace.run("sleep", [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
  const double outer = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(trace.stages()[0].seconds, 0.020);
  EXPECT_LE(trace.stages()[0].seconds, outer);
}

TEST(Trace, CountsAStageThatThrows) {
  Trace trace;
  EXPECT_THROW(trace.run("read", [] { throw std::runtime_error("no"); }), std::runtime_error);
  ASSERT_EQ(trace.stages().size(), 1U);
  EXPECT_EQ(trace.stages()[0].calls, 1U);
}

TEST(Trace, CountsFromManyThreads) {
  Trace trace;
  parallel_for(1000, 0, [&](std::size_t i) { trace.run(i % 2 == 0 ? "even" : "odd", [] {}); });
  ASSERT_EQ(trace.stages().size(), 2U);
  EXPECT_EQ(trace.stages()[0].calls, 500U);
  EXPECT_EQ(trace.stages()[1].calls, 500U);
}

}  // namespace percuss::trace_test
