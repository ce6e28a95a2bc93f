#include "pipeline/warnings/tube_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "identify/classify/mode_partners.hpp"
#include "identify/classify/ratio_likelihood.hpp"
#include "identify/classify/set_up_evidence.hpp"
#include "identify/classify/tube_evidence.hpp"
#include "pipeline/channels/sensor_factor.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kClear_rad = 0.05;         // largest ± of the angle of a ratio that is used
constexpr double kInPhase = 0.4;            // RatioAngle::out_of_phase of a real shape
constexpr double kMidway_rad = 0.1;         // 6°, from ratios of ±1
constexpr double kRightAngle = 0.1;         // cosine of the angle between the sensors
constexpr double kOwnMode = 0.04;           // relative distance of modes that are no pair of one mode
constexpr std::size_t kMinTubeModes = 3;    // modes that a statement needs
constexpr double kSamePlace_m = 0.02;       // sensors farther apart along the tube have other ratios
constexpr double kDecisive = 6;             // log_fault_evidence: the fault is 400 times as likely
constexpr double kSameFactor = 0.15;        // of the logarithm of a ratio, at a factor: errors of gains and angles
constexpr double kLikeHoop = 0.25;          // of the logarithm of a ratio, near the −1 of a hoop mode
constexpr double kOtherRatio = 0.4;         // of the logarithm of a ratio, from a factor: clearly another ratio
constexpr double kLargeFactor = 100;        // no two bending planes lie by chance so near to the axis of a sensor
constexpr double kNotRefuted = -1;          // log_fault_evidence of a large factor that two modes show exactly
constexpr double kContradiction = -4;       // log_tube_evidence of the lowest modes
constexpr double kFirstBendingRatio = 2.3;  // of the second bending frequency over the first; slender tubes have more
constexpr double kSureConfidence = 0.9;

struct ClearRatio {
  double freq_Hz = 0, ratio = 0;
  identify::RatioAngle angle;
  double size = 1;  // of both sensors' residues together
};

double size_at(const identify::Mode& mode, const identify::SensorPair& sensors) {
  double power = 0;
  for (const identify::Residue& residue : mode.residues) {
    if (residue.channel == sensors.first || residue.channel == sensors.second) power += std::norm(residue.value);
  }
  return power > 0 ? std::sqrt(power) : 1;
}

std::vector<ClearRatio> clear_ratios(const std::vector<identify::Mode>& modes,
                                     const std::vector<identify::ModeClassification>& classifications,
                                     const identify::SensorPair& sensors) {
  std::vector<ClearRatio> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto& ratio = classifications[m].ratio;
    if (!ratio) continue;
    const double square = 1 + std::norm(*ratio);
    const identify::RatioAngle angle{.chi_rad = std::atan(ratio->real()),
                                     .std_rad = classifications[m].ratio_std / square,
                                     .out_of_phase = 2 * std::abs(ratio->imag()) / square};
    if (angle.std_rad < kClear_rad && angle.out_of_phase < kInPhase)
      out.push_back({modes[m].pole.freq_Hz, ratio->real(), angle, size_at(modes[m], sensors)});
  }
  return out;
}

// The number of modes. The two modes of a pair, within kOwnMode of each other, count once. The ratios ascend in
// frequency.
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

identify::RatioLikelihood likelihood_of(const identify::SensorPair& sensors, const identify::ClassifyOptions& options) {
  return {sensors.first_rad, sensors.second_rad, {.angle_rad = options.angle_std_rad, .gain = options.gain_std}};
}

// The evidence of all clear ratios for a fault of the set-up.
class FaultEvidence {
 public:
  FaultEvidence(const std::vector<ClearRatio>& ratios, const identify::SensorPair& sensors,
                const identify::ClassifyOptions& options)
      : likelihood_(likelihood_of(sensors, options)) {
    for (const ClearRatio& one : ratios)
      modes_.push_back({.freq_Hz = one.freq_Hz, .size = one.size, .ratio = one.angle, .partner = {}});
    identify::find_partners(modes_, options);
  }

  double log_factor(double factor) const { return identify::log_fault_evidence(modes_, likelihood_, factor); }

  // Whether the ratios are those of a tube, once the fault is corrected.
  bool fits_tube(double factor) const {
    std::vector<identify::RatioAngle> corrected;
    for (const identify::TypeEvidence& mode : modes_) corrected.push_back(identify::divided_by(*mode.ratio, factor));
    return identify::log_tube_evidence(corrected, likelihood_) > kContradiction;
  }

 private:
  identify::RatioLikelihood likelihood_;
  std::vector<identify::TypeEvidence> modes_;
};

// Hoop modes move sensors at right angles against each other for any direction of the hits, so opposite signs prove
// nothing. The sign of a bending mode depends on its plane. Modes that move both sensors alike by the same amount are
// hoop modes with a reversed sensor, or bending modes halfway between the sensors: the evidence of all modes decides.
std::vector<Warning> reversed_sensor(const acquire::Record& record, const std::vector<ClearRatio>& ratios,
                                     const identify::SensorPair& sensors, const FaultEvidence& evidence) {
  constexpr double kReversed = -1;
  if (!(evidence.log_factor(kReversed) > kDecisive && evidence.fits_tube(kReversed))) return {};
  const auto alike = std::count_if(ratios.begin(), ratios.end(), [](const ClearRatio& one) {
    return std::abs(one.angle.chi_rad - std::numbers::pi / 4) < kMidway_rad;
  });
  const std::string first = one_line(record.accel[sensors.first].name, kMaxNameBytes);
  const std::string second = one_line(record.accel[sensors.second].name, kMaxNameBytes);
  const std::string moves =
      alike > 0 ? fmt::format(
                      "{} and {} move alike by the same amount in {} mode{}. Hoop modes of a tube move sensors "
                      "at right angles against each other",
                      first, second, alike, alike == 1 ? "" : "s")
                : fmt::format("the ratios of {} and {} in {} modes fit a tube only if one of them is reversed", first,
                              second, ratios.size());
  return {with_remedy(
      {"reversed",
       moves + ": is one of the sensors reversed? Mode types and the plane of bending are wrong then",
       {"setup", "accel_scale"}},
      R"(check which way the sensors point, and state "sign": -1 for the reversed one in the set-up, or a negative )"
      "scale")};
}

// A factor between two units that are confused, and the question that it raises.
struct UnitFactor {
  double factor;
  const char* question;
};
constexpr double kInch_per_m = 39.3701;
constexpr std::array kUnitFactors{
    UnitFactor{kStandardGravity_mps2, "is one of them in g and the other in m/s², or a sensitivity wrong by 10"},
    UnitFactor{10, "is one of them in g and the other in m/s², or a sensitivity wrong by 10"},
    UnitFactor{kInch_per_m, "is one of them in in/s² and the other in m/s²"},
    UnitFactor{kInch_per_m * kStandardGravity_mps2, "is one of them in in/s² and the other in g"},
    UnitFactor{1000, "is one of them in mm/s² or mV, or a sensitivity wrong by 1000"}};

std::string ratio_text(double ratio) {
  constexpr double kWhole = 100;
  return ratio < kWhole ? fmt::format("{:.3g}", ratio) : fmt::format("{:.0f}", ratio);
}

// The ratios that are about −expected, as hoop modes have with such units; each as a number above 1.
std::vector<double> ratios_at(double expected, const std::vector<ClearRatio>& ratios) {
  std::vector<double> out;
  for (const ClearRatio& one : ratios) {
    if (one.ratio < 0 && std::abs(std::log(-one.ratio / expected)) < kSameFactor)
      out.push_back(expected > 1 ? -one.ratio : -1 / one.ratio);
  }
  return out;
}

// Whether two modes or more have the ratio −expected of hoop modes with such units, and all other modes clearly another
// ratio: bending modes in one plane near the axis of a sensor would have similar ratios.
bool shown_exactly(double expected, const std::vector<ClearRatio>& ratios) {
  const std::size_t count = ratios_at(expected, ratios).size();
  const auto beside = [&](const ClearRatio& one) {
    if (!(one.ratio < 0)) return false;
    const double off = std::abs(std::log(-one.ratio / expected));
    return std::abs(std::log(-one.ratio)) < kLikeHoop || (off >= kSameFactor && off < kOtherRatio);
  };
  return count >= 2 && count < ratios.size() && std::none_of(ratios.begin(), ratios.end(), beside);
}

// A constant ratio of bending modes is the tangent of their plane, not a unit. A unit is named only if the orientation
// of the tube and of the blow cannot explain the ratios.
std::vector<Warning> mixed_units(const acquire::Record& record, const std::vector<ClearRatio>& ratios,
                                 const identify::SensorPair& sensors, const FaultEvidence& evidence) {
  const UnitFactor* best = nullptr;
  double best_factor = 1, most = -std::numeric_limits<double>::infinity();
  for (const UnitFactor& unit : kUnitFactors) {
    for (const double factor : {unit.factor, 1 / unit.factor}) {
      const double log_factor = evidence.log_factor(factor);
      const bool exact = unit.factor > kLargeFactor && log_factor > kNotRefuted && shown_exactly(factor, ratios);
      if (!((log_factor > kDecisive || exact) && log_factor > most && evidence.fits_tube(factor))) continue;
      most = log_factor;
      best = &unit;
      best_factor = factor;
    }
  }
  if (best == nullptr) return {};
  const bool second_larger = best_factor > 1;
  const std::string larger = one_line(record.accel[second_larger ? sensors.second : sensors.first].name, kMaxNameBytes);
  const std::string other = one_line(record.accel[second_larger ? sensors.first : sensors.second].name, kMaxNameBytes);
  const std::vector<double> at_factor = ratios_at(best_factor, ratios);
  const std::string finding =
      at_factor.empty()
          ? fmt::format("the ratios of {} and {} in {} modes fit a tube only if {} is about {:.3g} times too large",
                        larger, other, ratios.size(), larger, best->factor)
          : fmt::format(
                "{} is {} times {}, with the opposite sign, in {} mode{}. Hoop modes of a tube have equal "
                "sizes there",
                larger, ratio_text(median(at_factor)), other, at_factor.size(), at_factor.size() == 1 ? "" : "s");
  return {with_remedy({"units_differ",
                       fmt::format("{}: {}, or an angle of a sensor wrong? Residues, shapes and mode types are wrong "
                                   "then",
                                   finding, best->question),
                       {"unit", "accel_scale", "angle"}},
                      "state the unit, or the scale and the angle of each channel")};
}

// A factor of no unit, as of exchanged or wrong sensitivities.
std::vector<Warning> wrong_sensitivity(const acquire::Record& record, const std::vector<ClearRatio>& ratios,
                                       const identify::SensorPair& sensors, const FaultEvidence& evidence) {
  std::vector<SensorRatio> measured;
  measured.reserve(ratios.size());
  for (const ClearRatio& one : ratios) measured.push_back({one.freq_Hz, one.ratio, one.angle.std_rad});
  const auto found = sensor_factor(measured);
  if (!found || !evidence.fits_tube(found->factor)) return {};
  const bool second_larger = found->factor > 1;
  const std::string larger = one_line(record.accel[second_larger ? sensors.second : sensors.first].name, kMaxNameBytes);
  const std::string other = one_line(record.accel[second_larger ? sensors.first : sensors.second].name, kMaxNameBytes);
  const std::string factor = ratio_text(second_larger ? found->factor : 1 / found->factor);
  return {with_remedy(
      {"units_differ",
       fmt::format("{} is {} times {}, with the opposite sign, in {} modes. Hoop modes of a tube have equal sizes "
                   "there: is the sensitivity of one of them wrong, or are the sensitivities exchanged (10 and 100 "
                   "mV/g in the wrong order give a factor of 100)? Residues, shapes and mode types are wrong then",
                   larger, factor, other, found->hoop_ratios.size()),
       {"accel_sensitivity", "accel_scale", "unit"}},
      "state the sensitivities in the order of the channels, or the scale of each channel")};
}

// Whether both sensors are at one place along the tube; true if a place is not stated.
bool at_one_place(const acquire::Record& record, const identify::SensorPair& sensors) {
  const auto &first_m = record.accel[sensors.first].position_m, &second_m = record.accel[sensors.second].position_m;
  return !first_m || !second_m || std::abs(*first_m - *second_m) < kSamePlace_m;
}

std::vector<Warning> contradicted_angles(std::vector<ClearRatio> lowest, const identify::SensorPair& sensors,
                                         const identify::ClassifyOptions& options) {
  if (options.angles_assumed || lowest.size() < kMinTubeModes) return {};
  lowest.resize(kMinTubeModes);
  std::vector<identify::RatioAngle> angles;
  angles.reserve(lowest.size());
  for (const ClearRatio& one : lowest) angles.push_back(one.angle);
  if (identify::log_tube_evidence(angles, likelihood_of(sensors, options)) > kContradiction) return {};
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
  const std::vector<ClearRatio> ratios = clear_ratios(modes, classifications, *sensors);
  const bool right_angle = std::abs(std::cos(sensors->second_rad - sensors->first_rad)) < kRightAngle;
  std::vector<Warning> out;
  const auto add = [&](std::vector<Warning> more) { out.insert(out.end(), more.begin(), more.end()); };
  if (right_angle) add(midway_hit(ratios));
  if (out.empty() && ratios.size() >= kMinTubeModes && at_one_place(record, *sensors)) {
    const FaultEvidence evidence(ratios, *sensors, options);
    add(reversed_sensor(record, ratios, *sensors, evidence));
    if (right_angle && out.empty()) add(mixed_units(record, ratios, *sensors, evidence));
    if (right_angle && out.empty()) add(wrong_sensitivity(record, ratios, *sensors, evidence));
  }
  if (out.empty()) add(contradicted_angles(ratios, *sensors, options));
  if (complete && out.empty()) add(missing_order(modes, classifications));
  return out;
}

}  // namespace percuss::pipeline
