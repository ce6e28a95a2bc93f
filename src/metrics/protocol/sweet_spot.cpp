#include "metrics/protocol/sweet_spot.hpp"

#include <cmath>
#include <cstdlib>
#include <set>

#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

constexpr HalfInches kFirst = 12, kSecond = 10, kThird = 14;

HalfInches best_of(const std::map<HalfInches, double>& tested) {
  HalfInches best = kFirst;
  for (const auto& [at, value] : tested) {
    const double lead = value - tested.at(best);
    if (lead > 0 || (lead == 0 && std::abs(at - kFirst) < std::abs(best - kFirst))) best = at;
  }
  return best;
}

// The two neighbours of a location, in the order of testing.
std::vector<HalfInches> neighbours(HalfInches at, const std::map<HalfInches, double>& tested) {
  const bool lower_first = at == kFirst ? tested.at(kSecond) > tested.at(kThird) : at > kFirst;
  return lower_first ? std::vector{at - 1, at + 1} : std::vector{at + 1, at - 1};
}

}  // namespace

HalfInches half_inches(double z_in) { return static_cast<HalfInches>(std::lround(2 * z_in)); }

SearchStep next_location(const std::map<HalfInches, double>& tested, const SearchRules& rules) {
  for (const HalfInches at : {kFirst, kSecond, kThird}) {
    if (!tested.contains(at)) return {.at = at};
  }
  const HalfInches best = best_of(tested);
  std::set<HalfInches> plateau{best};  // locations within the margin of the best
  std::vector<HalfInches> to_look_at{best};
  bool edge = false;
  while (!to_look_at.empty()) {
    const HalfInches at = to_look_at.back();
    to_look_at.pop_back();
    for (const HalfInches next : neighbours(at, tested)) {
      if (next < rules.low || next > rules.high) {
        edge = true;
      } else if (!tested.contains(next)) {
        return {.at = next};
      } else if (tested.at(best) - tested.at(next) < rules.margin - kReadingTolerance && plateau.insert(next).second) {
        to_look_at.push_back(next);
      }
    }
  }
  return {.state = edge                 ? SearchState::edge
                   : plateau.size() > 1 ? SearchState::plateau
                                        : SearchState::found,
          .at = best,
          .plateau = {plateau.begin(), plateau.end()}};
}

}  // namespace percuss::metrics
