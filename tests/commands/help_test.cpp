#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "report/text/text_table.hpp"
#include "support/help_pages.hpp"
#include "support/percuss_process.hpp"

// The text of --help, compared with the behaviour of the program.
namespace percuss::help_test {

using test::lines_of;
using testing::HasSubstr;

/// The help text of an option, its lines joined; "" if the command has no such option.
std::string explanation(const std::string& help, const std::string& option) {
  std::string text;
  bool within = false;
  for (const std::string& line : lines_of(help)) {
    const bool begins = line.starts_with("  -");
    if (begins) within = line.find(option + " ") != std::string::npos;
    if (!line.starts_with("  ")) within = false;
    if (within) text += (begins ? line.substr(line.find(option)) : line.substr(line.find_first_not_of(' '))) + " ";
  }
  return text;
}

/// The file extensions that a text names, such as ".json", sorted.
std::vector<std::string> kinds_in(const std::string& text) {
  const std::regex kind(R"( (\.[a-z0-9]+)\b)");
  std::vector<std::string> kinds;
  for (std::sregex_iterator at(text.begin(), text.end(), kind), end; at != end; ++at) kinds.push_back((*at)[1]);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

// Required options, with a value each: a command checks them before its outputs.
const std::vector<std::pair<std::string, std::string>> kNeeded{
    {"--mass", "1"}, {"--positions", "3:1:9"}, {"--profile", "x"}, {"--manifest", "x"}};

TEST(Help, ListsTheKindsOfFileThatACommandWrites) {
  std::size_t checked = 0;
  for (const auto& command : test::commands()) {
    const std::string output = explanation(test::help_of(command), "--output");
    if (output.empty()) continue;
    const std::string usage = lines_of(test::help_of(command)).at(2);
    auto arguments = command;
    arguments.insert(arguments.end(), {"-o", "x.none"});
    if ((usage.ends_with("]") || usage.ends_with("FILE...")) && !usage.ends_with("[OPTION]..."))
      arguments.emplace_back("x");
    if (usage.ends_with(" FOLDER")) arguments.emplace_back("x");
    for (const auto& [option, value] : kNeeded) {
      if (usage.find(option) != std::string::npos) arguments.insert(arguments.end(), {option, value});
    }
    const auto outcome = test::run_percuss(arguments);
    EXPECT_EQ(outcome.code, 2) << test::joined(arguments) << outcome.err;
    const std::string kinds = output.substr(0, output.find('('));
    EXPECT_EQ(kinds_in(kinds), kinds_in(outcome.err)) << test::joined(command) << ": " << outcome.err;
    EXPECT_FALSE(kinds_in(kinds).empty()) << output;
    ++checked;
  }
  EXPECT_GT(checked, 15U);
}

TEST(Help, ExplainsEveryOptionWithoutTypeNames) {
  for (const auto& command : test::commands()) {
    for (const std::string& option : test::option_names(command)) {
      const std::string text = explanation(test::help_of(command), option);
      const std::size_t at = text.find(' ');
      ASSERT_NE(at, std::string::npos) << test::joined(command) << " " << option;
      EXPECT_GT(text.size(), option.size() + 10) << test::joined(command) << ": " << text;
      EXPECT_THAT(text, testing::Not(HasSubstr("UINT"))) << "a type name of the parser";
      EXPECT_THAT(text, testing::Not(HasSubstr("FLOAT")));
    }
  }
}

TEST(Help, DescribesEachCommand) {
  for (const auto& command : test::commands()) {
    const auto lines = lines_of(test::help_of(command));
    ASSERT_GT(lines.size(), 6U);
    EXPECT_TRUE(lines[0].front() >= 'A' && lines[0].front() <= 'Z') << lines[0];
    EXPECT_THAT(lines[2],
                testing::StartsWith(test::joined({"Usage:", test::joined({"percuss", test::joined(command)})})));
  }
}

TEST(Help, IsTheSameForBothNamesOfTheOption) {
  EXPECT_EQ(test::run_percuss({"model", "beam", "-h"}).out, test::help_of({"model", "beam"}));
  EXPECT_EQ(test::run_percuss({"-h"}).out, test::help_of({}));
}

TEST(Help, FitsATerminalExceptForExampleLines) {
  for (const auto& command : test::commands()) {
    const std::string& help = test::help_of(command);
    for (const std::string& line : lines_of(help.substr(0, help.find("\nExamples:\n"))))
      EXPECT_LE(report::text_width(line), 100U) << line;
  }
}

}  // namespace percuss::help_test
