#include "model/trampoline/trampoline_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace percuss::model {
namespace {

constexpr double kUnlikelyChi2 = 0.01;

constexpr auto kRanking = std::to_array<RankedTrampolineCode>({
    {"exponents_not_determined", TrampolineSeverity::warn},
    {"poor_fit", TrampolineSeverity::warn},
    {"no_pair_within_std", TrampolineSeverity::warn},
    {"optimum_at_edge", TrampolineSeverity::warn},
    {"optimum_range_at_edge", TrampolineSeverity::warn},
    {"speed_extrapolated", TrampolineSeverity::warn},
});

std::size_t rank_of(const TrampolineWarning& warning) {
  const auto* const at = std::find_if(kRanking.begin(), kRanking.end(),
                                      [&](const RankedTrampolineCode& known) { return known.code == warning.code; });
  return static_cast<std::size_t>(at - kRanking.begin());
}

std::vector<TrampolineWarning> ranked(std::vector<TrampolineWarning> warnings) {
  std::stable_sort(warnings.begin(), warnings.end(),
                   [](const TrampolineWarning& a, const TrampolineWarning& b) { return rank_of(a) < rank_of(b); });
  for (TrampolineWarning& warning : warnings) warning.severity = kRanking.at(rank_of(warning)).severity;
  return warnings;
}

}  // namespace

const char* name_of(TrampolineSeverity severity) { return severity == TrampolineSeverity::warn ? "warn" : "info"; }

std::span<const RankedTrampolineCode> ranked_trampoline_codes() { return kRanking; }

std::vector<TrampolineWarning> trampoline_warnings(const Trampoline& model, const HoopPeak& peak,
                                                   const std::optional<FittedExponents>& fitted) {
  std::vector<TrampolineWarning> out;
  if (peak.at_edge) {
    out.push_back(
        {"optimum_at_edge",
         fmt::format("the largest COR lies at an end of the hoop frequencies, {:g} Hz: it is no optimum", peak.hoop_Hz),
         "sweep further",
         {"hoop"}});
  }
  if (!fitted) return ranked(std::move(out));
  const ExponentFit& fit = fitted->fit;
  if (!fit.determined || fit.at_limit) {
    out.push_back(
        {"exponents_not_determined",
         fmt::format("the measured CCOR do not determine {}: a from {:.3g} to {:.3g}, b from {:.3g} to {:.3g} fit them "
                     "about as well (chi2 within 1 of the best){}",
                     fit.free() == 2 ? "a and b" : "the exponent", fit.a_interval.low, fit.a_interval.high,
                     fit.b_interval.low, fit.b_interval.high,
                     fit.at_limit ? ", up to a limit of the search (a from 0 to 3, b from 0 to 1 + a)" : ""),
         fit.free() == 2 ? "hold the exponent that is known" : "measure at more speeds",
         {"hold"}});
  }
  if (fitted->range.at_edge && !peak.at_edge) {
    out.push_back({"optimum_range_at_edge",
                   "for some of these exponents, the largest COR lies at an end of the hoop frequencies",
                   "sweep further",
                   {"hoop"}});
  }
  const bool none_within = std::none_of(fitted->family.begin(), fitted->family.end(),
                                        [](const FamilyPair& pair) { return pair.within_std.has_value(); });
  if (none_within && fit.free() > 0) {
    out.push_back({"no_pair_within_std",
                   "no exponents keep every CCOR within its standard deviation",
                   "take the pair of the least chi2, or check the points",
                   {}});
  }
  if (fit.chi2_p < kUnlikelyChi2) {
    out.push_back(
        {"poor_fit",
         fmt::format("the model misses the measured CCOR by more than their standard deviations: chi2 {:.1f}, "
                     "probability {:.1g}",
                     fit.chi2, fit.chi2_p),
         "check the points and their standard deviations",
         {"fit_ccor"}});
  }
  const double slowest_mps = fitted->slowest_mps(), fastest_mps = fitted->fastest_mps();
  if (model.ball_speed_mps > fastest_mps || model.ball_speed_mps < slowest_mps) {
    out.push_back({"speed_extrapolated",
                   fmt::format("the ball's speed of {:g} m/s lies outside the measured speeds, {:g} to {:g} m/s",
                               model.ball_speed_mps, slowest_mps, fastest_mps),
                   "measure the CCOR at this speed, too",
                   {"speed"}});
  }
  return ranked(std::move(out));
}

}  // namespace percuss::model
