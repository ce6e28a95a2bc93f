#include "identify/hits/hit_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

constexpr double kTrendTest = 2.576;   // normal deviate of the slope's t statistic: 1 %, two-sided
constexpr double kMinExplained = 0.7;  // of the scatter's χ²
constexpr std::size_t kMinHitsOfLaw = 3;
constexpr double kMinForceRange = 1.2;  // largest force over the smallest: equal hits tell nothing of the amplitude
constexpr double kMinVariation = 1e-9;  // relative variance of x: below it, x counts as constant
constexpr int kBisections = 40;

// The x of a regression line over the hits: a function of the hit's force, or its order.
using Law = std::function<double(std::size_t hit)>;

struct RegressionLine {
  double slope = 0, slope_std = 0, at_zero = 0;
  double chi2_before = 0, chi2_after = 0;  // around the mean and around the line
  double scatter2 = 0;                     // variance around the line beyond the noise
  double log_variances = 0;                // Σ ln of the hits' variances
  double degrees = 0;
  double spread = 0;  // standard deviation of the line's values over the hits
  double explained() const { return 1 - chi2_after / chi2_before; }
  bool follows() const {
    return degrees > 0 && explained() > kMinExplained &&
           std::abs(slope) > student_quantile(kTrendTest, degrees) * slope_std;
  }
};

double sample_std(const std::vector<double>& x) {
  double sum = 0, squares = 0;
  for (const double one : x) sum += one;
  const double mean = sum / static_cast<double>(x.size());
  for (const double one : x) squares += (one - mean) * (one - mean);
  return std::sqrt(squares / static_cast<double>(x.size() - 1));
}

// Weighted least squares, where values scatter around the line by `scatter2` beyond their own noise.
RegressionLine line_at(const HitSeries& series, const std::vector<double>& x, double scatter2) {
  RegressionLine line{.scatter2 = scatter2, .degrees = static_cast<double>(x.size()) - 2};
  double w_sum = 0, x_mean = 0, y_mean = 0;
  std::vector<double> w;
  for (std::size_t i = 0; i < x.size(); ++i) {
    w.push_back(1 / (series.std[i] * series.std[i] + scatter2));
    w_sum += w[i];
    x_mean += w[i] * x[i];
    y_mean += w[i] * (series.value[i] - series.value.front());
    line.log_variances -= std::log(w[i]);
  }
  x_mean /= w_sum;
  y_mean = series.value.front() + y_mean / w_sum;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - x_mean, dy = series.value[i] - y_mean;
    xx += w[i] * dx * dx;
    xy += w[i] * dx * dy;
    line.chi2_before += w[i] * dy * dy;
  }
  line.chi2_after = line.chi2_before;
  if (!(xx > kMinVariation * w_sum * x_mean * x_mean) || line.degrees <= 0) return line;
  line.slope = xy / xx;
  line.slope_std = 1 / std::sqrt(xx);
  line.chi2_after = std::max(0.0, line.chi2_before - xy * xy / xx);
  line.at_zero = y_mean - line.slope * x_mean;
  line.spread = std::abs(line.slope) * sample_std(x);
  return line;
}

// Adds scatter around the line until χ² equals its degrees of freedom (random effects). Without this scatter, a few
// precise hits alone would decide about a law that is not quite a line.
RegressionLine fit_line(const HitSeries& series, const Law& law) {
  std::vector<double> x;
  for (const std::size_t hit : series.hits) x.push_back(law(hit));
  RegressionLine line = line_at(series, x, 0);
  double low = 0, high = 0;
  for (const double value : series.value) high = std::max(high, std::pow(value - series.value.front(), 2));
  if (!(line.chi2_after > line.degrees)) return line;
  for (int step = 0; step < kBisections; ++step) {
    const double middle = step == 0 ? high : 0.5 * (low + high);
    line = line_at(series, x, middle);
    (line.chi2_after > line.degrees ? low : high) = middle;
  }
  return line;
}

// Logarithm of the likelihood of all series under a law; nothing where no series follows it.
std::optional<double> support(const std::vector<HitSeries>& series, const Law& law) {
  double sum = 0;
  bool any = false;
  for (const HitSeries& one : series) {
    if (one.hits.size() < kMinHitsOfLaw) continue;
    const RegressionLine line = fit_line(one, law);
    sum -= 0.5 * (line.log_variances + line.chi2_after);
    any = any || line.follows();
  }
  if (!any) return std::nullopt;
  return sum;
}

void widen_to_spread(double spread, StdParts& parts, double& std) {
  parts.hits = std::max(parts.hits, spread);
  std = parts.total();
}

void describe_drift(const HitSeries& series, const Law& order, Mode& mode) {
  const RegressionLine line = fit_line(series, order);
  if (!series.is_freq || !line.follows()) return;
  widen_to_spread(line.spread, mode.freq_std_parts_Hz, mode.freq_std_Hz);
  mode.drift =
      DriftTrend{.freq_change_per_hit = line.slope / mode.pole.freq_Hz, .std = line.slope_std / mode.pole.freq_Hz};
}

void describe_amplitude(const HitSeries& series, const Law& law, const Law& force, Mode& mode) {
  if (!fit_line(series, law).follows()) return;
  const RegressionLine line = fit_line(series, force);
  if (series.is_freq) widen_to_spread(line.spread, mode.freq_std_parts_Hz, mode.freq_std_Hz);
  if (!series.is_freq) widen_to_spread(line.spread, mode.damping_std_parts, mode.damping_std);
  if (!mode.amplitude)
    mode.amplitude = AmplitudeTrend{.freq_at_zero_Hz = mode.pole.freq_Hz, .damping_at_zero = mode.pole.damping_ratio};
  AmplitudeTrend& trend = *mode.amplitude;
  (series.is_freq ? trend.freq_slope_Hz_per_N : trend.damping_slope_per_N) = line.slope;
  (series.is_freq ? trend.freq_slope_std : trend.damping_slope_std) = line.slope_std;
  (series.is_freq ? trend.freq_at_zero_Hz : trend.damping_at_zero) = line.at_zero;
  (series.is_freq ? trend.freq_follows : trend.damping_follows) = true;
}

}  // namespace

double trend_deviate(const HitSeries& series, const std::vector<double>& peak_N) {
  if (series.hits.size() < kMinHitsOfLaw) return 0;
  const auto deviate = [&](const Law& law) {
    std::vector<double> x;
    for (const std::size_t hit : series.hits) x.push_back(law(hit));
    const RegressionLine line = line_at(series, x, 0);
    return line.slope_std > 0 ? std::abs(line.slope) / line.slope_std : 0;
  };
  return std::max(deviate([](std::size_t hit) { return static_cast<double>(hit); }),
                  deviate([&](std::size_t hit) { return std::abs(peak_N[hit]); }));
}

bool follows_a_law(const HitSeries& series, const std::vector<double>& peak_N) {
  if (series.hits.size() < kMinHitsOfLaw) return false;
  const auto follows = [&](const Law& law) { return fit_line(series, law).follows(); };
  return follows([](std::size_t hit) { return static_cast<double>(hit); }) ||
         follows([&](std::size_t hit) { return std::abs(peak_N[hit]); }) ||
         follows([&](std::size_t hit) { return peak_N[hit] * peak_N[hit]; }) ||
         follows([&](std::size_t hit) { return std::log(std::abs(peak_N[hit])); });
}

void explain_scatter(const std::vector<HitSeries>& series, const std::vector<double>& peak_N,
                     std::vector<Mode>& modes) {
  if (series.empty() || peak_N.size() < kMinHitsOfLaw) return;
  const Law order = [](std::size_t hit) { return static_cast<double>(hit); };
  const Law force = [&](std::size_t hit) { return std::abs(peak_N[hit]); };
  const Law square = [&](std::size_t hit) { return peak_N[hit] * peak_N[hit]; };
  const Law logarithm = [&](std::size_t hit) { return std::log(std::abs(peak_N[hit])); };
  const Law* best = &force;
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto [least, most] = std::minmax_element(peak_N.begin(), peak_N.end(), by_size);
  std::optional<double> of_force;
  if (std::abs(*most) > kMinForceRange * std::abs(*least)) {
    for (const Law* law : std::array{&force, &square, &logarithm}) {
      const auto now = support(series, *law);
      if (!now || (of_force && *now <= *of_force)) continue;
      best = law;
      of_force = now;
    }
  }
  const auto of_order = support(series, order);
  if (!of_force && !of_order) return;
  const bool drifts = of_order && (!of_force || *of_order > *of_force);
  for (const HitSeries& one : series) {
    if (one.hits.size() < kMinHitsOfLaw) continue;
    if (drifts) describe_drift(one, order, modes[one.mode]);
    if (!drifts) describe_amplitude(one, *best, force, modes[one.mode]);
  }
}

}  // namespace percuss::identify
