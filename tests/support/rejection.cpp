#include "support/rejection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/scratch_folder.hpp"

namespace percuss::test {
namespace {

constexpr std::size_t kMaxMemory_bytes = std::size_t{1} << 30U;

}  // namespace

std::string rejection_of(const std::vector<std::string>& arguments, const std::vector<std::string>& outputs,
                         const std::string& named, const ProcessOptions& options) {
  SCOPED_TRACE(testing::PrintToString(arguments));
  const ScratchFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  auto words = arguments;
  for (const auto& extension : outputs) words.insert(words.end(), {"-o", folder.file("out" + extension)});
  const auto outcome = run_percuss(words, options);
  EXPECT_FALSE(outcome.timed_out);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_THAT(outcome.err,
              testing::AllOf(testing::StartsWith("percuss: "), testing::HasSubstr(named), testing::HasSubstr("; ")));
  EXPECT_THAT(outcome.err, testing::Not(testing::AnyOf(testing::HasSubstr("\x1b"), testing::HasSubstr("std::"))));
  EXPECT_LT(outcome.peak_bytes, kMaxMemory_bytes);
  EXPECT_THAT(folder.names(), testing::IsEmpty());
  return outcome.err;
}

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& named) {
  const auto outcome = run_percuss(arguments);
  EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
  EXPECT_THAT(outcome.err, testing::HasSubstr(named));
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
}

void expect_analyses_reject(const std::string& path, const std::string& named, const ProcessOptions& options) {
  rejection_of({"analyze", path}, {".json", ".csv", ".h5"}, named, options);
  rejection_of({"frf", path}, {".csv", ".h5", ".json"}, named, options);
}

void expect_reading_commands_reject(const std::string& path, const std::string& named, const ProcessOptions& options) {
  expect_analyses_reject(path, named, options);
  rejection_of({"calibrate", path, "--mass", "1"}, {".json"}, named, options);
  rejection_of({"info", path}, {".json"}, named, options);
}

}  // namespace percuss::test
