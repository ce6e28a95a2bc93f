#include "metrics/protocol/plausibility.hpp"

#include <fmt/format.h>

namespace percuss::metrics {
namespace {

// Ranges that hold every bat in play, from tee-ball to fungo, baseballs and softballs, in the units of the options.
constexpr double kMinLength_in = 20, kMaxLength_in = 40;
constexpr double kMinWeight_oz = 8, kMaxWeight_oz = 60;
constexpr double kMinBalance = 0.25, kMaxBalance = 0.5;  // from the tip, of the length: the barrel is the heavy half
constexpr double kMinPeriod_s = 1, kMaxPeriod_s = 2;     // 2π √(effective length / g), lengths of 0.25 to 1 m
constexpr double kAdultLength_in = 28;
constexpr double kMinAdultMoi_ozin2 = 4000, kMinMoi_ozin2 = 800, kMaxMoi_ozin2 = 20000;
constexpr double kMinGyration = 0.25, kMaxGyration = 0.7;  // MOI over mass × (length − 6 in)²; 1: all mass at the tip
constexpr double kMinBall_g = 135, kMaxBall_g = 210;
constexpr double kMaxLocation = 0.5;  // from the tip, of the length
constexpr double kMaxLocation_in = 15;
constexpr double kMinInbound_mph = 20, kMaxInbound_mph = 200;
constexpr double kMaxRatio = 0.5;  // rebound over inbound speed
constexpr double kMinBesr = 0.45, kMaxBesr = 1;
constexpr double kMinBbcor = 0.25, kMaxBbcor = 0.8;
constexpr double kMinSwing_mph = 25, kMaxSwing_mph = 110;

struct Check {
  const char* what;
  const char* unit;
  std::optional<UncertainValue> value;  // in SI
  double unit_SI;
  double low, high;  // in the unit
  const char* why;
  const char* remedy;
  std::vector<OptionId> options;
};

void add_if_implausible(const Check& check, std::vector<Warning>& out) {
  if (!check.value) return;
  const double value = check.value->value() / check.unit_SI;
  if (value >= check.low && value <= check.high) return;
  const char* const blank = *check.unit == '\0' ? "" : " ";
  out.push_back(with_remedy(
      {"implausible_value",
       fmt::format("{} of {:.4g}{}{} is implausible: the usual range is {:.4g} to {:.4g}{}{}; {}", check.what, value,
                   blank, check.unit, check.low, check.high, blank, check.unit, check.why),
       check.options},
      check.remedy));
}

void check_bat(const BatReadings& r, std::vector<Warning>& out) {
  add_if_implausible({"a length",
                      "in",
                      r.length_m,
                      kInch_m,
                      kMinLength_in,
                      kMaxLength_in,
                      "bats are not that long or short",
                      "state it in inches",
                      {"length_in"}},
                     out);
  add_if_implausible({"a weight",
                      "oz",
                      r.mass_kg,
                      kOunce_kg,
                      kMinWeight_oz,
                      kMaxWeight_oz,
                      "bats are not that light or heavy",
                      "state it in ounces",
                      {"weight_oz"}},
                     out);
  if (r.cg_m && r.length_m) {
    const double length_in = r.length_m->value() / kInch_m;
    add_if_implausible({"a balance point",
                        "in from the tip",
                        r.cg_m,
                        kInch_m,
                        kMinBalance * length_in,
                        kMaxBalance * length_in,
                        "the barrel is the heavier half",
                        "measure it from the tip of the barrel, not from the knob",
                        {"cg_in"}},
                       out);
  }
  add_if_implausible({"a period",
                      "s",
                      r.period_s,
                      1,
                      kMinPeriod_s,
                      kMaxPeriod_s,
                      "a bat that swings about the pivot behaves as a pendulum of 0.25 to 1 m",
                      "state seconds for a whole swing to and fro",
                      {"period_s", "gate_times_s"}},
                     out);
}

void check_moi(const BatReadings& r, const BatMetrics& m, std::vector<Warning>& out) {
  const bool short_bat = r.length_m && r.length_m->value() < kAdultLength_in * kInch_m;
  double low = short_bat ? kMinMoi_ozin2 : kMinAdultMoi_ozin2, high = kMaxMoi_ozin2;
  const char* why = short_bat
                        ? "measured about the pivot, 6 in from the knob, bats shorter than 28 in have such moments"
                        : "measured about the pivot, 6 in from the knob, bats of 28 in and more have such moments";
  if (r.mass_kg && r.length_m) {
    const double reach_in = (r.length_m->value() - kPivot_m) / kInch_m;
    const double most = r.mass_kg->value() / kOunce_kg * reach_in * reach_in;
    low = kMinGyration * most;
    high = kMaxGyration * most;
    why = "a bat of this weight and length has between a quarter and 0.7 of its weight times (length − 6 in)²";
  }
  const std::vector<OptionId> options =
      r.moi_kgm2 ? std::vector<OptionId>{"moi_oz_in2"} : std::vector<OptionId>{"cg_in", "period_s", "weight_oz"};
  add_if_implausible({"a moment of inertia", "oz in²", m.moi_kgm2, kOunceInch2_kgm2, low, high, why,
                      r.moi_kgm2 ? "state it in oz in² about the pivot"
                                 : "check period, weight and balance point, which is measured from the tip",
                      options},
                     out);
}

void check_shot(const BatReadings& r, std::vector<Warning>& out) {
  add_if_implausible({"a ball",
                      "g",
                      r.ball_kg,
                      1e-3,
                      kMinBall_g,
                      kMaxBall_g,
                      "baseballs weigh 142 to 149 g, softballs up to 200 g",
                      "state it in grams",
                      {"ball_g"}},
                     out);
  const double far_in = r.length_m ? kMaxLocation * r.length_m->value() / kInch_m : kMaxLocation_in;
  add_if_implausible({"an impact",
                      "in from the tip",
                      r.z_m,
                      kInch_m,
                      0,
                      far_in,
                      "bats are struck on the barrel",
                      "measure it from the tip of the barrel, not from the knob",
                      {"z_in"}},
                     out);
  const double mph = kMilePerHour_mps;
  add_if_implausible({"an inbound speed",
                      "mph",
                      r.in_mps,
                      mph,
                      kMinInbound_mph,
                      kMaxInbound_mph,
                      "cannons and pitchers throw no slower and no faster",
                      "state it in mph",
                      {"v_in_mph"}},
                     out);
  if (r.out_mps && r.in_mps && r.out_mps->value() <= r.in_mps->value()) {  // a faster one: warning rebound_speed
    add_if_implausible({"a rebound speed",
                        "mph",
                        r.out_mps,
                        mph,
                        0,
                        kMaxRatio * r.in_mps->value() / mph,
                        "the ball leaves a bat at rest backwards, with at most half of its speed",
                        "state both speeds in mph, the rebound positive away from the bat",
                        {"v_out_mph", "v_in_mph"}},
                       out);
  }
  add_if_implausible({"a swing speed",
                      "mph",
                      r.swing_mps,
                      mph,
                      kMinSwing_mph,
                      kMaxSwing_mph,
                      "players do not swing slower or faster",
                      "state it in mph",
                      {"v_swing_mph"}},
                     out);
}

void check_performance(const BatReadings& r, const BatMetrics& m, std::vector<Warning>& out) {
  const char* const readings = "check the readings that it follows from";
  const std::vector<OptionId> speeds{"v_in_mph", "v_out_mph", "ball_g", "z_in"};
  if (m.besr && !r.bbcor) {
    add_if_implausible(
        {"a BESR", "", m.besr, 1, kMinBesr, kMaxBesr, "it is one half plus the ratio of rebound to inbound speed",
         r.besr ? "state it as a ratio" : readings, r.besr ? std::vector<OptionId>{"besr"} : speeds},
        out);
  }
  add_if_implausible({"a BBCOR", "", m.bbcor, 1, kMinBbcor, kMaxBbcor,
                      "rules limit it to 0.5, and above 1 the impact would create energy",
                      r.bbcor ? "state it as a ratio" : readings, r.bbcor ? std::vector<OptionId>{"bbcor"} : speeds},
                     out);
}

}  // namespace

std::vector<Warning> implausible_values(const BatReadings& readings, const BatMetrics& metrics) {
  std::vector<Warning> out;
  check_bat(readings, out);
  check_moi(readings, metrics, out);
  check_shot(readings, out);
  check_performance(readings, metrics, out);
  return out;
}

}  // namespace percuss::metrics
