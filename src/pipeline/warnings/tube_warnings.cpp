#include "pipeline/warnings/tube_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "identify/classify/ratio_likelihood.hpp"
#include "identify/classify/tube_evidence.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kClear_rad = 0.05;         // ± of the angle of a ratio that counts
constexpr double kInPhase = 0.4;            // RatioAngle::out_of_phase of a real shape
constexpr double kMidway_rad = 0.1;         // 6°, from ratios of ±1
constexpr double kRightAngle = 0.1;         // cosine of the angle between the sensors
constexpr double kOwnMode = 0.04;           // relative distance of modes that are no pair of one mode
constexpr std::size_t kMinTubeModes = 3;    // that make a statement
constexpr double kSameFactor = 0.15;        // of the logarithm of a ratio: gains and angles of sensors
constexpr double kLikeHoop = 0.25;          // the same, from −1
constexpr double kContradiction = -4;       // log_tube_evidence of the lowest modes
constexpr double kFirstBendingRatio = 2.3;  // of the second bending frequency over the first; slender tubes have more
constexpr double kSureConfidence = 0.9;

struct ClearRatio {
  double freq_Hz = 0, ratio = 0;
  identify::RatioAngle angle;
};

std::vector<ClearRatio> clear_ratios(const std::vector<identify::Mode>& modes,
                                     const std::vector<identify::ModeClassification>& classifications) {
  std::vector<ClearRatio> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto& ratio = classifications[m].ratio;
    if (!ratio) continue;
    const double square = 1 + std::norm(*ratio);
    const identify::RatioAngle angle{.chi_rad = std::atan(ratio->real()),
                                     .std_rad = classifications[m].ratio_std / square,
                                     .out_of_phase = 2 * std::abs(ratio->imag()) / square};
    if (angle.std_rad < kClear_rad && angle.out_of_phase < kInPhase)
      out.push_back({modes[m].pole.freq_Hz, ratio->real(), angle});
  }
  return out;
}

// The number of modes, each pair of one mode counted once. The ratios ascend in frequency.
std::size_t different_modes(const std::vector<ClearRatio>& ratios) {
  std::size_t count = 0;
  double before_Hz = 0;
  for (const ClearRatio& one : ratios) {
    if (one.freq_Hz > (1 + kOwnMode) * before_Hz) ++count;
    before_Hz = one.freq_Hz;
  }
  return count;
}

std::vector<Warning> midway_hit(const std::vector<ClearRatio>& ratios) {
  if (different_modes(ratios) < kMinTubeModes) return {};
  const auto all_near = [&](double chi_rad) {
    return std::all_of(ratios.begin(), ratios.end(),
                       [&](const ClearRatio& one) { return std::abs(one.angle.chi_rad - chi_rad) < kMidway_rad; });
  };
  constexpr double kEighth_rad = std::numbers::pi / 4;
  constexpr const char* kRemedy = "strike in line with one of the sensors";
  if (all_near(-kEighth_rad)) {
    return {
        with_remedy({"midway_hit",
                     "in every mode, the two sensors move by the same amount in opposite phase. Hoop modes do that, "
                     "and also bending modes if the hits were halfway between one sensor and the place opposite the "
                     "other (135° for sensors at 0° and 90°): the types are not told apart"},
                    kRemedy)};
  }
  if (all_near(kEighth_rad)) {
    return {with_remedy({"midway_hit",
                         "in every mode, the two sensors move alike: the hits were halfway between them (45°). Hoop "
                         "modes then have nodes at both sensors, and are missing"},
                        kRemedy)};
  }
  return {};
}

// Sensors at right angles move against each other in every hoop mode, whatever the direction of the hits. A bending
// mode moves them alike where its plane lies halfway between them. Where the other modes show one plane elsewhere,
// modes that move the sensors alike are hoop modes of which one sensor is reversed.
std::vector<Warning> reversed_sensor(const acquire::Record& record, const std::vector<ClearRatio>& ratios,
                                     const identify::SensorPair& sensors) {
  std::vector<ClearRatio> alike, others;
  for (const ClearRatio& one : ratios)
    (std::abs(one.angle.chi_rad - std::numbers::pi / 4) < kMidway_rad ? alike : others).push_back(one);
  if (different_modes(alike) < 2 || different_modes(others) < 2) return {};
  const auto [least, most] =
      std::minmax_element(others.begin(), others.end(),
                          [](const ClearRatio& a, const ClearRatio& b) { return a.angle.chi_rad < b.angle.chi_rad; });
  const bool one_plane = most->angle.chi_rad - least->angle.chi_rad < kMidway_rad;
  if (!one_plane || std::abs(least->angle.chi_rad + std::numbers::pi / 4) < kMidway_rad) return {};
  return {with_remedy(
      {"reversed",
       fmt::format("{} and {} move alike by the same amount in {} modes. Hoop modes of a tube move sensors at right "
                   "angles against each other: is one of the sensors reversed? Mode types and the plane of bending "
                   "are wrong then",
                   one_line(record.accel[sensors.first].name, kMaxNameBytes),
                   one_line(record.accel[sensors.second].name, kMaxNameBytes), alike.size()),
       {"setup", "accel_scale"}},
      R"(check which way the sensors point, and state "sign": -1 for the reversed one in the set-up, or a negative )"
      "scale")};
}

std::vector<Warning> mixed_units(const acquire::Record& record, const std::vector<ClearRatio>& ratios,
                                 const identify::SensorPair& sensors) {
  for (const double factor : {kStandardGravity_mps2, 10.0}) {
    for (const bool second_larger : {true, false}) {
      const double expected = second_larger ? factor : 1 / factor;
      std::vector<double> at_factor;
      std::size_t like_hoop = 0;
      for (const ClearRatio& one : ratios) {
        if (!(one.ratio < 0)) continue;
        if (std::abs(std::log(-one.ratio / expected)) < kSameFactor)
          at_factor.push_back(second_larger ? -one.ratio : -1 / one.ratio);
        if (std::abs(std::log(-one.ratio)) < kLikeHoop) ++like_hoop;
      }
      if (at_factor.size() < 2 || like_hoop > 0 || at_factor.size() == ratios.size()) continue;
      const std::size_t larger = second_larger ? sensors.second : sensors.first;
      const std::size_t other = second_larger ? sensors.first : sensors.second;
      return {with_remedy(
          {"units_differ",
           fmt::format(
               "{} is {:.3g} times {}, with the opposite sign, in {} modes. Hoop modes of a tube have equal "
               "sizes there: is one of them in g and the other in m/s², or a sensitivity wrong by 10, or an angle "
               "of a sensor wrong? Residues, shapes and mode types are wrong then",
               one_line(record.accel[larger].name, kMaxNameBytes), median(at_factor),
               one_line(record.accel[other].name, kMaxNameBytes), at_factor.size()),
           {"unit", "accel_scale", "angle"}},
          "state the unit, or the scale and the angle of each channel")};
    }
  }
  return {};
}

std::vector<Warning> contradicted_angles(std::vector<ClearRatio> lowest, const identify::SensorPair& sensors,
                                         const identify::ClassifyOptions& options) {
  if (options.angles_assumed || lowest.size() < kMinTubeModes) return {};
  lowest.resize(kMinTubeModes);
  std::vector<identify::RatioAngle> angles;
  for (const ClearRatio& one : lowest) angles.push_back(one.angle);
  const identify::SetUpError error{.angle_rad = options.angle_std_rad, .gain = options.gain_std};
  const identify::RatioLikelihood likelihood(sensors.first_rad, sensors.second_rad, error);
  if (identify::log_tube_evidence(angles, likelihood) > kContradiction) return {};
  return {with_remedy(
      {"angles_contradicted",
       fmt::format("the {} lowest modes do not fit a tube with sensors at {:.0f}° and {:.0f}°: an angle, a sign, a "
                   "unit or a sensitivity is wrong, or it is no tube. Bending and hoop are wrong then",
                   kMinTubeModes, sensors.first_rad * kRadian_deg, sensors.second_rad * kRadian_deg),
       {"angle", "object"}},
      "check and state the sensors' angles, or that it is another object")};
}

// The lowest frequency of a sure bending order.
std::optional<double> bending_Hz(const std::vector<identify::Mode>& modes,
                                 const std::vector<identify::ModeClassification>& classifications, int order) {
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const identify::ModeClassification& mode = classifications[m];
    if (mode.type == identify::ModeType::bending && mode.order == order && mode.confidence > kSureConfidence)
      return modes[m].pole.freq_Hz;
  }
  return std::nullopt;
}

std::vector<Warning> missing_order(const std::vector<identify::Mode>& modes,
                                   const std::vector<identify::ModeClassification>& classifications) {
  const auto first_Hz = bending_Hz(modes, classifications, 1), second_Hz = bending_Hz(modes, classifications, 2);
  if (!first_Hz || !second_Hz || *second_Hz > kFirstBendingRatio * *first_Hz) return {};
  return {with_remedy(
      {"order_missing",
       fmt::format("the two lowest bending modes, {:.5g} and {:.5g} Hz, have a ratio of {:.2f}. The first two of a "
                   "slender tube have more than {:g}: the first is probably missing, as for hits on its node, and "
                   "every bending order is then one too low",
                   *first_Hz, *second_Hz, *second_Hz / *first_Hz, kFirstBendingRatio)},
      "strike also at another place")};
}

}  // namespace

std::vector<Warning> tube_warnings(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                   const std::vector<identify::ModeClassification>& classifications,
                                   const identify::ClassifyOptions& options, bool complete) {
  std::vector<std::optional<double>> angles_rad;
  for (const acquire::SignalInfo& accel : record.accel) angles_rad.push_back(accel.angle_rad);
  const auto sensors = identify::pair_of_sensors(angles_rad);
  if (!sensors) return {};
  const std::vector<ClearRatio> ratios = clear_ratios(modes, classifications);
  const bool right_angle = std::abs(std::cos(sensors->second_rad - sensors->first_rad)) < kRightAngle;
  std::vector<Warning> out;
  const auto add = [&](std::vector<Warning> more) { out.insert(out.end(), more.begin(), more.end()); };
  if (right_angle) add(midway_hit(ratios));
  if (right_angle) add(reversed_sensor(record, ratios, *sensors));
  if (right_angle) add(mixed_units(record, ratios, *sensors));
  if (out.empty()) add(contradicted_angles(ratios, *sensors, options));
  if (complete && out.empty()) add(missing_order(modes, classifications));
  return out;
}

}  // namespace percuss::pipeline
