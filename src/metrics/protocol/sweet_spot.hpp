#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace percuss::metrics {

/// A location on the barrel in half inches from its tip: 12 is 6 in.
using HalfInches = int;

/// The location nearest to z_in.
HalfInches half_inches(double z_in);

struct SearchRules {
  double margin = 0.003;          // by which the sweet spot must exceed both neighbours
  HalfInches low = 6, high = 18;  // permitted locations
};

enum class SearchState : std::uint8_t {
  shoot,    // test `at` next
  found,    // `at` exceeds both neighbours by the margin
  plateau,  // the neighbourhood is tested, but the best has a neighbour within the margin
  edge      // the neighbourhood is tested, but the best, or a location within its margin, is at an end of the range
};

struct SearchStep {
  SearchState state = SearchState::shoot;
  HalfInches at = 12;               // the next location, or the best one
  std::vector<HalfInches> plateau;  // locations within the margin of the best, with the best; empty for `shoot`
};

/// The next step of the search for the sweet spot, from the performance at the tested locations. 6, 5 and 7 in come
/// first. Then come the two neighbours of the best: first the one towards 6 in (for 6 in itself: on the better side),
/// then the other. Where a neighbour is within the margin, the untested locations beside the two come next. The search
/// ends after at most high − low + 1 locations, all between low and high. Among equals the location nearest 6 in is the
/// best.
/// source  [8] in docs/theory/sources.md, section 3.5; docs/theory/performance.md decides what [8] leaves open.
SearchStep next_location(const std::map<HalfInches, double>& tested, const SearchRules& rules = {});

}  // namespace percuss::metrics
