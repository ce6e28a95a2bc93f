#pragma once
#include <array>
#include <optional>
#include <vector>

#include "model/trampoline/trampoline_fit.hpp"

namespace percuss::model {

/// The best pair of exponents for one value of a, and the result for it.
struct FamilyPair {
  Exponents exponents{0, 0};
  double chi2 = 0;
  /// The values of the varied exponent (b; a where b is held) that keep every CCOR within its standard deviation: the
  /// criterion of [8]. None: no such pair.
  std::optional<std::array<double, 2>> within_std;
  HoopPeak optimum;
};

/// Pairs of exponents that the measurements allow, by rising a, at equal steps of a, each with its best b. The range of
/// a holds the pairs whose chi2 is at most 1 above its minimum, and the pairs that keep every CCOR within its standard
/// deviation. Where one exponent is held, the family is the best pair.
std::vector<FamilyPair> exponent_family(const Trampoline& model, const std::vector<MeasuredCor>& measured,
                                        const ExponentFit& fit, const std::vector<double>& hoop_Hz);

/// The range of the sweep and of its optimum over the pairs of ExponentFit::contour: 68 % intervals.
struct SweepRange {
  std::vector<double> cor_low, cor_high;  // at each of hoop_Hz
  HoopPeak low, high;                     // the optima at the lowest and at the highest frequency
  double peak_cor_low = 0, peak_cor_high = 0;
  bool at_edge = false;  // for one of the pairs, the COR is largest at an end of hoop_Hz
};

/// best  [hoop_Hz] the sweep at the fit's exponents
SweepRange sweep_range(const Trampoline& model, const ExponentFit& fit, const std::vector<double>& hoop_Hz,
                       const std::vector<Rebound>& best);

/// The fit of the exponents that a sweep uses, and the measurements that it used.
struct FittedExponents {
  std::vector<MeasuredCor> measured;
  ExponentFit fit;
  std::vector<FamilyPair> family{};  // exponent_family
  SweepRange range{};                // sweep_range

  double slowest_mps() const;  // of the measurements
  double fastest_mps() const;
};

}  // namespace percuss::model
