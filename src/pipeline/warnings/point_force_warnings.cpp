#include "pipeline/warnings/point_force_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

// Blows of one hammer by hand differ by a factor of 5 or so. Units that differ by less than the limit, such as lbf
// (4.45 N) and kgf (9.81 N), cannot be told from soft blows. 22.5 mV/N that is not stated gives a factor of 44.
constexpr double kMinFactor = 25;
constexpr double kMinGap = 10;  // between the forces of neighbouring points in ascending order: they are two groups
// Responses of one structure to equal blows at its points differ by less, except near supports.
constexpr double kMaxResponseFactor = 10;
constexpr double kThousand = 1000, kNearThousand = 3;  // kN and N, V and mV; blows themselves vary
constexpr std::size_t kMaxListedPoints = 20;

// Natural logarithms of a point's median force in N, and of its median response.
struct PointLevel {
  int point = 0;
  double log_force = 0, log_response = 0;
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
    std::vector<double> force, response;
  };
  std::map<int, Logs> points;
  for (const std::size_t h : accepted_hits(hits)) {
    const auto log_response = log_response_of(hits[h]);
    const double peak_N = std::abs(hits[h].hit.peak_N);
    if (!log_response || !(peak_N > 0)) continue;
    Logs& logs = points[hits[h].point];
    logs.force.push_back(std::log(peak_N));
    logs.response.push_back(*log_response);
  }
  std::vector<PointLevel> out;
  out.reserve(points.size());
  for (auto& [point, logs] : points) {
    out.push_back(
        {.point = point, .log_force = median(std::move(logs.force)), .log_response = median(std::move(logs.response))});
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

}  // namespace percuss::pipeline
