#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace percuss::tools {

inline constexpr std::size_t kMaxListedNumber = 1'000'000;

/// A whole number in decimal digits, 0 or above; nothing for other texts.
std::optional<std::size_t> whole_number(std::string_view text);

/// The first and the last number of a piece of a list, "8" or "1-5"; nothing for other texts, and for
/// numbers above kMaxListedNumber.
std::optional<std::pair<std::size_t, std::size_t>> number_range(std::string_view text);

/// What a list of hits may hold. Error messages put it after the word "give".
inline constexpr const char* kHitsRequirement = "whole numbers from 1 up, ranges such as 1-5, or all";

/// Whether the text is a piece of a list of hits: "8", "1-5" or "all", up to hit 1000000.
bool names_hits(const std::string& piece);

/// The indices of the hits that a list of pieces such as "1-5", "8" and "all" names. Indices start at 0; the pieces
/// count hits from 1, as the tables do. `all` is pipeline::kEveryHit. Throws OptionError for other texts, hit 0 and
/// more than a million hits.
std::vector<std::size_t> parse_hits(const OptionId& option, const std::vector<std::string>& pieces);

}  // namespace percuss::tools
