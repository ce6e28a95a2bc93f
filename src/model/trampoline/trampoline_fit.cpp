#include "model/trampoline/trampoline_fit.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/roots.hpp"

namespace percuss::model {
namespace {

constexpr double kMaxExponentStd = 100;  // a larger one comes from rounding: the exponent is not determined
constexpr double kContourRise = 1;       // of chi2 above its minimum, for 68 %
constexpr int kContourSteps = 8;  // along the contour: its points miss an extreme by at most 2 % of half its width
constexpr const char* kMeasuredCcor = "the measured CCOR";

// The minimum of chi2, and the pairs around it.
class PairSearch {
 public:
  PairSearch(const CcorMisfit& misfit, const Exponents& start, HeldExponents held)
      : misfit_(misfit), free_{!held.stiffness, !held.damping}, best_(misfit.minimum(start, free_)) {
    if (both_free()) use_better_limit();
    chi2_min_ = misfit_.chi2(best_);
  }

  const Exponents& best() const { return best_; }

  /// The pairs at which chi2 is kContourRise above its minimum, or the limits of the search where it rises less.
  std::vector<Exponents> contour() {
    if (!free_[0] && !free_[1]) return {};
    const int along = free_[0] ? 0 : 1;
    const double top = along == 0 ? kMaxStiffnessExponent : 1 + best_[0] - kStartMargin;
    const double bottom = along == 0 ? std::max(0.0, both_free() ? 0.0 : best_[1] - 1 + kStartMargin) : 0;
    const double low = end_of_contour(along, bottom), high = end_of_contour(along, top);
    std::vector<Exponents> out;
    // Where a limit of the search cuts the contour off, the contour still has a width in b: the ends are included.
    for (int i = 0; i <= kContourSteps; ++i) {
      const double part = 0.5 - 0.5 * std::cos(std::numbers::pi * i / kContourSteps);
      if (!both_free() && i != 0 && i != kContourSteps) continue;
      const Exponents middle = valley_at(along, low + part * (high - low));
      if (!both_free()) {
        out.push_back(middle);
        continue;
      }
      const double rise = misfit_.chi2(middle) - chi2_min_;
      const double width = std::sqrt(std::max(kContourRise - rise, 0.0)) / misfit_.jacobian(middle).col(1).norm();
      for (const double side : {-width, width}) {
        const Exponents pair{middle[0], middle[1] + side};
        if (CcorMisfit::is_usable(pair)) out.push_back(pair);
      }
    }
    return out;
  }

  bool meets_limit() const { return meets_limit_; }

 private:
  bool both_free() const { return free_[0] && free_[1]; }

  // chi2 has a long valley. A search that meets a limit may stop in the valley too early. The best pairs at both limits
  // of a are therefore tried as well.
  void use_better_limit() {
    for (const double limit : {0.0, kMaxStiffnessExponent}) {
      const Exponents at_limit = valley_at(0, limit);
      if (misfit_.chi2(at_limit) < misfit_.chi2(best_)) best_ = at_limit;
    }
  }

  // The best pair with this value of exponent k, which is a where both are free.
  Exponents valley_at(int k, double value) const {
    if (both_free()) return misfit_.best_with_a(value, best_);
    Exponents at = best_;
    at[k] = value;
    return at;
  }

  double end_of_contour(int k, double limit) {
    const auto rise = [&](double value) { return misfit_.chi2(valley_at(k, value)) - chi2_min_ - kContourRise; };
    if (rise(limit) > 0) return bracketed_root(rise, std::min(best_[k], limit), std::max(best_[k], limit));
    meets_limit_ = true;
    return limit;
  }

  const CcorMisfit& misfit_;
  std::array<bool, 2> free_;
  Exponents best_;
  double chi2_min_ = 0;
  bool meets_limit_ = false;
};

ExponentInterval interval_of(const std::vector<Exponents>& contour, const Exponents& best, int k) {
  ExponentInterval out{.low = best[k], .high = best[k]};
  for (const Exponents& e : contour) {
    out.low = std::min(out.low, e[k]);
    out.high = std::max(out.high, e[k]);
  }
  return out;
}

void require_speeds(const std::vector<MeasuredCor>& measured, HeldExponents held) {
  std::set<double> speeds;
  for (const MeasuredCor& m : measured) speeds.insert(m.speed_mps);
  if (speeds.size() < 2 && !held.stiffness && !held.damping) {
    throw InputError("a and b need two different speeds", kMeasuredCcor, "measure at more speeds, or hold an exponent",
                     {"fit_ccor", "hold"});
  }
}

// Standard deviations and correlation from the Jacobian.
void add_deviations(const Eigen::MatrixXd& j, ExponentFit& fit) {
  if (!fit.held.damping) fit.damping_exponent_std_given_a = 1 / j.col(1).norm();
  if (fit.held.damping && fit.held.stiffness) return;
  if (fit.held.stiffness) {
    fit.damping_exponent_std = fit.damping_exponent_std_given_a;
  } else if (fit.held.damping) {
    fit.stiffness_exponent_std = 1 / j.col(0).norm();
  } else {
    const Eigen::MatrixXd covariance = inverse_gram(Eigen::MatrixXd(j.transpose() * j));
    fit.stiffness_exponent_std = std::sqrt(covariance(0, 0));
    fit.damping_exponent_std = std::sqrt(covariance(1, 1));
    fit.correlation = covariance(0, 1) / (fit.stiffness_exponent_std * fit.damping_exponent_std);
  }
  if (!(std::max(fit.stiffness_exponent_std, fit.damping_exponent_std) < kMaxExponentStd)) {
    throw InputError("the speeds are too similar to separate a from b", kMeasuredCcor,
                     "measure at more speeds, or hold an exponent", {"fit_ccor", "hold"});
  }
}

}  // namespace

ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured, HeldExponents held) {
  require_speeds(measured, held);
  const CcorMisfit misfit(model, measured);
  PairSearch search(misfit, {model.stiffness_exponent, model.damping_exponent}, held);
  const Exponents best = search.best();
  ExponentFit fit{.stiffness_exponent = best[0], .damping_exponent = best[1], .held = held};
  add_deviations(misfit.jacobian(best), fit);
  const Eigen::VectorXd residual = misfit.residual(best);
  fit.chi2 = residual.squaredNorm();
  const auto freedom = static_cast<double>(measured.size()) - static_cast<double>(fit.free());
  if (freedom > 0) fit.chi2_p = gsl_cdf_chisq_Q(fit.chi2, freedom);
  fit.beyond_std = static_cast<std::size_t>((residual.array().abs() > 1).count());
  fit.model_cor.reserve(measured.size());
  for (const MeasuredCor& m : measured) fit.model_cor.push_back(misfit.cor(best, m.speed_mps));
  fit.contour = search.contour();
  fit.a_interval = interval_of(fit.contour, best, 0);
  fit.b_interval = interval_of(fit.contour, best, 1);
  fit.at_limit = search.meets_limit();
  for (const ExponentInterval& i : {fit.a_interval, fit.b_interval})
    fit.determined = fit.determined && i.high - i.low < 2 * kMaxDeterminedHalfWidth;
  return fit;
}

}  // namespace percuss::model
