#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "report/version.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The program as a whole: its help, its version, and what it says to a wrong command line.
namespace percuss::percuss_command_test {

using test::run_percuss;
using testing::HasSubstr;

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The arguments of every example that a help text shows.
std::vector<std::vector<std::string>> examples_in(const std::string& help) {
  std::vector<std::vector<std::string>> examples;
  for (const auto& line : test::lines_of(help)) {
    std::smatch found;
    if (std::regex_search(line, found, std::regex("Example: percuss (.*)"))) examples.push_back(words_of(found[1]));
  }
  return examples;
}

TEST(PercussCommand, TellsItsVersion) {
  const auto outcome = run_percuss({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, std::string("percuss ") + version() + "\n");
}

TEST(PercussCommand, ListsItsCommands) {
  const auto outcome = run_percuss({"--help"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* command : {"analyze", "frf", "info", "calibrate", "synth"})
    EXPECT_THAT(outcome.out, HasSubstr(command));
}

TEST(PercussCommand, ShowsExamplesThatWork) {
  const test::ScratchFolder folder;
  ASSERT_EQ(run_percuss({"synth", "wood-bat", "-o", folder.file("bat.h5")}).code, 0);
  std::string hits = "t_s,CH8,acc_m_s2\n";
  for (int i = 0; i < 1000; ++i) {
    const bool hit = i >= 300 && i < 320;
    hits += std::to_string(i / 1000.0) + (hit ? ",1000,8\n" : i % 2 == 0 ? ",1,0\n" : ",-1,0\n");
  }
  test::write_bytes(folder.file("hits.csv"), hits);
  for (const char* command : {"analyze", "frf", "info", "calibrate", "synth"}) {
    const auto help = run_percuss({command, "--help"});
    EXPECT_EQ(help.code, 0);
    const auto examples = examples_in(help.out);
    EXPECT_FALSE(examples.empty()) << command << " shows no example";
    for (const auto& example : examples) {
      const auto outcome = run_percuss(example, {.folder = folder.path()});
      EXPECT_EQ(outcome.code, 0) << testing::PrintToString(example) << outcome.err;
      EXPECT_EQ(outcome.err, "");
    }
  }
}

TEST(PercussCommand, AnswersAWrongCommandLineInOneLine) {
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

TEST(PercussCommand, SaysWhenStandardOutputTakesNothingMore) {
  const auto outcome = run_percuss({"synth", "--list"}, {.output = "/dev/full"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("could not write to standard output"));
}

}  // namespace percuss::percuss_command_test
