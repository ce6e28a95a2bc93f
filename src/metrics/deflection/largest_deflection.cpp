#include "metrics/deflection/largest_deflection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "metrics/deflection/decay_deflection.hpp"

namespace percuss::metrics {
namespace {

constexpr double kSignificantStds = 4;
constexpr double kClearlyMoved = 0.1;  // of the largest deflection
constexpr double kGrownOn = 1.1;       // over the largest deflection
constexpr double kWeak = 0.005;        // standard deviation over the largest deflection
constexpr double kCurvesDisagree = 5;  // standard deviations between the two curves
constexpr std::size_t kCompared = 64;  // places at which they are compared

// A deflection over time with its standard deviations.
struct Curve {
  const std::vector<double>* value_m;
  const std::vector<double>* std_m;  // may be empty
  double std(std::size_t i) const { return std_m->empty() ? 0 : (*std_m)[i]; }
};

// The sample with the largest excess of direction × deflection over four standard deviations. Late in a record that
// drifts, large values mean nothing: one random walk in six ends more than one standard deviation above zero.
// Direction 0: either sign. None: no deflection is significant.
std::optional<std::size_t> most_significant(const Curve& curve, double direction) {
  std::optional<std::size_t> best;
  double largest_excess_m = 0;
  for (std::size_t i = 0; i < curve.value_m->size(); ++i) {
    const double value_m = (*curve.value_m)[i];
    const double signed_m = direction == 0 ? std::abs(value_m) : direction * value_m;
    const double excess_m = signed_m - kSignificantStds * curve.std(i);
    if (excess_m > largest_excess_m) best = i;
    largest_excess_m = std::max(largest_excess_m, excess_m);
  }
  return best;
}

// Whether direction × deflection exceeds four standard deviations. Direction 0: either sign.
bool is_significant(const Curve& curve, std::size_t i, double direction) {
  const double value_m = (*curve.value_m)[i];
  const double signed_m = direction == 0 ? std::abs(value_m) : direction * value_m;
  return signed_m > kSignificantStds * curve.std(i);
}

// The sample of the largest significant value. Only for curves whose standard deviation does not grow with time; for
// other curves, see most_significant().
std::optional<std::size_t> largest(const Curve& curve, double direction) {
  std::optional<std::size_t> best;
  double most_m = 0;
  for (std::size_t i = 0; i < curve.value_m->size(); ++i) {
    const double value_m = (*curve.value_m)[i];
    const double signed_m = direction == 0 ? std::abs(value_m) : direction * value_m;
    if (signed_m > most_m && is_significant(curve, i, direction)) {
      best = i;
      most_m = signed_m;
    }
  }
  return best;
}

double first_direction(const Curve& curve, std::size_t peak) {
  const double clear = kClearlyMoved * std::abs((*curve.value_m)[peak]);
  const auto first =
      std::find_if(curve.value_m->begin(), curve.value_m->end(), [&](double w) { return std::abs(w) >= clear; });
  return std::copysign(1.0, *first);
}

// Whether the standard deviation decides which sample counts as the largest.
bool is_weak(const Deflection& d, std::size_t peak) {
  const double largest_m = std::abs(d.deflection_m[peak]);
  for (std::size_t i = 0; i < d.std_m.size(); ++i) {
    const bool could_be_larger = std::abs(d.deflection_m[i]) + kSignificantStds * d.std_m[i] > largest_m;
    if (could_be_larger && d.std_m[i] > kWeak * largest_m) return true;
  }
  return false;
}

// The drift-free deflection while the force acts, the free decays after it.
struct LowNoiseCurve {
  std::vector<double> value_m, std_m;
};

std::optional<LowNoiseCurve> low_noise_curve(const ImpactSignal& signal, const DeflectionOptions& options,
                                             const Deflection& d) {
  const auto onset = static_cast<std::size_t>(std::max(0.0, signal.onset_s * signal.fs_Hz));
  const auto decay = decay_deflection(signal.accel_mps2, signal.fs_Hz, onset, options.highpass_corner_Hz);
  if (!decay) return std::nullopt;
  LowNoiseCurve out{.value_m = d.deflection_m, .std_m = d.std_m};
  const std::size_t count = decay->deflection_m.size(), step = std::max<std::size_t>(1, count / kCompared);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = decay->first + i;
    const double apart = std::abs(decay->deflection_m[i] - d.deflection_m[at]);
    // The standard deviation of the decays is at most the integral's. A spurious decay of hardly any amplitude,
    // whose rate is not determined, gives the decays a large standard deviation although their values are correct.
    const double std_m = std::min(decay->std_m[i], d.std_m[at]);
    // A structure that does not swing about its position of rest contradicts the decays.
    if (i % step == 0 && apart > kCurvesDisagree * std::hypot(d.std_m[at], std_m)) return std::nullopt;
    out.value_m[at] = decay->deflection_m[i];
    out.std_m[at] = std_m;
  }
  return out;
}

// Whether clearly larger values follow the peak.
bool grows_on(const Deflection& d) {
  const double clear_m = kGrownOn * std::abs(d.peak_m) + kSignificantStds * d.peak_std_m;
  return std::any_of(d.deflection_m.begin() + static_cast<std::ptrdiff_t>(d.peak), d.deflection_m.end(),
                     [&](double w) { return std::abs(w) > clear_m; });
}

}  // namespace

void find_largest(const ImpactSignal& signal, const DeflectionOptions& options, Deflection& d) {
  d.peak_m = d.peak_std_m = d.forward_m = d.forward_std_m = std::numeric_limits<double>::quiet_NaN();
  const Curve own{.value_m = &d.deflection_m, .std_m = &d.std_m};
  auto peak = most_significant(own, 0);
  std::optional<LowNoiseCurve> low_noise;
  // Decays that begin in a sway do not begin at rest.
  const bool held =
      d.method == DeflectionMethod::drift_free && !options.free_body && !(signal.rigid_per_kg > 0) && !d.moved_before;
  if (held && (!peak || is_weak(d, *peak))) low_noise = low_noise_curve(signal, options, d);
  if (low_noise) {
    const auto surer = largest({.value_m = &low_noise->value_m, .std_m = &low_noise->std_m}, 0);
    if (surer) peak = surer;
    if (!surer) low_noise.reset();
  }
  if (!peak) return;
  // The decays know the time better than the integral knows the value there. An earlier value that is significant is
  // not the largest.
  if (low_noise && !is_significant(own, *peak, 0)) return;
  const Curve curve = low_noise ? Curve{.value_m = &low_noise->value_m, .std_m = &low_noise->std_m} : own;
  d.peak = *peak;
  d.peak_m = d.deflection_m[d.peak];
  d.peak_std_m = own.std(d.peak);
  d.larger_later = !low_noise && grows_on(d);
  const double direction = first_direction(curve, d.peak);
  const auto forward = low_noise ? largest(curve, direction) : most_significant(own, direction);
  if (!forward || (low_noise && !is_significant(own, *forward, direction))) return;
  d.forward_m = d.deflection_m[*forward];
  d.forward_std_m = own.std(*forward);
}

}  // namespace percuss::metrics
