#include "pipeline/live/quality_worker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>

namespace percuss::pipeline::quality_worker_test {
namespace {

using namespace std::chrono_literals;

// Keeps the fit of a record waiting until it is opened.
struct Gate {
  std::promise<void> begun, opened;
  std::shared_future<void> open{opened.get_future()};
  std::once_flag once;
};

// Rows of a response without a blow, so that their analysis is short.
acquire::Record quiet_record(std::size_t blows, Gate& gate) {
  acquire::Record record;
  record.format = "test";
  record.fs_Hz = 1000;
  record.force = {.name = "force", .unit = "N"};
  record.accel = {{.name = "accel 1", .unit = "m/s^2"}};
  record.rows.assign(blows, {.samples = 256});
  record.read_force_N = [&gate](std::size_t, std::size_t, std::span<double> out) {
    std::call_once(gate.once, [&] { gate.begun.set_value(); });
    gate.open.wait();
    std::fill(out.begin(), out.end(), 0.0);
  };
  record.read_accel_mps2 = [](std::size_t, std::size_t, std::size_t, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0.0);
  };
  return record;
}

std::size_t blows_of_next_result(QualityWorker& worker) {
  for (int i = 0; i < 12000; ++i) {
    if (const auto quality = worker.take()) return quality->blows;
    std::this_thread::sleep_for(5ms);
  }
  return 0;
}

// Blows may come faster than fits end. Each finished result is shown all the same, not only the last one.
TEST(QualityWorker, ShowsResultsWhileNewerBlowsWait) {
  Gate first, second;
  QualityWorker worker({});
  worker.ask(quiet_record(1, first));
  first.begun.get_future().wait();
  worker.ask(quiet_record(2, second));
  first.opened.set_value();
  EXPECT_EQ(blows_of_next_result(worker), 1U);
  second.begun.get_future().wait();
  EXPECT_FALSE(worker.take());
  second.opened.set_value();
  EXPECT_EQ(blows_of_next_result(worker), 2U);
}

TEST(QualityWorker, LeavesOutResultsOfBlowsThatDoNotCountAnyLonger) {
  Gate first, second;
  QualityWorker worker({});
  worker.ask(quiet_record(3, first));
  first.begun.get_future().wait();
  worker.discard();
  worker.ask(quiet_record(2, second));
  first.opened.set_value();
  second.begun.get_future().wait();
  EXPECT_FALSE(worker.take());
  second.opened.set_value();
  EXPECT_EQ(blows_of_next_result(worker), 2U);
}

}  // namespace
}  // namespace percuss::pipeline::quality_worker_test
