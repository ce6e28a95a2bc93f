#include "pipeline/warnings/point_force_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

// Blows of one hammer by hand differ by a factor of 5 or so. Units that differ by less than the limit, such as lbf
// (4.45 N) and kgf (9.81 N), cannot be told from soft blows. A sensitivity of 22.5 mV/N that is not stated gives a
// factor of 44.
constexpr double kMinFactor = 25;
constexpr double kMinGap = 10;  // between the forces of neighbouring points in ascending order: they are two groups
// Responses of one structure to equal blows at its points differ by less, except near supports.
constexpr double kMaxResponseFactor = 10;
constexpr double kThousand = 1000, kNearThousand = 3;  // kN and N, V and mV; blows themselves vary
constexpr std::size_t kMaxListedPoints = 20;

// A recorder's range or an amplifier's gain that is wrong at some points is wrong by a factor of 10. In surveys struck
// by hand, no point had less than 1/2.2 of the median force (decision 172): a factor of 5 needs another reason.
constexpr double kMinRangeFactor = 5;
constexpr std::size_t kMinUsualPoints = 6;     // points with the usual force
constexpr std::size_t kPointsPerDoubtful = 3;  // at most one point of so many may have another force
// A soft blow has a longer pulse, and a soft place too. A wrong range does not change the pulse.
constexpr double kMaxPulseFactor = 1.3;
// Limits of a mode's amplitude at one point over its largest amplitude at the other points. In 4000 simulated beams and
// plates, the second largest of these ratios over the modes is below 1.5 at every point, and the largest is above 0.25
// at 99 % of the points that are not beside a clamped end. A force that is wrong by 10 changes both by 10.
constexpr double kLargeMotion = 2.5, kSmallMotion = 0.2;
constexpr std::size_t kMinModesOfRange = 3;
constexpr double kClearAmplitude = 10;  // standard deviations

// Natural logarithms of a point's median force in N, and of its median response.
struct PointLevel {
  int point = 0;
  double log_force = 0, log_response = 0;
  double pulse_s = 0;  // median
};

// The range of the responses to a hit in m/s², which contains no offset: logarithm of the geometric mean over the
// channels that moved.
std::optional<double> log_response_of(const AnalysedHit& hit) {
  double sum = 0;
  std::size_t count = 0;
  for (const acquire::ResponseGrade& response : hit.responses) {
    const double range_mps2 = response.extremes.high - response.extremes.low;
    if (!(range_mps2 > 0)) continue;
    sum += std::log(range_mps2);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

// Ascending by force. Hits without a force or without responses are left out.
std::vector<PointLevel> levels_of(const std::vector<AnalysedHit>& hits) {
  struct Logs {
    std::vector<double> force, response, pulse_s;
  };
  std::map<int, Logs> points;
  for (const std::size_t h : accepted_hits(hits)) {
    const auto log_response = log_response_of(hits[h]);
    const double peak_N = std::abs(hits[h].hit.peak_N);
    if (!log_response || !(peak_N > 0)) continue;
    Logs& logs = points[hits[h].point];
    logs.force.push_back(std::log(peak_N));
    logs.response.push_back(*log_response);
    logs.pulse_s.push_back(hits[h].hit.pulse_s);
  }
  std::vector<PointLevel> out;
  out.reserve(points.size());
  for (auto& [point, logs] : points) {
    out.push_back({.point = point,
                   .log_force = median(std::move(logs.force)),
                   .log_response = median(std::move(logs.response)),
                   .pulse_s = median(std::move(logs.pulse_s))});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const PointLevel& a, const PointLevel& b) { return a.log_force < b.log_force; });
  return out;
}

// Points of about the same force.
struct ForceGroup {
  std::vector<PointLevel> points;
  double log_force = 0, log_response = 0;  // medians
};

// Ascending by force.
std::vector<ForceGroup> groups_of(const std::vector<PointLevel>& ascending) {
  std::vector<ForceGroup> groups;
  for (const PointLevel& level : ascending) {
    const bool apart = groups.empty() || level.log_force - groups.back().points.back().log_force > std::log(kMinGap);
    if (apart) groups.emplace_back();
    groups.back().points.push_back(level);
  }
  for (ForceGroup& group : groups) {
    std::vector<double> force, response;
    for (const PointLevel& level : group.points) {
      force.push_back(level.log_force);
      response.push_back(level.log_response);
    }
    group.log_force = median(std::move(force));
    group.log_response = median(std::move(response));
    std::sort(group.points.begin(), group.points.end(),
              [](const PointLevel& a, const PointLevel& b) { return a.point < b.point; });
  }
  return groups;
}

std::string points_text(const PointNames& names, const std::vector<PointLevel>& levels) {
  std::vector<int> points;
  points.reserve(levels.size());
  for (const PointLevel& level : levels) points.push_back(level.point);
  return names.list(points, kMaxListedPoints);
}

// "about 1200 times smaller": two digits, because the blows vary.
std::string times_text(double log_ratio) {
  const double factor = std::stod(fmt::format("{:.1e}", std::exp(std::abs(log_ratio))));
  return fmt::format("about {} times {}", factor, log_ratio < 0 ? "smaller" : "larger");
}

Warning other_unit(const acquire::Record& record, const PointNames& names, const ForceGroup& group, double log_force) {
  const bool thousand = std::abs(std::abs(log_force) - std::log(kThousand)) < std::log(kNearThousand);
  Warning warning{"units_differ",
                  fmt::format("the force of the hits at {} is {} than at the other points, but the responses are not: "
                              "is the force in another unit there{}, or its sensitivity wrong? FRFs, residues, shapes "
                              "and modal masses are wrong then",
                              points_text(names, group.points), times_text(log_force),
                              thousand ? " (kN for N, mV for V)" : " (V for N)")};
  if (record.files.size() < 2) return with_remedy(std::move(warning), "write the force of all points in one unit");
  warning.options = {"force_scale"};
  return with_remedy(std::move(warning), "state the scale of the force in N per stored unit, one value for each file");
}

Warning weak_points(const PointNames& names, const ForceGroup& group, double log_force, double log_response) {
  const std::string points = points_text(names, group.points);
  Warning warning{"weak", fmt::format("the hits at {} are much weaker than at the other points: the force is {}, the "
                                      "responses {}. FRFs and shapes are mostly noise there; or, if the force is in "
                                      "another unit there, they and the modal masses are wrong",
                                      points, times_text(log_force), times_text(log_response))};
  return with_remedy(std::move(warning), "repeat these hits, or check the unit of their force");
}

// The force level and pulse of most points.
struct UsualForce {
  double log_force = 0, pulse_s = 0;
  std::set<int> points;
};

// Points of the usual force, and points whose force differs from it by kMinRangeFactor or more with the same pulse.
struct DoubtedForces {
  UsualForce usual;
  std::vector<PointLevel> doubtful;
};

// Nothing if too few points have the usual force.
std::optional<DoubtedForces> doubted_forces(const std::vector<PointLevel>& levels) {
  std::vector<double> all;
  for (const PointLevel& level : levels) all.push_back(level.log_force);
  if (all.size() < kMinUsualPoints + 1) return std::nullopt;
  const double middle = median(std::move(all));
  DoubtedForces out;
  std::vector<double> force, pulse_s;
  for (const PointLevel& level : levels) {
    if (std::abs(level.log_force - middle) >= std::log(kMinRangeFactor)) continue;
    out.usual.points.insert(level.point);
    force.push_back(level.log_force);
    pulse_s.push_back(level.pulse_s);
  }
  const std::size_t others = levels.size() - out.usual.points.size();
  if (out.usual.points.size() < kMinUsualPoints || others == 0 || kPointsPerDoubtful * others > levels.size())
    return std::nullopt;
  out.usual.log_force = median(std::move(force));
  out.usual.pulse_s = median(std::move(pulse_s));
  for (const PointLevel& level : levels) {
    const double difference = level.log_force - out.usual.log_force;
    const bool same_pulse =
        level.pulse_s <= kMaxPulseFactor * out.usual.pulse_s && level.pulse_s >= out.usual.pulse_s / kMaxPulseFactor;
    if (std::abs(difference) >= std::log(kMinRangeFactor) && same_pulse) out.doubtful.push_back(level);
  }
  return out;
}

// A mode's amplitude at one point, over all channels, in 1/kg.
struct Amplitude {
  double squared = 0, variance = 0;
};

// For each mode that shows clearly at the `usual` points: its amplitude at `point` over its largest amplitude there,
// descending. Leaves out a mode whose amplitude at `point` is neither clear nor small.
std::vector<double> relative_motions(const std::vector<identify::Mode>& modes, int point, const std::set<int>& usual) {
  std::vector<double> out;
  for (const identify::Mode& mode : modes) {
    std::map<std::size_t, Amplitude> at;
    for (const identify::Residue& residue : mode.residues) {
      Amplitude& sum = at[residue.point];
      sum.squared += std::norm(residue.value);
      sum.variance += residue.std * residue.std;
    }
    const auto clear = [](const Amplitude& a) { return a.squared >= kClearAmplitude * kClearAmplitude * a.variance; };
    double largest = 0;
    for (const auto& [p, amplitude] : at) {
      if (usual.contains(static_cast<int>(p)) && clear(amplitude)) largest = std::max(largest, amplitude.squared);
    }
    const auto own = at.find(static_cast<std::size_t>(point));
    if (!(largest > 0) || own == at.end()) continue;
    const double ratio = std::sqrt(own->second.squared / largest);
    if (clear(own->second) || ratio <= kSmallMotion) out.push_back(ratio);
  }
  std::sort(out.begin(), out.end(), std::greater<>());
  return out;
}

// Whether the modes move at the point as if its force were wrong by about 10 in this direction.
bool moves_wrongly(const std::vector<double>& descending, bool smaller_force) {
  if (descending.size() < kMinModesOfRange) return false;
  return smaller_force ? descending[1] >= kLargeMotion : descending[0] <= kSmallMotion;
}

Warning other_range(const acquire::Record& record, const PointNames& names, const std::vector<PointLevel>& levels,
                    double log_force) {
  constexpr double kUsualFactor = 10;  // between ranges or gains
  Warning warning{"units_differ",
                  fmt::format("the force of the hits at {} is {} than at the other points, but the responses and the "
                              "pulses are not: was the range or the gain of the hammer's channel another one there (a "
                              "factor of 10)? FRFs, residues, shapes and modal masses are wrong then",
                              points_text(names, levels), times_text(log_force))};
  if (record.files.size() < 2) return with_remedy(std::move(warning), "correct the force of these points in the file");
  warning.options = {"force_scale"};
  const double usual = record.force.to_SI, here = log_force < 0 ? usual * kUsualFactor : usual / kUsualFactor;
  return with_remedy(std::move(warning),
                     fmt::format("state the scale of the force in N per stored unit, one value for each file: {:.6g} "
                                 "for the files of {}, {:.6g} for the others, if the factor is 10",
                                 here, levels.size() == 1 ? "this point" : "these points", usual));
}

}  // namespace

std::vector<Warning> point_force_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                          const PointNames& names) {
  const std::vector<ForceGroup> groups = groups_of(levels_of(hits));
  if (groups.size() < 2) return {};
  // Of two groups with as many points, the weaker one is in doubt.
  const ForceGroup* usual = &groups.front();
  for (const ForceGroup& group : groups) {
    if (group.points.size() >= usual->points.size()) usual = &group;
  }
  std::vector<Warning> out;
  for (const ForceGroup& group : groups) {
    const double log_force = group.log_force - usual->log_force;
    const double log_response = group.log_response - usual->log_response;
    if (std::abs(log_force) < std::log(kMinFactor)) continue;
    const double sign = log_force < 0 ? -1 : 1;
    if (sign * log_response < std::log(kMaxResponseFactor)) {
      out.push_back(other_unit(record, names, group, log_force));
    } else if (log_force < 0) {
      out.push_back(weak_points(names, group, log_force, log_response));
    }
  }
  return out;
}

std::vector<Warning> point_range_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                          const std::vector<identify::Mode>& modes, const PointNames& names) {
  const std::optional<DoubtedForces> forces = doubted_forces(levels_of(hits));
  if (!forces) return {};
  std::vector<Warning> out;
  for (const bool smaller : {true, false}) {
    std::vector<PointLevel> wrong;
    std::vector<double> differences;
    for (const PointLevel& level : forces->doubtful) {
      const double difference = level.log_force - forces->usual.log_force;
      if ((difference < 0) != smaller) continue;
      if (!moves_wrongly(relative_motions(modes, level.point, forces->usual.points), smaller)) continue;
      wrong.push_back(level);
      differences.push_back(difference);
    }
    if (wrong.empty()) continue;
    std::sort(wrong.begin(), wrong.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
    out.push_back(other_range(record, names, wrong, median(std::move(differences))));
  }
  return out;
}

}  // namespace percuss::pipeline
