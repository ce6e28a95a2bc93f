#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// docs/theory/theory.md and the code that it describes name the same equations.
namespace percuss::theory_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

using Numbers = std::multiset<std::string>;  // "4.7"

/// The numbers at the end of the page's equations, which are lines indented by four blanks.
Numbers defined_in(const std::string& page) {
  static const std::regex at_end(R"(^    .*\((\d+\.\d+)\)$)");
  Numbers numbers;
  std::smatch found;
  for (const std::string& line : test::lines_of(page)) {
    if (std::regex_match(line, found, at_end)) numbers.insert(found[1].str());
  }
  return numbers;
}

/// Numbers in parentheses anywhere: "by (4.1)", "(5.1) to (5.5)".
Numbers mentioned_in(const std::string& text) {
  static const std::regex number(R"(\((\d+\.\d+)\))");
  Numbers numbers;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) numbers.insert((*it)[1].str());
  return numbers;
}

/// The numbers after the word theory: "theory (4.7), (4.8)". Line ends and comment slashes between them are ignored.
Numbers cited_in(const std::string& source) {
  static const std::regex citation(R"(theory((?:[,\s/]*\(\d+\.\d+\))+))");
  Numbers numbers;
  for (std::sregex_iterator it(source.begin(), source.end(), citation), end; it != end; ++it)
    numbers.merge(mentioned_in((*it)[1].str()));
  return numbers;
}

std::vector<std::string> sources() {
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(PERCUSS_SOURCE_DIR "/src")) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".hpp" || kind == ".cpp") out.push_back(test::bytes_of(entry.path().string()));
  }
  return out;
}

Numbers cited_by_sources() {
  Numbers numbers;
  for (const std::string& source : sources()) numbers.merge(cited_in(source));
  return numbers;
}

std::vector<std::string> without(const Numbers& these, const Numbers& known) {
  std::vector<std::string> out;
  for (const std::string& number : these) {
    if (!known.contains(number)) out.push_back(number);
  }
  return out;
}

const std::string& page() {
  static const std::string text = test::bytes_of(PERCUSS_SOURCE_DIR "/docs/theory/theory.md");
  return text;
}

TEST(Theory, NumbersEachEquationOnce) {
  const Numbers defined = defined_in(page());
  EXPECT_GT(defined.size(), 80U) << "the search misses equations";
  for (const std::string& number : defined) EXPECT_EQ(defined.count(number), 1U) << number;
  EXPECT_THAT(without(mentioned_in(page()), defined), IsEmpty())
      << "mentioned in docs/theory/theory.md, but not defined there";
}

TEST(Theory, IsCitedByTheCodeThatComputesIt) {
  const Numbers defined = defined_in(page()), cited = cited_by_sources();
  EXPECT_THAT(without(cited, defined), IsEmpty()) << "cited in src, but not in docs/theory/theory.md";
  EXPECT_THAT(without(defined, cited), IsEmpty()) << "in docs/theory/theory.md, but cited by no code";
}

TEST(Theory, CitationsAreRead) {
  EXPECT_THAT(cited_in("/// theory (1.2), (3.4)\n/// and (5.6) of another; theory\n///   (7.8)\n"),
              ElementsAre("1.2", "3.4", "7.8"));
  EXPECT_THAT(defined_in("    a = b (1.1), c    (1.2)\nsee (1.3)\n    d\n"), ElementsAre("1.2"));
}

// The equations of bat performance have their own page. Each one begins a row of its tables.
TEST(Theory, AndTheCodeNameTheSameEquationsOfPerformance) {
  static const std::regex row(R"(^\| (\(P\d+\)) .*)"), name(R"(\(P\d+\))");
  Numbers defined, cited;
  std::smatch found;
  for (const std::string& line : test::lines_of(test::bytes_of(PERCUSS_SOURCE_DIR "/docs/theory/performance.md"))) {
    if (std::regex_match(line, found, row)) defined.insert(found[1].str());
  }
  for (const std::string& text : sources()) {
    for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) cited.insert(it->str());
  }
  EXPECT_GE(defined.size(), 20U);
  for (const std::string& number : defined) EXPECT_EQ(defined.count(number), 1U) << number;
  EXPECT_THAT(without(cited, defined), IsEmpty()) << "cited in src, but not in docs/theory/performance.md";
  EXPECT_THAT(without(defined, cited), IsEmpty()) << "in docs/theory/performance.md, but cited by no code";
}

// A page without its code: brackets in code are shapes of arrays, not citations.
std::string prose_of(const std::string& page) {
  static const std::regex code("`[^`]*`");
  std::string prose;
  bool fenced = false;
  for (const std::string& line : test::lines_of(page)) {
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced) prose += std::regex_replace(line, code, "") + "\n";
  }
  return prose;
}

// Each source that a page cites is listed in docs/theory/sources.md.
TEST(Theory, CitesSourcesThatAreListed) {
  static const std::regex reference(R"(\[(\d+)\])"), entry(R"(^\[(\d+)\] )");
  std::set<std::string> listed;
  std::smatch found;
  for (const std::string& line : test::lines_of(test::bytes_of(PERCUSS_SOURCE_DIR "/docs/theory/sources.md"))) {
    if (std::regex_search(line, found, entry)) listed.insert(found[1].str());
  }
  EXPECT_GE(listed.size(), 19U);
  for (const auto& file : fs::recursive_directory_iterator(PERCUSS_SOURCE_DIR "/docs")) {
    if (file.path().extension() != ".md") continue;
    const std::string text = prose_of(test::bytes_of(file.path().string()));
    for (std::sregex_iterator it(text.begin(), text.end(), reference), end; it != end; ++it)
      EXPECT_TRUE(listed.contains((*it)[1].str())) << file.path() << ": [" << (*it)[1].str() << "]";
  }
}

}  // namespace percuss::theory_test
