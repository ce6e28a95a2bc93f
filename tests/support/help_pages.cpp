#include "support/help_pages.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/percuss_process.hpp"

namespace percuss::test {
namespace {

/// The lines under a heading that begin an entry, with an indent of exactly two spaces.
std::vector<std::string> entries(const std::string& help, const std::string& heading) {
  std::vector<std::string> found;
  bool within = false;
  for (const std::string& line : lines_of(help)) {
    if (!line.empty() && line.front() != ' ') within = line == heading + ":";
    if (within && line.starts_with("  ") && line.size() > 2 && line[2] != ' ') found.push_back(line.substr(2));
  }
  return found;
}

void add_commands_below(const std::vector<std::string>& parent, std::vector<std::vector<std::string>>& all) {
  for (const std::string& entry : entries(help_of(parent), "Commands")) {
    std::vector<std::string> command = parent;
    command.push_back(entry.substr(0, entry.find(' ')));
    all.push_back(command);
    add_commands_below(command, all);
  }
}

}  // namespace

const std::vector<std::vector<std::string>>& commands() {
  static const auto found = [] {
    std::vector<std::vector<std::string>> all{{}};
    add_commands_below({}, all);
    return all;
  }();
  EXPECT_GT(found.size(), 20U);
  return found;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

const std::string& help_of(const std::vector<std::string>& command) {
  // A process per text, not one per question about it.
  static std::map<std::vector<std::string>, std::string> texts;
  const auto known = texts.find(command);
  if (known != texts.end()) return known->second;
  std::vector<std::string> words = command;
  words.emplace_back("--help");
  const auto outcome = run_percuss(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return texts.emplace(command, outcome.out).first->second;
}

std::vector<std::string> option_names(const std::vector<std::string>& command) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(help_of(command))) {
    if (!line.starts_with("  -")) continue;
    const std::size_t at = line.find("--");
    names.push_back(line.substr(at, line.find(' ', at) - at));
  }
  return names;
}

std::vector<std::string> example_lines(const std::vector<std::string>& command) {
  return entries(help_of(command), "Examples");
}

}  // namespace percuss::test
