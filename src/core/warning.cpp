#include "core/warning.hpp"

#include <algorithm>
#include <utility>

namespace percuss::warnings {
namespace {

// The code's place in the ranking; ranking.size() for an unknown code.
std::size_t rank_of(std::string_view code, std::span<const RankedCode> ranking) {
  const auto at =
      std::find_if(ranking.begin(), ranking.end(), [&](const RankedCode& known) { return known.code == code; });
  return static_cast<std::size_t>(at - ranking.begin());
}

}  // namespace

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::info:
      return "info";
    case Severity::warn:
      return "warn";
    case Severity::reject:
      return "reject";
  }
  return "";
}

Warning with_remedy(Warning warning, std::string remedy) {
  warning.message += "; " + remedy;
  warning.remedy = std::move(remedy);
  return warning;
}

Severity severity_of(std::string_view code, std::span<const RankedCode> ranking) {
  const std::size_t rank = rank_of(code, ranking);
  return rank < ranking.size() ? ranking[rank].severity : Severity::warn;
}

std::vector<Warning> ranked(std::vector<Warning> warnings, std::span<const RankedCode> ranking) {
  for (Warning& warning : warnings) {
    if (!warning.severity) warning.severity = severity_of(warning.code, ranking);
  }
  const auto before = [&](const Warning& a, const Warning& b) {
    if (*a.severity != *b.severity) return *a.severity > *b.severity;
    return rank_of(a.code, ranking) < rank_of(b.code, ranking);
  };
  std::stable_sort(warnings.begin(), warnings.end(), before);
  return warnings;
}

}  // namespace percuss::warnings
