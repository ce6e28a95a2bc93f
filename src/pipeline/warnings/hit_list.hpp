#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::pipeline {

/// "hit 3", "hits 0, 2", "hits 0, 1, 2, 3, 4, 5, 6, 7 and 4 more".
inline std::string hit_list(const std::vector<std::size_t>& hits) {
  constexpr std::size_t kMaxListedHits = 8;
  std::string list = hits.size() == 1 ? "hit " : "hits ";
  for (std::size_t i = 0; i < std::min(hits.size(), kMaxListedHits); ++i)
    list += (i > 0 ? ", " : "") + std::to_string(hits[i]);
  if (hits.size() > kMaxListedHits) list += " and " + std::to_string(hits.size() - kMaxListedHits) + " more";
  return list;
}

}  // namespace percuss::pipeline
