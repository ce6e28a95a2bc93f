#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "report/text/text_table.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/terminal_process.hpp"

// Output on a terminal: colours, pictures and the width of tables.
namespace percuss::terminal_command_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// What percuss writes on a terminal of this width.
std::string on_terminal(const std::vector<std::string>& words, unsigned short columns,
                        const std::vector<std::string>& environment = {}) {
  test::TerminalProcess process(words, {.folder = "", .columns = columns, .environment = environment});
  EXPECT_EQ(process.wait(), 0);
  return process.screen();
}

// In characters, without the line of the file's name and without the terminal's carriage returns.
std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& line : test::lines_of(text)) {
    if (line.find("bat.h5") != std::string::npos) continue;
    const std::size_t returns = static_cast<std::size_t>(std::count(line.begin(), line.end(), '\r'));
    longest = std::max(longest, report::text_width(line) - returns);
  }
  return longest;
}

class Terminal : public testing::Test {
 protected:
  Terminal() { test::write_small_test(record_, R"("hits": 3, "faults": [{"hit": 1, "kind": "missing"}])"); }
  test::ScratchFolder folder_;
  std::string record_ = folder_.file("bat.h5");
  std::vector<std::string> analyze_{"analyze", record_, "--only", "hits"};
};

TEST_F(Terminal, ShowsVerdictsAndWarningsInColour) {
  EXPECT_THAT(on_terminal(analyze_, 100),
              AllOf(HasSubstr("\033[31mrejected\033[0m: "), HasSubstr("\033[32mok\033[0m"), HasSubstr("\033[33m! ")));
  EXPECT_THAT(on_terminal(analyze_, 100, {"NO_COLOR=1"}), Not(HasSubstr("\033[")));
  EXPECT_THAT(test::run_percuss(analyze_).out, Not(HasSubstr("\033[")));
  analyze_.emplace_back("--json");
  EXPECT_THAT(on_terminal(analyze_, 100), Not(HasSubstr("\033[")));
}

TEST_F(Terminal, SetsTheWidthUpTo140) {
  EXPECT_LE(longest_line(on_terminal(analyze_, 60, {"NO_COLOR=1"})), 60U);
  EXPECT_LE(longest_line(on_terminal(analyze_, 400, {"NO_COLOR=1"})), 140U);
}

TEST_F(Terminal, ShowsAPictureOfEachChannel) {
  EXPECT_THAT(on_terminal({"info", record_}, 120), AllOf(HasSubstr("█"), HasSubstr("▁▁▁")));
  EXPECT_THAT(test::run_percuss({"info", record_}).out, Not(HasSubstr("█")));
}

}  // namespace percuss::terminal_command_test
