#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/io/counted_words.hpp"

namespace percuss::pipeline {

/// For people, who count hits from 1: "hit 4" for index 3, "hits 1, 3", "hits 1, 2, 3, 4, 5, 6, 7, 8 and 4 more".
inline std::string hit_list(const std::vector<std::size_t>& hits) {
  constexpr std::size_t kMaxListedHits = 8;
  return (hits.size() == 1 ? "hit " : "hits ") +
         limited_list(hits.size(), kMaxListedHits, [&](std::size_t i) { return std::to_string(hits[i] + 1); });
}

}  // namespace percuss::pipeline
