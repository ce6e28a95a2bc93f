#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "report/text/text_table.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Checks the commands, options and links of the pages, and the width of their lines.
namespace percuss::pages_test {

namespace fs = std::filesystem;
using testing::IsEmpty;

std::vector<std::string> pages() {
  std::vector<std::string> out;
  for (const char* name : {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"})
    out.push_back(std::string(PERCUSS_SOURCE_DIR "/") + name);
  for (const auto& entry : fs::recursive_directory_iterator(PERCUSS_SOURCE_DIR "/docs")) {
    if (entry.path().extension() == ".md") out.push_back(entry.path().string());
  }
  return out;
}

/// A command that a page names: its words up to the first option, and its options.
struct NamedCommand {
  std::vector<std::string> words;
  std::vector<std::string> options;
};

/// The parts of a line of text between `backticks`, or the whole line if it is code.
std::vector<std::string> code_in(const std::string& line, bool code) {
  if (code) return {line};
  std::vector<std::string> out;
  for (std::size_t open = line.find('`'); open != std::string::npos;) {
    const std::size_t close = line.find('`', open + 1);
    if (close == std::string::npos) break;
    out.push_back(line.substr(open + 1, close - open - 1));
    open = line.find('`', close + 1);
  }
  return out;
}

NamedCommand command_in(const std::string& code) {
  static const std::regex words("percuss((?: [a-z][a-z_]*)*)"), option(R"((?:^|\s)(--[a-z][a-z0-9-]*))");
  NamedCommand command;
  std::smatch found;
  // A pipe, a redirection, a comment or the next command ends it.
  const std::string text = code.substr(0, code.find_first_of("|;>#&"));
  if (!std::regex_search(text, found, words, std::regex_constants::match_continuous)) return command;
  std::istringstream stream(found[1].str());
  for (std::string word; stream >> word;) command.words.push_back(word);
  for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it)
    command.options.push_back((*it)[1].str());
  return command;
}

/// The commands that the page names: lines of code that begin with percuss (after "$ " or blanks), and such code within
/// the text.
std::vector<NamedCommand> commands_of(const std::string& page) {
  std::vector<NamedCommand> out;
  bool fenced = false;
  for (const std::string& line : test::lines_of(test::bytes_of(page))) {
    if (line.starts_with("```")) fenced = !fenced;
    for (std::string code : code_in(line, fenced || line.starts_with("    "))) {
      code.erase(0, code.find_first_not_of(" $"));
      if (code.starts_with("percuss ")) out.push_back(command_in(code));
    }
  }
  return out;
}

// The help of the command that the words begin with. `model beam` and `batch run` are names of two words; in `synth
// wood-bat` only the first word is the name.
const std::string& help_of(const std::vector<std::string>& words) {
  static std::map<std::string, std::string> known;
  std::vector<std::string> name;
  if (!words.empty()) name.push_back(words[0]);
  if (words.size() > 1 && (words[0] == "model" || words[0] == "batch")) name.push_back(words[1]);
  std::string key;
  for (const std::string& word : name) key.append(word).append(" ");
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  name.emplace_back("--help");
  const auto outcome = test::run_percuss(name);
  return known[key] = outcome.code == 0 ? outcome.out : "";
}

bool offers(const std::string& help, const std::string& option) {
  return std::regex_search(help, std::regex(R"((^|[\s,]))" + option + "(?![a-z0-9-])"));
}

std::vector<std::string> wrong_in(const std::string& page) {
  std::vector<std::string> wrong;
  for (const NamedCommand& command : commands_of(page)) {
    const std::string& help = help_of(command.words);
    const std::string name = command.words.empty() ? "percuss" : command.words.front();
    if (help.empty()) wrong.push_back("no command " + name);
    for (const std::string& option : command.options) {
      if (!help.empty() && !offers(help, option)) wrong.push_back(fmt::format("no option {} of {}", option, name));
    }
  }
  return wrong;
}

TEST(Pages, NameCommandsAndOptionsThatExist) {
  std::size_t commands = 0;
  for (const std::string& page : pages()) {
    commands += commands_of(page).size();
    EXPECT_THAT(wrong_in(page), IsEmpty()) << page;
  }
  EXPECT_GT(commands, 100U) << "the search misses commands";
}

TEST(Pages, AreCheckedAgainstTheHelpOfEachCommand) {
  const test::ScratchFolder folder;
  test::write_bytes(
      folder.file("a.md"),
      "`percuss analyze x --band 1:2 --bands 3` and `percuss analyse`\n```\n$ percuss model beam --ei 3 --at 2 | "
      "sort --wrong\n```\n");
  EXPECT_THAT(wrong_in(folder.file("a.md")),
              testing::ElementsAre("no option --bands of analyze", "no command analyse", "no option --at of model"));
}

// Checks links to files; links to the network are skipped.
TEST(Pages, LinkToFilesThatExist) {
  static const std::regex link(R"(\]\(([^)#]+)(#[^)]*)?\))");
  for (const std::string& page : pages()) {
    const std::string text = test::bytes_of(page);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1].str();
      if (target.find("://") != std::string::npos) continue;
      EXPECT_TRUE(fs::exists(fs::path(page).parent_path() / target)) << page << ": " << target;
    }
  }
}

// The navigation of the HTML pages comes from docs/index.md. A page that is not listed there has no link.
TEST(Pages, AreListedInTheIndex) {
  const fs::path index = PERCUSS_SOURCE_DIR "/docs/index.md";
  const std::string text = test::bytes_of(index.string());
  for (const std::string& page : pages()) {
    if (page == index) continue;
    const std::string link = "](" + fs::relative(page, index.parent_path()).string() + ")";
    EXPECT_NE(text.find(link), std::string::npos) << page;
  }
}

/// Lines of prose: no tables, blocks of code or equations, and nothing that percuss_stress writes.
std::vector<std::string> prose_lines(const std::string& page) {
  std::vector<std::string> out;
  bool fenced = false;
  for (const std::string& line : test::lines_of(test::bytes_of(page))) {
    if (line == "<!-- measured -->") break;
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced && !line.starts_with("|") && !line.starts_with("    ")) out.push_back(line);
  }
  return out;
}

TEST(Pages, HaveLinesOfAtMost120Characters) {
  constexpr std::size_t kMaxWidth = 120;
  for (const std::string& page : pages()) {
    for (const std::string& line : prose_lines(page))
      EXPECT_LE(report::text_width(line), kMaxWidth) << page << ": " << line;
  }
}

/// The names of all C++ tests: "Suite.Name".
std::string test_names() {
  static const std::regex kTest(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+))");
  std::string out = "\n";
  for (const auto& entry : fs::recursive_directory_iterator(PERCUSS_SOURCE_DIR "/tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = test::bytes_of(entry.path().string());
    for (std::sregex_iterator at(text.begin(), text.end(), kTest), end; at != end; ++at)
      out += at->str(1) + "." + at->str(2) + "\n";
  }
  return out;
}

// The page names tests as `Suite.Name`, `Suite.*` or `Suite.Beginning*`.
TEST(Pages, OfSecurityNameTestsThatExist) {
  static const std::regex kNamed(R"(`([A-Z]\w+\.\w*)\*?`)");
  const std::string names = test_names();
  const std::string page = test::bytes_of(PERCUSS_SOURCE_DIR "/docs/project/security.md");
  std::size_t count = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), kNamed), end; at != end; ++at, ++count) {
    const bool whole = at->str()[at->str().size() - 2] != '*';
    EXPECT_NE(names.find("\n" + at->str(1) + (whole ? "\n" : "")), std::string::npos) << at->str();
  }
  EXPECT_GT(count, 30U);
}

}  // namespace percuss::pages_test
