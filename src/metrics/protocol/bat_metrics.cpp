#include "metrics/protocol/bat_metrics.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "metrics/protocol/plausibility.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

constexpr double kMinBelow = 2.1, kMaxBelow = 3.0;  // class −3: length in inches minus weight in ounces
constexpr double kMinExponent = 0.08, kMaxExponent = 0.37;

constexpr auto kMetricsRanking = std::to_array<warnings::RankedCode>({
    {"rebound_speed", warnings::Severity::reject},
    {"implausible_value", warnings::Severity::reject},
    {"swing_exponent", warnings::Severity::warn},
    {"drop_class", warnings::Severity::info},
    {"swing_speed_constant", warnings::Severity::info},
});

// f(numbers), or nothing when a number is absent.
template <class F, class... T>
std::optional<UncertainValue> given(F&& f, const std::optional<T>&... numbers) {
  if (!(numbers.has_value() && ...)) return std::nullopt;
  return f(*numbers...);
}

std::optional<UncertainValue> besr_from(const BatReadings& r, const std::optional<UncertainValue>& k) {
  if (r.out_mps && r.in_mps) return besr_of(*r.out_mps, *r.in_mps) + r.lot_correction;  // (P6), (P11)
  if (r.besr) return r.besr;
  return given([](const auto& bbcor, const auto& ratio) { return besr_from_bbcor(bbcor, ratio); }, r.bbcor, k);  // (P9)
}

}  // namespace

std::optional<int> drop_class_of(double drop) {
  if (-drop >= kMinBelow - kReadingTolerance && -drop <= kMaxBelow + kReadingTolerance) return -3;
  return std::nullopt;
}

BatMetrics bat_metrics(const BatReadings& r) {
  if (r.besr && r.bbcor) {
    throw InputError("BESR and BBCOR are both given, but each follows from the other", "readings", "leave one out",
                     {"besr", "bbcor"});
  }
  BatMetrics out;
  out.drop = given([](const auto& m, const auto& l) { return drop_of(m, l); }, r.mass_kg, r.length_m);  // (P1)
  if (out.drop) out.drop_class = drop_class_of(out.drop->value());
  out.moi_kgm2 = r.moi_kgm2 ? r.moi_kgm2
                            : given([&](const auto& t, const auto& m, const auto& l,
                                        const auto& cg) { return pendulum_moi_kgm2(t, m, l, cg, r.gravity_mps2); },
                                    r.period_s, r.mass_kg, r.length_m, r.cg_m);  // (P3)
  out.k = given([](const auto& ball, const auto& l, const auto& z,
                   const auto& moi) { return ball_to_bat_inertia(ball, l, z, moi); },
                r.ball_kg, r.length_m, r.z_m, out.moi_kgm2);  // (P10)
  out.contact_mps =
      given([](const auto& l, const auto& z) { return contact_speed_mps(l, z); }, r.length_m, r.z_m);  // (P5)
  out.swing_mps =
      r.swing_mps
          ? r.swing_mps
          : given([&](const auto& l, const auto& z, const auto& moi) { return swing_speed_mps(l, z, moi, r.swing); },
                  r.length_m, r.z_m, out.moi_kgm2);  // (P4)
  out.besr = besr_from(r, out.k);
  out.ncaa_besr = given(
      [&](const auto& v_out, const auto& v_in, const auto& contact) -> UncertainValue {
        return ncaa_besr_of(v_out, v_in, contact, r.nominal_mps) + r.lot_correction;
      },
      r.out_mps, r.in_mps, out.contact_mps);  // (P7)
  out.bbs_mps =
      given([&](const auto& besr, const auto& swing) { return batted_ball_speed_mps(besr, swing, r.pitch_mps); },
            out.besr, out.swing_mps);                                                                     // (P8)
  out.bbcor = given([](const auto& besr, const auto& k) { return bbcor_of(besr, k); }, out.besr, out.k);  // (P9)
  if (!out.bbcor) out.bbcor = r.bbcor;
  return out;
}

std::span<const warnings::RankedCode> ranked_metrics_codes() { return kMetricsRanking; }

std::vector<Warning> metrics_warnings(const BatReadings& r, const BatMetrics& m) {
  std::vector<Warning> out = implausible_values(r, m);
  const SwingModel standard;
  if (m.swing_mps && !r.swing_mps && r.swing.v0_mps == standard.v0_mps) {
    out.push_back(with_remedy({"swing_speed_constant",
                               "the swing model uses v0 = 60 mph: the source prints 40 mph, which gives 44.6 mph 6 in "
                               "from the tip of a 34 in bat with a MOI of 10 450 oz in², not the 66 mph that it states",
                               {"v0_mph"}},
                              "state v0 or the swing speed if another one is meant"));
  }
  if (r.swing.exponent < kMinExponent || r.swing.exponent > kMaxExponent) {
    out.push_back(with_remedy({"swing_exponent",
                               fmt::format("the swing exponent is {:g}, but exponents of players range from {} to {}: "
                                           "the swing speed and the batted-ball speed may be off",
                                           r.swing.exponent, kMinExponent, kMaxExponent),
                               {"swing_exponent"}},
                              "state an exponent within this range"));
  }
  if (m.drop && !m.drop_class) {
    out.push_back(
        with_remedy({"drop_class",
                     fmt::format("a drop of {:.3f} is not in class -3 (2.1 to 3.0 oz below the length): the limits "
                                 "of this class do not apply to the bat",
                                 m.drop->value()),
                     {"length_in", "weight_oz"}},
                    "check length and weight if it is a bat of class -3"));
  }
  if (r.in_mps && r.out_mps && r.out_mps->value() > r.in_mps->value())
    out.push_back(with_remedy(
        {"rebound_speed",
         fmt::format("the rebound, {:.4g} mph, is faster than the inbound ball, {:.4g} mph: BESR, BBCOR and the "
                     "batted-ball speed are wrong",
                     r.out_mps->value() / kMilePerHour_mps, r.in_mps->value() / kMilePerHour_mps),
         {"v_in_mph", "v_out_mph"}},
        "exchange the two speeds, or correct them"));
  return warnings::ranked(std::move(out), kMetricsRanking);
}

}  // namespace percuss::metrics
