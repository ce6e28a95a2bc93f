#include "model/trampoline/exponent_family.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::model {
namespace {

constexpr int kPairs = 12;         // listed
constexpr double kScanStep = 0.1;  // of a, in the search for pairs within every standard deviation

// The lowest or highest listed a (direction −1 or 1). The search starts at an end of the fit's interval of a. A value
// beyond the interval is listed if some b keeps every CCOR within its standard deviation.
double family_end(const CcorMisfit& misfit, const ExponentFit& fit, double interval_end, double direction) {
  Exponents pair = fit.exponents();
  double end = interval_end;
  for (double a = interval_end + direction * kScanStep; a >= 0 && a <= kMaxStiffnessExponent;
       a += direction * kScanStep) {
    pair = misfit.best_with_a(a, pair);
    if (!misfit.range_within_std(pair, 1)) break;
    end = a;
  }
  return end;
}

}  // namespace

std::vector<FamilyPair> exponent_family(const Trampoline& model, const std::vector<MeasuredCor>& measured,
                                        const ExponentFit& fit, const std::vector<double>& hoop_Hz) {
  const CcorMisfit misfit(model, measured);
  std::vector<Exponents> pairs{fit.exponents()};
  if (fit.free() == 2) {
    pairs.clear();
    const double low = family_end(misfit, fit, fit.a_interval.low, -1);
    const double high = family_end(misfit, fit, fit.a_interval.high, 1);
    Exponents pair = fit.exponents();
    for (int i = 0; i < kPairs; ++i) {
      pair = misfit.best_with_a(low + (high - low) * i / (kPairs - 1), pair);
      pairs.push_back(pair);
    }
  }
  const int varied = fit.held.damping && !fit.held.stiffness ? 0 : 1;
  std::vector<FamilyPair> out;
  out.reserve(pairs.size());
  for (const Exponents& e : pairs) {
    const Trampoline there = with_exponents(model, e);
    out.push_back({.exponents = e,
                   .chi2 = misfit.chi2(e),
                   .within_std = misfit.range_within_std(e, varied),
                   .optimum = optimal_hoop_frequency(there, hoop_Hz, hoop_sweep(there, hoop_Hz))});
  }
  return out;
}

SweepRange sweep_range(const Trampoline& model, const ExponentFit& fit, const std::vector<double>& hoop_Hz,
                       const std::vector<Rebound>& best) {
  const HoopPeak peak = optimal_hoop_frequency(with_exponents(model, fit.exponents()), hoop_Hz, best);
  SweepRange out{
      .low = peak, .high = peak, .peak_cor_low = peak.cor, .peak_cor_high = peak.cor, .at_edge = peak.at_edge};
  out.cor_low.reserve(best.size());
  for (const Rebound& r : best) out.cor_low.push_back(r.cor);
  out.cor_high = out.cor_low;
  for (const Exponents& e : fit.contour) {
    const Trampoline there = with_exponents(model, e);
    const std::vector<Rebound> sweep = hoop_sweep(there, hoop_Hz);
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      out.cor_low[i] = std::min(out.cor_low[i], sweep[i].cor);
      out.cor_high[i] = std::max(out.cor_high[i], sweep[i].cor);
    }
    const HoopPeak optimum = optimal_hoop_frequency(there, hoop_Hz, sweep);
    if (optimum.hoop_Hz < out.low.hoop_Hz) out.low = optimum;
    if (optimum.hoop_Hz > out.high.hoop_Hz) out.high = optimum;
    out.peak_cor_low = std::min(out.peak_cor_low, optimum.cor);
    out.peak_cor_high = std::max(out.peak_cor_high, optimum.cor);
    out.at_edge = out.at_edge || optimum.at_edge;
  }
  return out;
}

double FittedExponents::slowest_mps() const {
  return std::min_element(measured.begin(), measured.end(),
                          [](const MeasuredCor& a, const MeasuredCor& b) { return a.speed_mps < b.speed_mps; })
      ->speed_mps;
}

double FittedExponents::fastest_mps() const {
  return std::max_element(measured.begin(), measured.end(),
                          [](const MeasuredCor& a, const MeasuredCor& b) { return a.speed_mps < b.speed_mps; })
      ->speed_mps;
}

}  // namespace percuss::model
