#include "pipeline/warnings/scan_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/units.hpp"
#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

// "hit 14 at 6 in by 17 standard deviations, as if at 7.5 in"
std::string outlier_text(const identify::ScanOutlier& one, double position_m) {
  std::string text = one.hits.empty() ? "" : hit_list(one.hits) + " ";
  text += fmt::format("at {:.4g} in by {:.0f} standard deviations", position_m / kInch_m, one.deviations);
  if (one.fits_m) text += fmt::format(", as if at {:.2g} in", *one.fits_m / kInch_m);
  return text;
}

}  // namespace

Warning missing_positions(const std::string& missing) {
  return with_remedy(
      {"missing_position", "no usable hit at " + missing + ": the nodes are found without these positions"},
      "repeat the hits there");
}

Warning few_positions(std::size_t positions) {
  return with_remedy({"few_points", fmt::format("only {} position{} usable hits: no node can be located", positions,
                                                positions == 1 ? " has" : "s have")},
                     "measure three positions or more");
}

Warning one_hit_per_position() {
  return with_remedy(
      {"one_hit_each", "one hit per position: each ± leaves out errors of the place and direction of the hits"},
      "repeat the hits at each position");
}

Warning misplaced_hits(const std::vector<identify::ScanOutlier>& outliers, const std::vector<double>& position_m) {
  constexpr std::size_t kMaxNamed = 6;
  std::string which;
  for (std::size_t i = 0; i < std::min(outliers.size(), kMaxNamed); ++i)
    which += (i > 0 ? "; " : "") + outlier_text(outliers[i], position_m[outliers[i].point]);
  if (outliers.size() > kMaxNamed) which += fmt::format("; and {} more", outliers.size() - kMaxNamed);
  Warning warning = with_remedy(
      {"misplaced_hits", "hits do not fit the shapes through the other positions, in two modes or more: " + which},
      "check the order of the positions and the place of these hits, or repeat them; the nodes contain them");
  warning.options = {"positions", "reject_hit"};
  return warning;
}

}  // namespace percuss::pipeline
