#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::pipeline {

/// For people, who count hits from 1: "hit 4" for index 3, "hits 1, 3", "hits 1, 2, 3, 4, 5, 6, 7, 8 and 4 more".
inline std::string hit_list(const std::vector<std::size_t>& hits) {
  constexpr std::size_t kMaxListedHits = 8;
  std::string list = hits.size() == 1 ? "hit " : "hits ";
  for (std::size_t i = 0; i < std::min(hits.size(), kMaxListedHits); ++i)
    list += (i > 0 ? ", " : "") + std::to_string(hits[i] + 1);
  if (hits.size() > kMaxListedHits) list += " and " + std::to_string(hits.size() - kMaxListedHits) + " more";
  return list;
}

}  // namespace percuss::pipeline
