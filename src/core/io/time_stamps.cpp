#include "core/io/time_stamps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percuss {
inline namespace core {
namespace {

std::string uneven_text(double gap_s, double step_s) {
  if (gap_s <= 0) return fmt::format("the time does not rise: it changes by {:.6g} s", gap_s);
  return fmt::format("uneven time: a step of {:.6g} s where {:.6g} s is usual", gap_s, step_s);
}

double mean_step_s(std::span<const double> t) { return (t.back() - t.front()) / static_cast<double>(t.size() - 1); }

struct Deviation {
  double stamp_s = 0;  // largest distance of a stamp from even spacing between first and last
  double step_s = 0;   // largest difference of a step from the mean step
};

Deviation largest_deviation(std::span<const double> t) {
  const double mean_s = mean_step_s(t);
  Deviation largest;
  for (std::size_t i = 1; i < t.size(); ++i) {
    largest.stamp_s = std::max(largest.stamp_s, std::abs(t[i] - (t.front() + static_cast<double>(i) * mean_s)));
    largest.step_s = std::max(largest.step_s, std::abs(t[i] - t[i - 1] - mean_s));
  }
  return largest;
}

// Stamps that deviate from even spacing by far less than their resolution were not rounded: the step is a whole number
// of units of the last digit, as in 0.001, 0.002.
bool is_exact(const TimeStamps& row, const Deviation& deviation) {
  return deviation.stamp_s <= 0.01 * row.resolution_s;
}

// The range (largest minus smallest) of the stamps' distances from times that are step_s apart.
double range_around_s(std::span<const double> t, double step_s) {
  double least_s = 0, most_s = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double residual_s = t[i] - t.front() - static_cast<double>(i) * step_s;
    least_s = std::min(least_s, residual_s);
    most_s = std::max(most_s, residual_s);
  }
  return most_s - least_s;
}

constexpr double kArithmetic = 1e-6;  // rounding errors of the arithmetic, in units of the last digit

// Whether evenly spaced times explain every stamp within half a unit of its last digit. The range of the residuals is a
// convex function of the step.
bool has_even_times(const TimeStamps& row) {
  constexpr int kSections = 60;  // each leaves two thirds of the interval
  const auto t = row.time_s;
  const auto range_s = [&](double step_s) { return range_around_s(t, step_s); };
  const double reach_s = row.resolution_s / static_cast<double>(t.size() - 1);
  double low_s = mean_step_s(t) - reach_s, high_s = mean_step_s(t) + reach_s;
  for (int i = 0; i < kSections; ++i) {
    const double third_s = (high_s - low_s) / 3;
    const bool lower = range_s(low_s + third_s) < range_s(high_s - third_s);
    (lower ? high_s : low_s) += lower ? -third_s : third_s;
  }
  return range_s((low_s + high_s) / 2) <= (1 + kArithmetic) * row.resolution_s;
}

// Whether the stamps repeat, and never fall, as they do if the rate is slightly above one sample per unit. A few
// repeated stamps may be repeated lines.
bool repeats_regularly(const TimeStamps& row) {
  constexpr std::size_t kMinRepeated = 5;
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < row.time_s.size(); ++i) {
    const double step_s = row.time_s[i] - row.time_s[i - 1];
    if (step_s < -0.5 * row.resolution_s) return false;
    if (step_s < 0.5 * row.resolution_s) ++repeated;
  }
  return repeated >= kMinRepeated && has_even_times(row);
}

// Whether rounding explains the uneven steps.
bool is_even(const TimeStamps& row, const Deviation& deviation) {
  constexpr double kSinglePrecision = 0x1p-23;
  const auto t = row.time_s;
  const double step_s = mean_step_s(t);
  if (!(step_s > 0)) return false;
  if (is_exact(row, deviation)) return true;
  // Steps of one unit with a few steps of two units are probably lost samples, not a rate slightly below one sample per
  // unit.
  if (std::abs(step_s / row.resolution_s - 1) < 0.25) return step_s < row.resolution_s && repeats_regularly(row);
  // Stamps may carry the rounding of single precision, but never as much as a lost sample.
  const double largest_s = std::max(std::abs(t.front()), std::abs(t.back()));
  const double tolerance_s = 1.001 * row.resolution_s + std::min(kSinglePrecision * largest_s, 0.4 * step_s);
  return deviation.stamp_s <= tolerance_s && deviation.step_s <= tolerance_s;
}

std::vector<double> steps_of(std::span<const double> time_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time_s.size(); ++i) steps.push_back(time_s[i] - time_s[i - 1]);
  return steps;
}

// The median; of an even number of values the upper of the two in the middle, so that it is one of the values.
double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The usual step: the mean of the steps near the median, which differ only by rounding. 0 if there are none.
double usual_step_s(const std::vector<double>& steps) {
  constexpr double kUsual = 0.5;  // largest difference from the median, relative to it
  const double middle_s = upper_median(steps);
  double sum_s = 0, count = 0;
  for (const double step_s : steps) {
    if (std::abs(step_s - middle_s) > kUsual * middle_s) continue;
    sum_s += step_s;
    ++count;
  }
  return count > 0 ? sum_s / count : 0;
}

// The gaps in steps of two `step_s` or more. Empty if a step is shorter than half of `step_s`, or if too many stamps
// are missing.
std::vector<StampGap> long_steps(const std::vector<double>& steps, double step_s) {
  constexpr std::size_t kStepsPerMissing = 10;  // at most one stamp of so many may be missing
  std::vector<StampGap> gaps;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double count = std::round(steps[i] / step_s);
    if (!(count >= 1) || count > static_cast<double>(steps.size())) return {};
    if (count < 2) continue;
    gaps.push_back({.at = i + 1, .count = static_cast<std::size_t>(count) - 1});
    missing += gaps.back().count;
  }
  return missing * kStepsPerMissing > steps.size() ? std::vector<StampGap>() : gaps;
}

// The index of the stamp after the step that differs most from the median step, for messages.
std::size_t oddest_step(const TimeStamps& row, double& step_s) {
  const std::vector<double> steps = steps_of(row.time_s);
  step_s = upper_median(steps);
  const auto odd = std::max_element(steps.begin(), steps.end(),
                                    [&](double a, double b) { return std::abs(a - step_s) < std::abs(b - step_s); });
  return static_cast<std::size_t>(odd - steps.begin()) + 1;
}

// Whether two even rows have one rate within their rounding and the drift of a clock.
bool has_same_rate(const TimeStamps& a, const TimeStamps& b) {
  constexpr double kSameRate = 1e-3;  // relative
  const double a_s = mean_step_s(a.time_s), b_s = mean_step_s(b.time_s);
  const auto rounding_s = [](const TimeStamps& row) {
    return row.resolution_s / static_cast<double>(row.time_s.size() - 1);
  };
  return std::abs(a_s - b_s) <= rounding_s(a) + rounding_s(b) + kSameRate * std::max(a_s, b_s);
}

}  // namespace

std::optional<StampedRate> rate_of_time_stamps(std::span<const TimeStamps> rows, StampProblem& problem) {
  constexpr double kCoarsest = 5e-4;  // relative; an error of the rate shifts every frequency by the same ratio
  double steps = 0, length_s = 0;
  double length_error_s = 0;  // largest, from the rounding of the stamps
  const TimeStamps* first = nullptr;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].time_s.size() < 2) continue;
    const Deviation deviation = largest_deviation(rows[r].time_s);
    if (!is_even(rows[r], deviation)) {
      double usual_s = 0;
      const std::size_t at = oddest_step(rows[r], usual_s);
      constexpr double kJump = 1.5;  // usual steps
      const double step_s = rows[r].time_s[at] - rows[r].time_s[at - 1];
      problem = {uneven_text(step_s, usual_s), r, at,
                 step_s >= kJump * usual_s ? StampProblemKind::jump : StampProblemKind::uneven};
      return std::nullopt;
    }
    if (first == nullptr) first = &rows[r];
    if (!has_same_rate(*first, rows[r])) {
      problem = {fmt::format("another sampling rate: a time step of {:.6g} s where the hits before have {:.6g} s",
                             mean_step_s(rows[r].time_s), mean_step_s(first->time_s)),
                 r, 0, StampProblemKind::rates_differ};
      return std::nullopt;
    }
    steps += static_cast<double>(rows[r].time_s.size() - 1);
    length_s += rows[r].time_s.back() - rows[r].time_s.front();
    length_error_s += is_exact(rows[r], deviation) ? 0 : rows[r].resolution_s;
  }
  if (steps == 0) {
    problem.text = "fewer than two time stamps";
    return std::nullopt;
  }
  if (!(length_error_s <= kCoarsest * length_s)) {
    problem.text = fmt::format("time stamps with a resolution of {:.2g} s are too coarse to give the sampling rate",
                               length_error_s / static_cast<double>(rows.size()));
    return std::nullopt;
  }
  StampedRate rate{.fs_Hz = steps / length_s,
                   .lowest_Hz = steps / (length_s + length_error_s),
                   .highest_Hz = steps / (length_s - length_error_s)};
  if (!(rate.fs_Hz > 0 && std::isfinite(rate.highest_Hz))) {
    problem.text = "time stamps that are not finite, or too close to each other";
    return std::nullopt;
  }
  // Sums of doubles have rounding errors even if the digits are exact.
  rate.lowest_Hz *= 1 - 1e-12;
  rate.highest_Hz *= 1 + 1e-12;
  const double round_Hz = roundest_between(rate.lowest_Hz, rate.highest_Hz);
  constexpr double kNotedDifference = 1e-6;  // relative; clocks of recorders are not more accurate
  if (std::abs(round_Hz / rate.fs_Hz - 1) > kNotedDifference) {
    rate.note = fmt::format(
        "the time stamps are rounded: the sampling rate is taken as {:.10g} Hz, not {:.10g}; state the rate if it "
        "differs",
        round_Hz, rate.fs_Hz);
  }
  rate.fs_Hz = round_Hz;
  return rate;
}

std::vector<StampGap> gaps_of_stamps(const TimeStamps& row, std::optional<double> fs_Hz) {
  constexpr double kMinUnits = 4;  // the shortest step, in units of the last digit
  if (row.time_s.size() < 3) return {};
  const std::vector<double> steps = steps_of(row.time_s);
  const auto even_with = [&](const std::vector<StampGap>& gaps) {
    const std::vector<double> all = with_missing_stamps(row.time_s, gaps);
    const TimeStamps filled{.time_s = all, .resolution_s = row.resolution_s};
    return is_even(filled, largest_deviation(all));
  };
  if (fs_Hz) {
    const auto explains = [&](std::span<const double> t) {
      // Less than one unit: a lost sample can raise the range to one unit.
      return range_around_s(t, 1 / *fs_Hz) <= (1 - kArithmetic) * row.resolution_s;
    };
    if (explains(row.time_s)) return {};
    std::vector<StampGap> gaps = long_steps(steps, 1 / *fs_Hz);
    if (!gaps.empty() && explains(with_missing_stamps(row.time_s, gaps))) return gaps;
  }
  const double step_s = usual_step_s(steps);
  if (!(step_s >= kMinUnits * row.resolution_s)) return {};
  std::vector<StampGap> gaps = long_steps(steps, step_s);
  return gaps.empty() || !even_with(gaps) ? std::vector<StampGap>() : gaps;
}

std::vector<double> with_missing_stamps(std::span<const double> time_s, const std::vector<StampGap>& gaps) {
  std::vector<double> out;
  std::size_t from = 0;
  for (const StampGap& gap : gaps) {
    out.insert(out.end(), time_s.begin() + static_cast<std::ptrdiff_t>(from),
               time_s.begin() + static_cast<std::ptrdiff_t>(gap.at));
    const double before_s = time_s[gap.at - 1],
                 step_s = (time_s[gap.at] - before_s) / static_cast<double>(gap.count + 1);
    for (std::size_t i = 1; i <= gap.count; ++i) out.push_back(before_s + static_cast<double>(i) * step_s);
    from = gap.at;
  }
  out.insert(out.end(), time_s.begin() + static_cast<std::ptrdiff_t>(from), time_s.end());
  return out;
}

double roundest_between(double low, double high) {
  const int leading = static_cast<int>(std::floor(std::log10(high)));
  for (int digit = leading; digit > leading - 17; --digit) {
    // Only powers 10^k with k >= 0 are exact: for negative exponents the code divides by them.
    const double unit = std::pow(10.0, std::abs(digit));
    const double count = digit >= 0 ? std::floor(high / unit) : std::floor(high * unit);
    const double value = digit >= 0 ? count * unit : count / unit;
    if (value >= low && value <= high && value > 0) return value;
  }
  return low + (high - low) / 2;
}

}  // namespace core
}  // namespace percuss
