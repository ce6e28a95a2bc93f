#include "pipeline/warnings/reference_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/units.hpp"
#include "pipeline/channels/reference_ratios.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kUnitTolerance = 1.1;      // a factor within 10 % of a unit's may be this unit
constexpr double kSilent = 0.1;             // a factor below it: the channel shows crosstalk or noise
constexpr std::size_t kMaxNamedPoints = 8;  // points

bool is_about(double factor, double unit) { return factor > unit / kUnitTolerance && factor < unit * kUnitTolerance; }

std::string cause(double factor, const std::string& first, const std::string& second) {
  const double size = std::max(std::abs(factor), 1 / std::abs(factor));
  if (is_about(-factor, 1)) return "one of them was reversed";
  if (is_about(size, kStandardGravity_mps2)) return "one of them was in g, the other in m/s²";
  if (is_about(size, 1000)) return "the unit or sensitivity of one of them was wrong by 1000";
  if (std::abs(factor) < kSilent) return second + " did not respond";
  if (std::abs(factor) > 1 / kSilent) return first + " did not respond";
  return "the scale of one of them was different";
}

}  // namespace

std::vector<Warning> reference_warnings(const std::vector<acquire::SignalInfo>& accel,
                                        const std::vector<identify::Mode>& modes) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<ReferenceContradiction>> pairs;
  for (const ReferenceContradiction& found : reference_contradictions(modes)) {
    if (found.first < accel.size() && found.second < accel.size()) pairs[{found.first, found.second}].push_back(found);
  }
  std::vector<Warning> out;
  for (const auto& [pair, points] : pairs) {
    const auto name = [&](std::size_t channel) { return one_line(accel[channel].name, kMaxNameBytes); };
    const std::string first = name(pair.first), second = name(pair.second);
    std::string list;
    for (std::size_t i = 0; i < std::min(points.size(), kMaxNamedPoints); ++i) {
      const ReferenceContradiction& at = points[i];
      list += fmt::format("{}at point {} {:.3g} times this ratio in {} modes ({} there)", i == 0 ? "" : ", ", at.point,
                          at.factor, at.modes, cause(at.factor, first, second));
    }
    if (points.size() > kMaxNamedPoints) list += fmt::format(" and at {} more points", points.size() - kMaxNamedPoints);
    out.push_back(with_remedy(
        {"sensors_disagree", fmt::format("{} over {} is the same at most points, but {}. Shapes are wrong at such a "
                                         "point, and modal masses may be",
                                         second, first, list)},
        "correct the channel's sign, unit or scale in the data of this point, or leave the point "
        "out"));
  }
  return out;
}

}  // namespace percuss::pipeline
