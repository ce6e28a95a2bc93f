#include "acquire/sandbox/fork_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <variant>

#include "acquire/open_measurement.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::fork_server_test {

using testing::HasSubstr;

/// Serves a row of numbers that count from the length of the path. The paths "crash" and "refuse" fail.
SandboxService counting(const std::string& path) {
  if (path == "crash") std::abort();
  if (path == "refuse") throw InputError("refused", path, "ask for another");
  const auto start = static_cast<double>(path.size());
  return {.description = path, .read = [start](std::size_t, std::size_t, std::size_t first, std::span<double> out) {
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = start + static_cast<double>(first + i);
          }};
}

std::string refusal(const std::shared_ptr<ForkServer>& fork_server, const std::string& path) {
  try {
    const SandboxProcess process(path, fork_server);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(ForkServer, ForksReaders) {
  const auto fork_server = std::make_shared<ForkServer>(counting);
  SandboxProcess process("four", fork_server);
  EXPECT_EQ(process.description(), "four");
  std::vector<double> numbers(300'000);  // more than one transfer
  process.read(0, 0, 10, numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], 14.0 + static_cast<double>(i));
}

TEST(ForkServer, ServesSeveralThreads) {
  const auto fork_server = std::make_shared<ForkServer>(counting);
  parallel_for(40, 2, [&](std::size_t i) {
    const std::string path(i + 1, 'x');
    SandboxProcess process(path, fork_server);
    std::vector<double> numbers(5);
    process.read(0, 0, 0, numbers);
    EXPECT_EQ(numbers[4], static_cast<double>(i + 1) + 4);
  });
}

TEST(ForkServer, ReportsErrorsAndCrashesOfReaders) {
  const auto fork_server = std::make_shared<ForkServer>(counting);
  EXPECT_THAT(refusal(fork_server, "refuse"), HasSubstr("refused (refuse)"));
  EXPECT_THAT(refusal(fork_server, "crash"), HasSubstr("crashes the library that reads it"));
  EXPECT_EQ(refusal(fork_server, "fine"), "");  // the server still runs
  EXPECT_FALSE(fork_server->lost());
}

TEST(ForkServer, ReportsUnknownReaders) {
  ForkServer fork_server(counting);
  int status = 0;
  EXPECT_EQ(fork_server.ended(1, status), -1);
  fork_server.kill_and_wait(1, status);
  fork_server.release(1);
  EXPECT_EQ(fork_server.ended(1, status), -1);
  EXPECT_FALSE(fork_server.lost());
}

TEST(ForkServer, OpensTheSameRecordsAsWithoutAServer) {
  const test::ScratchFolder folder;
  FrfReadOptions options;
  options.read.sandboxed = true;
  const auto fork_server = measurement_fork_server(options);
  for (const char* extension : {".h5", ".mat", ".wav", ".csv"}) {
    const std::string path = folder.file(std::string("t") + extension);
    test::write_small_test(path);
    const auto opened = open_measurement_forked(fork_server, path, options), alone = open_measurement(path, options);
    const auto &one = std::get<Record>(opened), &other = std::get<Record>(alone);
    EXPECT_EQ(one.fs_Hz, other.fs_Hz);
    ASSERT_EQ(one.rows.size(), other.rows.size());
    std::vector<double> a(one.rows[0].samples), b(a.size());
    one.read_force_N(0, 0, a);
    other.read_force_N(0, 0, b);
    EXPECT_EQ(a, b) << extension;
  }
}

}  // namespace percuss::acquire::fork_server_test
