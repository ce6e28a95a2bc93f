#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "metrics/protocol/bat_metrics.hpp"
#include "model/section/profile_warnings.hpp"
#include "model/trampoline/trampoline_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The sources, the rankings and docs/reference/warnings.md know the same codes of warnings and findings.
namespace percuss::warning_pages_test {

namespace fs = std::filesystem;
using Codes = std::set<std::string>;

/// The codes of the warnings that a source constructs. A code is an identifier that stands first in braces, before a
/// message. Braces with identifiers only, such as {"angle", "object"}, are a list of options.
Codes codes_constructed_in(const std::string& source) {
  static const std::regex first(R"re(\{\s*(?:\.code = )?"([a-z][a-z0-9_]+)"\s*,(?!\s*"[a-z0-9_.]+"\s*[,}]))re");
  Codes codes;
  if (source.find("Warning") == std::string::npos) return codes;
  for (std::sregex_iterator at(source.begin(), source.end(), first), end; at != end; ++at) codes.insert(at->str(1));
  return codes;
}

/// The codes of findings: the names that name_of(FindingCode) returns.
Codes codes_of_findings() {
  static const std::regex named(R"re(case FindingCode::(\w+):\s*return "(\w+)")re");
  const std::string source = test::bytes_of(PERCUSS_SOURCE_DIR "/src/acquire/hits/finding.cpp");
  Codes codes;
  for (std::sregex_iterator at(source.begin(), source.end(), named), end; at != end; ++at) codes.insert(at->str(2));
  return codes;
}

/// The codes that the layers construct. report, api and batch are not searched: they only pass warnings on, and their
/// tables contain similar braces.
Codes codes_of_sources() {
  Codes codes = codes_of_findings();
  for (const char* folder : {"/src/acquire", "/src/frf", "/src/identify", "/src/model", "/src/metrics", "/src/pipeline",
                             "/tools/commands"}) {
    for (const auto& entry : fs::recursive_directory_iterator(std::string(PERCUSS_SOURCE_DIR) + folder)) {
      if (entry.path().extension() != ".cpp" || entry.path().filename() == "ranking.cpp") continue;
      codes.merge(codes_constructed_in(test::bytes_of(entry.path().string())));
    }
  }
  return codes;
}

/// The ranked codes with their severities, those of metrics and models included.
std::map<std::string, std::string> ranked_severities() {
  std::map<std::string, std::string> out;
  for (const pipeline::RankedCode& ranked : pipeline::ranked_codes())
    out[std::string(ranked.code)] = name_of(ranked.severity);
  for (const warnings::RankedCode& ranked : metrics::ranked_metrics_codes())
    out[std::string(ranked.code)] = name_of(ranked.severity);
  for (const warnings::RankedCode& ranked : model::ranked_trampoline_codes())
    out[std::string(ranked.code)] = name_of(ranked.severity);
  for (const warnings::RankedCode& ranked : model::kProfileWarningCodes)
    out[std::string(ranked.code)] = name_of(ranked.severity);
  return out;
}

/// Code and severity of each row of the page: "| `code` | severity | …".
std::vector<std::pair<std::string, std::string>> rows_of(const std::string& page) {
  static const std::regex row(R"(^\| `(\w+)` \| (\w+) \|.*)");
  std::vector<std::pair<std::string, std::string>> out;
  std::smatch found;
  for (const std::string& line : test::lines_of(page)) {
    if (std::regex_match(line, found, row)) out.emplace_back(found[1].str(), found[2].str());
  }
  return out;
}

std::map<std::string, std::string> severities_of(const std::string& page) {
  std::map<std::string, std::string> out;
  for (const auto& [code, severity] : rows_of(page)) out[code] = severity;
  return out;
}

Codes keys_of(const std::map<std::string, std::string>& map) {
  Codes keys;
  for (const auto& [key, value] : map) keys.insert(key);
  return keys;
}

TEST(WarningCodes, AreFoundInSources) {
  EXPECT_EQ(codes_constructed_in(R"(Warning a{"one", "a text"}; out.push_back({"two",
      fmt::format("x"), {"angle", "object"}}); return {{.code = "three", .message = m}}; b({"angle"});)"),
            (Codes{"one", "two", "three"}));
  EXPECT_THAT(codes_constructed_in(R"(table.add({"one", "Two words"});)"), testing::IsEmpty());
  EXPECT_GT(codes_of_sources().size(), 50U) << "the search misses codes";
  EXPECT_GT(codes_of_findings().size(), 10U);
}

TEST(WarningCodes, AreAllRanked) { EXPECT_EQ(keys_of(ranked_severities()), codes_of_sources()); }

TEST(WarningCodes, StandOnThePageWithTheirSeverity) {
  EXPECT_EQ(severities_of(test::bytes_of(PERCUSS_SOURCE_DIR "/docs/reference/warnings.md")), ranked_severities());
}

// The page states that warnings of one severity come in its order.
TEST(WarningCodes, StandOnThePageInTheOrderOfTheRanking) {
  std::vector<std::string> ranking, page;
  for (const pipeline::RankedCode& ranked : pipeline::ranked_codes()) ranking.emplace_back(ranked.code);
  const std::string text = test::bytes_of(PERCUSS_SOURCE_DIR "/docs/reference/warnings.md");
  for (const auto& [code, severity] : rows_of(text)) {
    if (std::find(ranking.begin(), ranking.end(), code) != ranking.end()) page.push_back(code);
  }
  EXPECT_EQ(page, ranking);
}

TEST(WarningCodes, AreReadFromThePage) {
  EXPECT_EQ(severities_of("| code | severity |\n|---|---|\n| `one` | warn | a | b |\ntext `two`\n"),
            (std::map<std::string, std::string>{{"one", "warn"}}));
}

}  // namespace percuss::warning_pages_test
