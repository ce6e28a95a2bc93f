#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace percuss::metrics {

/// Locations along the barrel, counted in half inches from its tip: 12 is 6 in.
using HalfInches = int;

struct SearchRules {
  double margin = 0.003;          // by which the sweet spot must beat both its neighbours
  HalfInches low = 6, high = 18;  // where a ball may hit
};

enum class SearchState : std::uint8_t {
  shoot,    // `at` is to be tested next
  found,    // `at` beats both its neighbours
  plateau,  // all around is tested, but the best has a neighbour within the margin
  edge      // … or lies where a neighbour cannot be hit
};

struct SearchStep {
  SearchState state = SearchState::shoot;
  HalfInches at = 12;               // to be tested, or the best
  std::vector<HalfInches> plateau;  // those within the margin of the best, itself included; empty while shooting
};

/// What the search for the sweet spot does next, from the performance at the locations tested: 6, 5 and 7 in first;
/// then the neighbour of the best, towards 6 in (of 6 in itself: on the side that did better), then the outer one;
/// where a neighbour is within the margin, whatever is untested beside the two. Ends after at most high − low + 1
/// locations, and asks only for those from low to high. Of equals the one nearest 6 in counts as the best. source  [8]
/// in docs/theory/sources.md, section 3.5; what it leaves open is decided in docs/theory/performance.md.
SearchStep next_location(const std::map<HalfInches, double>& tested, const SearchRules& rules = {});

}  // namespace percuss::metrics
