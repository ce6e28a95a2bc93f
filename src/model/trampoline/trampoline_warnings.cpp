#include "model/trampoline/trampoline_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace percuss::model {
namespace {

using warnings::Severity;
using warnings::with_remedy;

constexpr double kUnlikelyChi2 = 0.01;

constexpr auto kRanking = std::to_array<warnings::RankedCode>({
    {"exponents_not_determined", Severity::warn},
    {"poor_fit", Severity::warn},
    {"no_pair_within_std", Severity::warn},
    {"optimum_at_edge", Severity::warn},
    {"optimum_range_at_edge", Severity::warn},
    {"speed_extrapolated", Severity::warn},
});

}  // namespace

std::span<const warnings::RankedCode> ranked_trampoline_codes() { return kRanking; }

std::vector<warnings::Warning> trampoline_warnings(const Trampoline& model, const HoopPeak& peak,
                                                   const std::optional<FittedExponents>& fitted) {
  std::vector<warnings::Warning> out;
  if (peak.at_edge) {
    out.push_back(with_remedy(
        {"optimum_at_edge",
         fmt::format("the largest COR lies at an end of the hoop frequencies, {:g} Hz: it is no optimum", peak.hoop_Hz),
         {"hoop"}},
        "sweep further"));
  }
  if (!fitted) return warnings::ranked(std::move(out), kRanking);
  const ExponentFit& fit = fitted->fit;
  if (!fit.determined || fit.at_limit) {
    out.push_back(with_remedy(
        {"exponents_not_determined",
         fmt::format("the measured CCOR do not determine {}: a from {:.3g} to {:.3g}, b from {:.3g} to {:.3g} fit them "
                     "about as well (chi2 within 1 of the best){}",
                     fit.free() == 2 ? "a and b" : "the exponent", fit.a_interval.low, fit.a_interval.high,
                     fit.b_interval.low, fit.b_interval.high,
                     fit.at_limit ? ", up to a limit of the search (a from 0 to 3, b from 0 to 1 + a)" : ""),
         {"hold"}},
        fit.free() == 2 ? "hold the exponent that is known" : "measure at more speeds"));
  }
  if (fitted->range.at_edge && !peak.at_edge) {
    out.push_back(
        with_remedy({"optimum_range_at_edge",
                     "for some of the exponents that fit the measured CCOR, the largest COR lies at an end of "
                     "the hoop frequencies",
                     {"hoop"}},
                    "sweep further"));
  }
  const bool none_within = std::none_of(fitted->family.begin(), fitted->family.end(),
                                        [](const FamilyPair& pair) { return pair.within_std.has_value(); });
  if (none_within && fit.free() > 0) {
    out.push_back(with_remedy({"no_pair_within_std", "no exponents keep every CCOR within its standard deviation"},
                              "take the pair of the least chi2, or check the points"));
  }
  if (fit.chi2_p < kUnlikelyChi2) {
    out.push_back(with_remedy(
        {"poor_fit",
         fmt::format("the model misses the measured CCOR by more than their standard deviations: chi2 {:.1f}, "
                     "probability {:.1g}",
                     fit.chi2, fit.chi2_p),
         {"fit_ccor"}},
        "check the points and their standard deviations"));
  }
  const double slowest_mps = fitted->slowest_mps(), fastest_mps = fitted->fastest_mps();
  if (model.ball_speed_mps > fastest_mps || model.ball_speed_mps < slowest_mps) {
    out.push_back(
        with_remedy({"speed_extrapolated",
                     fmt::format("the ball's speed of {:g} m/s lies outside the measured speeds, {:g} to {:g} m/s",
                                 model.ball_speed_mps, slowest_mps, fastest_mps),
                     {"speed"}},
                    "measure the CCOR at this speed, too"));
  }
  return warnings::ranked(std::move(out), kRanking);
}

}  // namespace percuss::model
