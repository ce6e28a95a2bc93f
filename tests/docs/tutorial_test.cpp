#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "support/console_transcript.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The pages' commands, run in the order in which a reader types them, print what the pages show.
namespace percuss::tutorial_test {

using test::LastDigits;
using testing::ElementsAre;
using testing::IsEmpty;

struct CommandResult {
  int code = -1;
  std::vector<std::string> lines;  // of both streams, as a terminal shows them
};

// Runs the script in a new shell that starts with the exit code of the previous command, so that `echo $?` works.
CommandResult run_shell(const std::string& script, const std::string& folder, int code_before) {
  const std::string bin = std::filesystem::path(PERCUSS_EXECUTABLE).parent_path().string();
  const std::string prepared = "exec 2>&1 </dev/null\ncd '" + folder + "' || exit 99\nPATH='" + bin +
                               "':$PATH\n(exit " + std::to_string(code_before) + ")\n" + script + "\n";
  FILE* stream = ::popen(prepared.c_str(), "r");
  if (stream == nullptr) throw std::runtime_error("no shell");
  std::string text;
  std::array<char, 4096> block{};
  for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), stream)) > 0;)
    text.append(block.data(), got);
  const int status = ::pclose(stream);
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .lines = test::lines_of(text)};
}

std::string text_of_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Runs the commands of a page in an empty folder. If an output differs from the page, the test prints the whole output
/// for pasting into the page.
void expect_page_to_print_as_shown(const std::string& page, std::size_t min_commands) {
  const auto commands = test::transcript_commands(test::bytes_of(PERCUSS_SOURCE_DIR "/" + page));
  ASSERT_GE(commands.size(), min_commands) << page << ": too few commands; check the ```console blocks";
  const test::ScratchFolder folder;
  int code = 0;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto& command = commands[i];
    const CommandResult outcome = run_shell(command.script, folder.path(), code);
    code = outcome.code;
    EXPECT_TRUE(test::matches_transcript(command.expected, outcome.lines, test::last_digits_of_this_build()))
        << page << ":" << command.line << " differs from the output, which is:\n$ " << command.script << "\n"
        << text_of_lines(outcome.lines);
    const bool code_is_shown = i + 1 < commands.size() && commands[i + 1].script == "echo $?";
    EXPECT_TRUE(code == 0 || code_is_shown)
        << page << ":" << command.line << ": exit code " << code << " of\n$ " << command.script << "\n"
        << text_of_lines(outcome.lines);
  }
}

TEST(ConsolePage, HoldsCommandsAndWhatTheyPrint) {
  const auto commands = test::transcript_commands(
      "text\n```console\n$ cat > a <<END\n> 1\n> END\n$ cat a\n1\n```\n```\n$ not this\n```\n```console\n$ "
      "echo\n\n```\n");
  ASSERT_EQ(commands.size(), 3U);
  EXPECT_EQ(commands[0].script, "cat > a <<END\n1\nEND");
  EXPECT_THAT(commands[0].expected, IsEmpty());
  EXPECT_THAT(commands[1].expected, ElementsAre("1"));
  EXPECT_THAT(commands[2].expected, ElementsAre(""));
  EXPECT_EQ(commands[2].line, 13U);
}

bool same_line(std::string_view shown, std::string_view printed) {
  return test::same_line(shown, printed, LastDigits::rounded);
}

bool matches_transcript(const std::vector<std::string>& shown, const std::vector<std::string>& printed) {
  return test::matches_transcript(shown, printed, LastDigits::rounded);
}

// The last digits of a page went stale unseen, because the comparison for all compilers passed over them.
TEST(ConsolePage, ShowsTheDigitsOfTheReleasedBuild) {
  EXPECT_TRUE(test::same_line("20.0028 ± 0.0016°", "20.0028 ± 0.0016°", LastDigits::equal));
  EXPECT_FALSE(test::same_line("20.0028 ± 0.0014°", "20.0028 ± 0.0016°", LastDigits::equal));
  EXPECT_FALSE(test::matches_transcript({"...", "24.49 ± 0.21 mm"}, {"a", "24.49 ± 0.20 mm"}, LastDigits::equal));
}

TEST(ConsolePage, AllowsTheLastDigitToBeRoundedOtherwise) {
  EXPECT_TRUE(same_line("bending 1  182.00009 ± 0.00025 Hz", "bending 1  182.00011 ± 0.00023 Hz"));
  EXPECT_FALSE(same_line("bending 1  182.00009 ± 0.00025 Hz", "bending 1  182.00012 ± 0.00025 Hz"));
  EXPECT_FALSE(same_line("bending 1  182.00009 ± 0.00025 Hz", "bending 1  182.00009 ± 0.00028 Hz"));
  EXPECT_FALSE(same_line("182.00009 ± 0.00025", "182.0001 ± 0.0003"));
  EXPECT_TRUE(same_line("at 0.0199 s", "at 0.0200 s"));
  EXPECT_FALSE(same_line("at 0.0199 s", "at 0.0201 s"));
  EXPECT_TRUE(same_line("1.1e-05", "1.2e-05"));
  EXPECT_FALSE(same_line("1.1e-05", "1.1e-06"));
}

TEST(ConsolePage, AllowsNothingElse) {
  EXPECT_FALSE(same_line("5 hits", "6 hits"));
  EXPECT_FALSE(same_line("bending 1", "bending 2"));
  EXPECT_FALSE(same_line("0.1 mm", "0.1 m"));
  EXPECT_FALSE(same_line("0.1 m", "0.1 mm"));
  EXPECT_FALSE(same_line("0.1", " 0.1"));
  EXPECT_FALSE(same_line("-0.1", "+0.1"));
  EXPECT_FALSE(same_line("10", "1"));
  EXPECT_FALSE(same_line("", "1"));
}

TEST(ConsolePage, LeavesLinesOutWhereDotsStandForThem) {
  EXPECT_TRUE(matches_transcript({"a", "...", "d"}, {"a", "b", "c", "d"}));
  EXPECT_TRUE(matches_transcript({"a", "...", "d"}, {"a", "d", "d"}));
  EXPECT_TRUE(matches_transcript({"a", "..."}, {"a"}));
  EXPECT_FALSE(matches_transcript({"a", "...", "d"}, {"a", "b"}));
  EXPECT_FALSE(matches_transcript({"...", "b", "..."}, {"a", "c"}));
  EXPECT_FALSE(matches_transcript({"a"}, {"a", "b"}));
  EXPECT_FALSE(matches_transcript({"a", "b"}, {"a"}));
  EXPECT_FALSE(matches_transcript({}, {"a"}));
}

// The minimum number of commands of each page: a page with malformed blocks would pass without running any command.
TEST(Tutorial, OfABatPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/bat.md", 12); }
TEST(Tutorial, OfNodesPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/nodes.md", 6); }
TEST(Tutorial, OfAFirstTestPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/first-test.md", 6); }
TEST(Tutorial, OfASurveyPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/survey.md", 6); }
TEST(Tutorial, OfADeflectionPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/deflection.md", 8); }
TEST(Tutorial, OfACertificationPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/certify.md", 8); }
TEST(Tutorial, OfTheSourcesPrintsWhatItShows) {
  expect_page_to_print_as_shown("docs/project/sources-reproduced.md", 47);
}
TEST(Tutorial, OfThreeBatsPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/three-bats.md", 22); }
TEST(Tutorial, OfABatchPrintsWhatItShows) { expect_page_to_print_as_shown("docs/tutorials/batch.md", 20); }
TEST(Tutorial, OfRecordingDevicesPrintsWhatItShows) {
  expect_page_to_print_as_shown("docs/guides/recording-devices.md", 3);
}
TEST(Tutorial, ReadmePrintsWhatItShows) { expect_page_to_print_as_shown("README.md", 2); }

}  // namespace percuss::tutorial_test
