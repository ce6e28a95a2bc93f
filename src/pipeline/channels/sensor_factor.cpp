#include "pipeline/channels/sensor_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

using std::numbers::pi;

constexpr double kMinSensorFactor = 3;       // errors of angles and gains stay below
constexpr double kMaxRelativeStd = 0.1;      // of the ratio of a hoop mode
constexpr double kMaxAngle_rad = 0.05;       // largest ± of the direction of a bending mode, without the factor
constexpr double kOneRatio = 0.15;           // of the logarithm, between hoop modes: errors of angles and gains
constexpr double kClearlyOther = 0.4;        // of the logarithm: a bending mode that is no hoop mode
constexpr double kMisplacedHoop = 0.8;       // of the logarithm: a weak hoop mode whose sensors are misplaced
constexpr double kNearMinusOne = 0.25;       // of the logarithm: a hoop mode of right scales
constexpr double kOnePlane_rad = 0.1;        // 6°, scatter of the planes of bending modes
constexpr double kNearRightAngle_rad = 0.2;  // 11°, from the angle between the two planes of a tube
constexpr double kNearHoopNodes_rad = 0.15;  // 9°, from ±45°; sensors misplaced by 5° give a factor of 3 up to 7°
constexpr double kDistinctFrequency = 0.04;  // relative distance of modes that are no pair of one mode
constexpr std::size_t kMinHoopModes = 2, kMinLowerModes = 2, kMinBendingModes = 3;  // of different frequency

double relative_ratio_std(const SensorRatio& one) {
  return one.angle_std_rad * (1 + one.ratio * one.ratio) / std::abs(one.ratio);
}

// |ln(ratio/−factor)|, infinite for a positive ratio.
double distance_from_hoop(const SensorRatio& one, double factor) {
  return one.ratio < 0 ? std::abs(std::log(-one.ratio / factor)) : std::numeric_limits<double>::infinity();
}

bool at_right_angles(const SensorRatio& one, double ratio) {
  return std::abs(std::remainder(std::atan(one.ratio) - std::atan(ratio) - pi / 2, pi)) < kNearRightAngle_rad;
}

std::size_t frequencies_of(const std::vector<SensorRatio>& modes, double below_Hz) {
  std::size_t count = 0;
  double before_Hz = 0;
  for (const SensorRatio& one : modes) {
    if (one.freq_Hz >= below_Hz) break;
    if (one.freq_Hz > (1 + kDistinctFrequency) * before_Hz) ++count;
    before_Hz = one.freq_Hz;
  }
  return count;
}

std::size_t frequencies_of(const std::vector<SensorRatio>& modes) {
  return frequencies_of(modes, std::numeric_limits<double>::infinity());
}

std::vector<SensorRatio> modes_at(double factor, const std::vector<SensorRatio>& ratios) {
  std::vector<SensorRatio> out;
  for (const SensorRatio& one : ratios) {
    if (distance_from_hoop(one, factor) < kOneRatio && relative_ratio_std(one) < kMaxRelativeStd) out.push_back(one);
  }
  return out;
}

// Relative standard deviations are those of the ratio without the factor, too.
double corrected_std_rad(const SensorRatio& one, double factor) {
  const double corrected = one.ratio / factor;
  return relative_ratio_std(one) * std::abs(corrected) / (1 + corrected * corrected);
}

// The bending modes, or none where a mode contradicts the factor.
std::vector<SensorRatio> bending_modes(double factor, double lowest_hoop_Hz, const std::vector<SensorRatio>& ratios) {
  std::vector<SensorRatio> out;
  for (const SensorRatio& one : ratios) {
    const double distance = distance_from_hoop(one, factor);
    if (distance < kOneRatio && relative_ratio_std(one) < kMaxRelativeStd) continue;
    if (one.freq_Hz > lowest_hoop_Hz / 2 && distance_from_hoop(one, 1) < kNearMinusOne) return {};
    // Three waves around the barrel begin at 2.2 times the lowest hoop mode.
    if (one.freq_Hz >= 2 * lowest_hoop_Hz || (one.freq_Hz > lowest_hoop_Hz && distance < kMisplacedHoop)) continue;
    if (!(corrected_std_rad(one, factor) < kMaxAngle_rad)) continue;
    if (distance < kClearlyOther) return {};
    out.push_back(one);
  }
  return out;
}

// Whether a tube with right scales may have the measured ratios: with two planes at right angles, or with sensors at
// the nodes of its hoop modes.
bool explained_without_factor(double factor, const std::vector<SensorRatio>& bending) {
  return std::any_of(bending.begin(), bending.end(), [&](const SensorRatio& one) {
    return std::abs(std::remainder(std::atan(one.ratio) - pi / 4, pi / 2)) < kNearHoopNodes_rad ||
           at_right_angles(one, -factor) || std::any_of(bending.begin(), bending.end(), [&](const SensorRatio& other) {
             return at_right_angles(one, other.ratio);
           });
  });
}

bool in_one_plane(double factor, const std::vector<SensorRatio>& bending) {
  const double first_rad = std::atan(bending.front().ratio / factor);
  return std::all_of(bending.begin(), bending.end(), [&](const SensorRatio& one) {
    return std::abs(std::remainder(std::atan(one.ratio / factor) - first_rad, pi / 2)) < kOnePlane_rad;
  });
}

}  // namespace

std::optional<SensorFactor> sensor_factor(const std::vector<SensorRatio>& ratios) {
  for (const SensorRatio& candidate : ratios) {
    if (!(candidate.ratio < 0 && distance_from_hoop(candidate, 1) > std::log(kMinSensorFactor))) continue;
    SensorFactor found;
    for (const SensorRatio& one : modes_at(-candidate.ratio, ratios)) found.hoop_ratios.push_back(one.ratio);
    if (found.hoop_ratios.size() < kMinHoopModes) continue;
    found.factor = -median(found.hoop_ratios);
    const std::vector<SensorRatio> hoop = modes_at(found.factor, ratios);
    if (hoop.size() != found.hoop_ratios.size() || frequencies_of(hoop) < kMinHoopModes) continue;
    const double lowest_hoop_Hz = hoop.front().freq_Hz;
    const std::vector<SensorRatio> bending = bending_modes(found.factor, lowest_hoop_Hz, ratios);
    if (frequencies_of(bending, lowest_hoop_Hz) < kMinLowerModes || frequencies_of(bending) < kMinBendingModes)
      continue;
    if (!explained_without_factor(found.factor, bending) && in_one_plane(found.factor, bending)) return found;
  }
  return std::nullopt;
}

}  // namespace percuss::pipeline
