#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "metrics/protocol/certify.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/plausibility.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

bool within(double value, double middle, double tolerance) {
  return std::abs(value - middle) <= tolerance + kReadingTolerance;
}

void check_pairs(const std::vector<double>& pairs_mph, const char* code, const char* way, double tolerance_mph,
                 std::vector<ProtocolFinding>& reasons) {
  if (pairs_mph.empty()) return;
  const auto [low, high] = std::minmax_element(pairs_mph.begin(), pairs_mph.end());
  if (*high - *low <= tolerance_mph + kReadingTolerance) return;
  reasons.push_back({code, fmt::format("the gates' {} speeds differ by {:.2f} mph, more than {:g} mph", way,
                                       *high - *low, tolerance_mph)});
}

// A moment of inertia in another unit makes the verdict wrong, and no shot shows it.
void check_bat_readings(const SessionBat& bat, std::vector<ProtocolFinding>& reasons) {
  BatReadings readings{.length_m = UncertainValue(bat.length_in * kInch_m)};
  BatMetrics metrics;
  if (bat.weight_oz) readings.mass_kg = UncertainValue(*bat.weight_oz * kOunce_kg);
  if (bat.moi_ozin2) readings.moi_kgm2 = metrics.moi_kgm2 = UncertainValue(*bat.moi_ozin2 * kOunceInch2_kgm2);
  for (const auto& found : implausible_values(readings, metrics)) reasons.push_back({found.code, found.message});
}

void check_ball(const SessionShot& shot, BallUse& ball, const ProtocolLimits& limits,
                std::vector<ProtocolFinding>& reasons) {
  ++ball.impacts;
  ++ball.ears.at(static_cast<std::size_t>(shot.ear));
  ball.ball_g = shot.ball_g;
  if (!within(shot.ball_g, limits.ball_g, limits.ball_tolerance_g)) {
    reasons.push_back({"ball_mass", fmt::format("the ball weighs {:g} g, not {:g} ± {:g} g", shot.ball_g, limits.ball_g,
                                                limits.ball_tolerance_g)});
    ball.spent = "its mass is out of tolerance";
  }
  if (ball.impacts > limits.impacts) {
    reasons.push_back(
        {"ball_impacts", fmt::format("impact {} of this ball; the limit is {}", ball.impacts, limits.impacts)});
  }
  if (shot.ear > 0 && ball.ears.at(static_cast<std::size_t>(shot.ear)) > limits.ear_impacts) {
    reasons.push_back(
        {"ear_impacts", fmt::format("impact {} on ear {} of this ball; the limit is {}",
                                    ball.ears.at(static_cast<std::size_t>(shot.ear)), shot.ear, limits.ear_impacts)});
  }
  if (ball.impacts >= limits.impacts) ball.spent = fmt::format("it had {} impacts", limits.impacts);
}

void check_climate(const Session& session, const SessionShot& shot, const ProtocolLimits& limits,
                   std::vector<ProtocolFinding>& reasons) {
  const double temperature_F = shot.temperature_F.value_or(session.temperature_F);
  const double humidity = shot.humidity_percent.value_or(session.humidity_percent);
  if (!within(temperature_F, limits.temperature_F, limits.temperature_tolerance_F)) {
    reasons.push_back({"temperature", fmt::format("{:g} °F, not {:g} ± {:g} °F", temperature_F, limits.temperature_F,
                                                  limits.temperature_tolerance_F)});
  }
  if (!within(humidity, limits.humidity_percent, limits.humidity_tolerance_percent)) {
    reasons.push_back({"humidity", fmt::format("{:g} % humidity, not {:g} ± {:g} %", humidity, limits.humidity_percent,
                                               limits.humidity_tolerance_percent)});
  }
}

void check_conditioning(const Session& session, const ProtocolLimits& limits, std::vector<ProtocolFinding>& reasons) {
  if (session.bat.days_in_lab < limits.bat_days) {
    reasons.push_back({"bat_conditioning", fmt::format("the bat was {:g} days in the laboratory, not the required {:g}",
                                                       session.bat.days_in_lab, limits.bat_days)});
  }
  if (session.lot.days_in_lab < limits.ball_days) {
    reasons.push_back(
        {"ball_conditioning", fmt::format("the balls were {:g} days in the laboratory, not the required {:g}",
                                          session.lot.days_in_lab, limits.ball_days)});
  }
}

double value_of(const Session& session, const SessionShot& shot, double target_mph) {
  const double besr = besr_of(shot.out_mph, shot.in_mph);  // (P6)
  if (session.metric == PerformanceMetric::ncaa_besr)
    return ncaa_besr_of(shot.out_mph, shot.in_mph, target_mph, kNominalSpeed_mph);  // (P7)
  return besr;  // certify() converts the corrected value to BBCOR
}

}  // namespace

std::vector<ProtocolFinding> condition_findings(const Session& session, const ProtocolLimits& limits) {
  std::vector<ProtocolFinding> out;
  check_bat_readings(session.bat, out);
  check_conditioning(session, limits, out);
  check_climate(session, {}, limits, out);
  return out;
}

JudgedShot judge_shot(const Session& session, const SessionShot& shot, double target_mph, BallUse& ball,
                      const ProtocolLimits& limits) {
  JudgedShot out{.in_mph = shot.in_mph, .out_mph = shot.out_mph, .target_mph = target_mph};
  out.value = value_of(session, shot, target_mph);
  check_conditioning(session, limits, out.reasons);
  check_climate(session, shot, limits, out.reasons);
  check_ball(shot, ball, limits, out.reasons);
  if (!within(shot.in_mph, target_mph, limits.inbound_tolerance_mph)) {
    // The number is right in another unit.
    const double if_mps_mph = shot.in_mph / kMilePerHour_mps;
    const bool in_mps = within(if_mps_mph, target_mph, limits.inbound_tolerance_mph);
    out.reasons.push_back(
        {"inbound_speed",
         fmt::format(
             "{:.2f} mph inbound, not {:.2f} ± {:g} mph{}", shot.in_mph, target_mph, limits.inbound_tolerance_mph,
             in_mps ? fmt::format(": {:.2f} m/s are {:.2f} mph; is the speed in m/s?", shot.in_mph, if_mps_mph) : "")});
  }
  if (!within(shot.angle_deg, 0, limits.angle_deg)) {
    out.reasons.push_back({"rebound_angle", fmt::format("rebound at {:g}°, more than {:g}° off the horizontal",
                                                        shot.angle_deg, limits.angle_deg)});
  }
  check_pairs(shot.pairs_in_mph, "gate_pairs_in", "inbound", limits.pair_tolerance_mph, out.reasons);
  check_pairs(shot.pairs_out_mph, "gate_pairs_out", "rebound", limits.pair_tolerance_mph, out.reasons);
  return out;
}

}  // namespace percuss::metrics
