#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/text/version.hpp"
#include "support/help_pages.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The manual pages in roff, made from the declarations of the commands.
namespace percuss::man_command_test {

namespace fs = std::filesystem;
using test::lines_of;
using test::run_percuss;
using testing::ElementsAre;
using testing::HasSubstr;

// The page of a command, which is printed once per process.
const std::string& page_of(const std::vector<std::string>& command) {
  static std::map<std::vector<std::string>, std::string> pages;
  const auto known = pages.find(command);
  if (known != pages.end()) return known->second;
  std::vector<std::string> words{"man"};
  words.insert(words.end(), command.begin(), command.end());
  const auto outcome = run_percuss(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return pages.emplace(command, outcome.out).first->second;
}

std::vector<std::string> sections_of(const std::string& page) {
  std::vector<std::string> sections;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with(".SH ")) sections.push_back(line.substr(4));
  }
  return sections;
}

/// The visible text of a page: escapes resolved, requests removed, lines joined by blanks.
std::string visible_text(const std::string& page) {
  std::string out;
  for (std::string line : lines_of(page)) {
    if (line.starts_with(".")) continue;
    for (const auto& [escape, character] : std::vector<std::pair<std::string, std::string>>{{R"(\-)", "-"},
                                                                                            {R"(\(aq)", "'"},
                                                                                            {R"(\(dq)", "\""},
                                                                                            {R"(\(ha)", "^"},
                                                                                            {R"(\(ti)", "~"},
                                                                                            {R"(\(ga)", "`"},
                                                                                            {R"(\[u2026])", "…"},
                                                                                            {R"(\[u221A])", "√"},
                                                                                            {R"(\[u00B3])", "³"},
                                                                                            {R"(\[u00B2])", "²"},
                                                                                            {R"(\[u00B0])", "°"},
                                                                                            {R"(\[u00B1])", "±"},
                                                                                            {R"(\[u00FC])", "ü"},
                                                                                            {R"(\[u03BA])", "κ"},
                                                                                            {R"(\&)", ""},
                                                                                            {R"(\%)", ""},
                                                                                            {R"(\fB)", ""},
                                                                                            {R"(\fI)", ""},
                                                                                            {R"(\fR)", ""}}) {
      for (std::size_t at = 0; (at = line.find(escape, at)) != std::string::npos; at += character.size())
        line.replace(at, escape.size(), character);
    }
    out += (out.empty() ? "" : " ") + line;
  }
  return out;
}

/// A text with its line breaks replaced by blanks.
std::string on_one_line(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || (!out.empty() && out.back() != ' ')) out += blank ? ' ' : c;
  }
  return out;
}

TEST(ManCommand, GivesEveryCommandAPageWithItsSections) {
  for (const auto& command : test::commands()) {
    const std::string& page = page_of(command);
    auto sections = sections_of(page);
    std::erase(sections, "EXAMPLES");
    EXPECT_THAT(sections, ElementsAre("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "SEE ALSO"));
    EXPECT_THAT(lines_of(page).front(), HasSubstr(std::string("\"percuss ") + report::version() + "\""));
  }
}

// The page contains each option, help text and example of --help.
TEST(ManCommand, ContainsTheTextOfHelp) {
  for (const auto& command : test::commands()) {
    const std::string page = on_one_line(visible_text(page_of(command)));
    const std::string& help = test::help_of(command);
    std::string entry;
    std::size_t entries = 0;
    for (const std::string& line : lines_of(help + "\nend\n")) {
      const bool continues = line.starts_with("       ");
      if (!continues && !entry.empty()) {
        EXPECT_THAT(page, HasSubstr(on_one_line(entry))) << test::joined(command);
        ++entries;
      }
      if (!continues) entry = line.starts_with("  -") ? line.substr(2) : "";
      if (continues && !entry.empty()) entry += line;
    }
    EXPECT_EQ(entries, test::option_names(command).size());
    for (const std::string& line : test::example_lines(command)) EXPECT_THAT(page, HasSubstr(line));
  }
}

TEST(ManCommand, GroupsOptionsAsHelpDoes) {
  const std::string &help = test::help_of({"analyze"}), &page = page_of({"analyze"});
  for (const std::string group : {"Reading", "Analysis", "Output"}) {
    EXPECT_THAT(help, HasSubstr("\n" + group + ":\n"));
    EXPECT_THAT(page, HasSubstr("\n.SS " + group + "\n"));
  }
}

// A line that begins with a dot or an apostrophe is a request; a lone backslash begins an escape.
TEST(ManCommand, EscapesAccidentalRequests) {
  for (const auto& command : test::commands()) {
    for (const std::string& line : lines_of(page_of(command))) {
      EXPECT_THAT(line, testing::Not(testing::StartsWith("'")));
      if (line.starts_with(".")) {
        EXPECT_THAT(line, testing::ContainsRegex(R"(^\.(TH|SH|SS|TP|PP|RS|RE|nf|fi)( .*)?$)"));
      }
      for (const char c : line) EXPECT_LT(static_cast<unsigned char>(c), 0x80) << line;
    }
  }
}

TEST(ManCommand, WritesAllPagesReproducibly) {
  const test::ScratchFolder folder;
  ASSERT_EQ(run_percuss({"man", "--folder", folder.file("man1")}).code, 0);
  std::size_t pages = 0;
  for (const auto& command : test::commands()) {
    std::string name = test::joined({"percuss", test::joined(command)});
    if (command.empty()) name = "percuss";
    std::replace(name.begin(), name.end(), ' ', '-');
    EXPECT_EQ(test::bytes_of(folder.file("man1/" + name + ".1")), page_of(command));
    ++pages;
  }
  const auto files = std::distance(fs::directory_iterator(folder.file("man1")), fs::directory_iterator());
  EXPECT_EQ(static_cast<std::size_t>(files), pages);
}

TEST(ManCommand, OverwritesOnlyWhenForced) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("percuss.1"), "mine");
  EXPECT_EQ(run_percuss({"man", "--folder", folder.path()}).code, 3);
  EXPECT_EQ(test::bytes_of(folder.file("percuss.1")), "mine");
  EXPECT_EQ(run_percuss({"man", "--folder", folder.path(), "--force"}).code, 0);
  EXPECT_EQ(test::bytes_of(folder.file("percuss.1")), page_of({}));
}

TEST(ManCommand, RejectsUnknownPages) {
  EXPECT_THAT(run_percuss({"man", "anaylze"}).err, HasSubstr("did you mean analyze?"));
  EXPECT_THAT(run_percuss({"man", "model", "baem"}).err, HasSubstr("did you mean beam?"));
  EXPECT_EQ(run_percuss({"man", "beam"}).code, 2);
  EXPECT_EQ(run_percuss({"man", "analyze", "frf"}).code, 2);
  EXPECT_EQ(run_percuss({"man", "analyze", "--folder", "x"}).code, 2);
}

// The exit codes of the pages are those in README.
TEST(ManCommand, AgreesWithReadmeOnExitCodes) {
  const std::string page = on_one_line(visible_text(page_of({})));
  std::string table;
  for (const std::string& line : lines_of(test::bytes_of(std::string(PERCUSS_SOURCE_DIR) + "/README.md"))) {
    if (line.size() < 5 || line.substr(0, 2) != "| " || line[2] < '0' || line[2] > '9' || line[3] != ' ') continue;
    table += " " + line.substr(2, 1) + " " + line.substr(6, line.size() - 8);
  }
  EXPECT_GT(table.size(), 50U);
  EXPECT_THAT(page, HasSubstr(table + " percuss-"));
}

// The table in README lists every command.
TEST(ManCommand, AgreesWithReadmeOnCommands) {
  const std::string readme = test::bytes_of(std::string(PERCUSS_SOURCE_DIR) + "/README.md");
  for (const auto& command : test::commands()) {
    if (command.empty() || command == std::vector<std::string>{"model"}) continue;
    EXPECT_THAT(readme, HasSubstr("| `percuss " + test::joined(command)));
  }
}

}  // namespace percuss::man_command_test
