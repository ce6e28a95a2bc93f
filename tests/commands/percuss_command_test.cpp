#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/text/version.hpp"
#include "support/percuss_process.hpp"

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

TEST(PercussCommand, ReportsThatStandardOutputIsFull) {
  const auto outcome = run_percuss({"synth", "--list"}, {.output = "/dev/full"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("could not write to standard output"));
}

}  // namespace percuss::percuss_command_test
