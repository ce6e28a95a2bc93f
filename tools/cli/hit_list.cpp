#include "cli/hit_list.hpp"

#include <charconv>

#include "cli/option_error.hpp"
#include "core/io/csv_header.hpp"
#include "pipeline/hits/hit_grading.hpp"

namespace percuss::tools {
namespace {

bool is_all(const std::string& piece) { return lower_case(piece) == "all"; }

}  // namespace

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::pair<std::size_t, std::size_t>> number_range(std::string_view text) {
  const std::size_t dash = text.find('-');
  const auto first = whole_number(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : whole_number(text.substr(dash + 1));
  if (!first || !last || *last < *first || *last > kMaxListedNumber) return std::nullopt;
  return std::pair(*first, *last);
}

bool names_hits(const std::string& piece) { return is_all(piece) || number_range(piece); }

std::vector<std::size_t> parse_hits(const OptionId& option, const std::vector<std::string>& pieces) {
  std::vector<std::size_t> hits;
  for (const std::string& piece : pieces) {
    if (is_all(piece)) {
      hits.push_back(pipeline::kEveryHit);
      continue;
    }
    const auto range = number_range(piece);
    if (range && range->first == 0)
      throw OptionError::wrong_value(option, piece, "hits count from 1, as in the table of hits");
    if (!range || hits.size() + (range->second - range->first) >= kMaxListedNumber)
      throw OptionError::wrong_value(option, piece, std::string("give ") + kHitsRequirement);
    for (std::size_t number = range->first; number <= range->second; ++number) hits.push_back(number - 1);
  }
  return hits;
}

}  // namespace percuss::tools
