#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/text/version.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

// The program as a whole: help, version, and errors of the command line.
namespace percuss::percuss_command_test {

using test::run_percuss;
using testing::HasSubstr;

TEST(PercussCommand, PrintsItsVersion) {
  const auto outcome = run_percuss({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, std::string("percuss ") + report::version() + "\n");
}

TEST(PercussCommand, ListsItsCommands) {
  const auto outcome = run_percuss({"--help"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* command : {"analyze", "frf", "info", "calibrate", "synth"})
    EXPECT_THAT(outcome.out, HasSubstr(command));
}

TEST(PercussCommand, ReportsAnInvalidCommandLineInOneLine) {
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"fly"},
                                                    {"--fly"},
                                                    {"analyze"},
                                                    {"frf"},
                                                    {"info"},
                                                    {"calibrate"},
                                                    {"synth"},
                                                    {"analyze", "--fs"},
                                                    {"analyze", "x.h5", "--fs", "fast"},
                                                    {"analyze", "x.h5", "--threads", "-1"}};
  for (const auto& arguments : wrong) {
    const auto outcome = run_percuss(arguments);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("percuss: "));
  }
  EXPECT_THAT(run_percuss({"fly"}).err, HasSubstr("fly"));
}

TEST(PercussCommand, PrintsHelpByACommandToo) {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{}, {"frf"}, {"model", "beam"}}) {
    std::vector<std::string> by_command{"help"}, by_option = command;
    by_command.insert(by_command.end(), command.begin(), command.end());
    by_option.emplace_back("--help");
    const auto outcome = run_percuss(by_command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, run_percuss(by_option).out);
  }
}

TEST(PercussCommand, AcceptsValuesInEitherLetterCaseAndRangesAsTwoNumbers) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("hits.h5"));
  const auto analyzed = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"analyze", folder.file("hits.h5"), "--json"});
    const auto outcome = run_percuss(options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string expected = analyzed({"--band", "60:1500", "--estimator", "h2"});
  EXPECT_EQ(analyzed({"--band", "60", "1500", "--estimator", "H2"}), expected);
  EXPECT_EQ(analyzed({"--band", "+60:1.5D3", "--estimator", "h2", "--overlay-db", "1.0D0"}), expected);
  EXPECT_NE(analyzed({"--band", "60:1500"}), expected);
}

// The text without its paragraphs "! …", whose later lines are indented, and without blank lines at its end.
std::string without_warnings(const std::string& text) {
  std::string out;
  bool warning = false;
  for (const std::string& line : test::lines_of(text)) {
    warning = line.starts_with("! ") || (warning && line.starts_with("  "));
    if (!warning) out += line + "\n";
  }
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

// --quiet leaves out the progress and the warnings, not the result.
TEST(PercussCommand, PrintsTheResultInQuiet) {
  const test::ScratchFolder folder;
  const auto run = [&](const std::vector<std::string>& words) { return run_percuss(words, {.folder = folder.path()}); };
  test::write_small_test(folder.file("hits.h5"));
  const test::SmallRecord small = test::small_record();
  test::write_columns(folder.file("responses.csv"), "time_s,accel_g", {small.time_s, small.accel_mps2});
  EXPECT_THAT(run({"analyze", "responses.csv"}).out, HasSubstr("! no force was recorded"));
  test::write_bytes(folder.file("session.json"), run({"certify", "--example"}).out);
  test::write_bytes(folder.file("log.json"), run({"abi", "--example"}).out);
  test::write_bytes(folder.file("bats.csv"), run({"study", "--example"}).out);
  test::write_bytes(folder.file("modes.json"), run({"analyze", "hits.h5", "--effort", "quick", "--json"}).out);
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"model", "beam"},
                                             {"model", "shell"},
                                             {"metrics", "--length-in", "33"},
                                             {"certify", "session.json"},
                                             {"abi", "log.json"},
                                             {"study", "bats.csv"},
                                             {"compare", "modes.json", "modes.json"},
                                             {"info", "hits.h5"},
                                             {"analyze", "hits.h5", "--effort", "quick"},
                                             {"deflect", "hits.h5", "--effort", "quick"},
                                             {"survey", "hits.h5", "--effort", "quick"},
                                             {"analyze", "responses.csv"},
                                             {"synth", "wood-bat", "-o", "wood.h5", "--force"}}) {
    std::vector<std::string> quiet = command;
    quiet.emplace_back("--quiet");
    const auto outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << testing::PrintToString(command) << outcome.err;
    EXPECT_NE(outcome.out, "") << testing::PrintToString(command);
    EXPECT_EQ(run(quiet).out, without_warnings(outcome.out)) << testing::PrintToString(command);
    EXPECT_EQ(run(quiet).err, "") << testing::PrintToString(command);
  }
}

TEST(PercussCommand, PrintsTheSummaryOfABatchInQuiet) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("hits.h5"));
  const auto run = [&](std::vector<std::string> words) {
    words.emplace_back("--quiet");
    const auto outcome = run_percuss(words, {.folder = folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  EXPECT_THAT(run({"batch", "plan", "hits.h5", "--effort", "quick", "-o", "m.jsonl"}), HasSubstr("1 record"));
  EXPECT_THAT(run({"batch", "run", "--manifest", "m.jsonl", "-o", "out"}), HasSubstr("1 records finished"));
  EXPECT_THAT(run({"batch", "merge", "--manifest", "m.jsonl", "out", "-o", "all.csv"}), HasSubstr("1 records"));
}

TEST(PercussCommand, ReportsThatStandardOutputIsFull) {
  const auto outcome = run_percuss({"synth", "--list"}, {.output = "/dev/full"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("could not write to standard output"));
}

}  // namespace percuss::percuss_command_test
