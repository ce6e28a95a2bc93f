#include "pipeline/warnings/reference_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/math/statistics.hpp"
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

// "at points 14, 15, 16 it is -1 times this: one of them was reversed there"
std::string group_text(const std::string& cause, const std::vector<ReferenceContradiction>& contradictions,
                       const PointNames& names) {
  std::vector<double> factors;
  std::vector<int> points;
  for (const ReferenceContradiction& at : contradictions) {
    factors.push_back(at.factor);
    points.push_back(static_cast<int>(at.point));
  }
  return fmt::format("at {} it is {:.2g} times this: {} there", names.list(points, kMaxNamedPoints), median(factors),
                     cause);
}

}  // namespace

std::vector<Warning> reference_warnings(const std::vector<acquire::SignalInfo>& accel,
                                        const std::vector<identify::Mode>& modes, const PointNames& names) {
  const auto name = [&](std::size_t channel) { return one_line(accel[channel].name, kMaxNameBytes); };
  using Groups = std::map<std::string, std::vector<ReferenceContradiction>>;  // by cause
  std::map<std::pair<std::size_t, std::size_t>, Groups> pairs;
  for (const ReferenceContradiction& at : reference_contradictions(modes)) {
    if (at.first < accel.size() && at.second < accel.size())
      pairs[{at.first, at.second}][cause(at.factor, name(at.first), name(at.second))].push_back(at);
  }
  std::vector<Warning> out;
  for (const auto& [pair, groups] : pairs) {
    std::string list;
    for (const auto& [cause, points] : groups) list += (list.empty() ? "" : "; ") + group_text(cause, points, names);
    out.push_back(with_remedy(
        {"sensors_disagree",
         fmt::format(
             "in each mode, {} moves in one ratio to {} at all points, but {}. Shapes are wrong at these points, "
             "and modal masses may be",
             name(pair.second), name(pair.first), list)},
        "correct sign, unit or scale of the channel in the data of these points, or leave them out"));
  }
  return out;
}

}  // namespace percuss::pipeline
