#include "acquire/record/frequency_lines.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/error.hpp"
#include "core/io/time_stamps.hpp"

namespace percuss::acquire {
namespace {

constexpr double kArithmetic = 1e-12;  // relative; rounding of sums and products of doubles
constexpr double kExact = 1e-10;       // relative; numbers so close to multiples of their spacing are not rounded
constexpr double kKnownSpacing = 1e-9;
constexpr double kMaxUnit = 0.5;  // of the last digit, in spacings: a larger one may hide a missing line

enum class Rounding { decimals, significant_digits, single_precision };

struct Digits {
  int significant = 0, exponent = 0;  // of the first one
};

// The digits of a number without the last rounding error of a double.
Digits digits_of(double value) {
  const std::string text = fmt::format("{:.14e}", value);
  const std::size_t mark = text.find('e');
  std::size_t end = mark;
  while (end > 1 && (text[end - 1] == '0' || text[end - 1] == '.')) --end;
  return {.significant = static_cast<int>(end > 1 ? end - 1 : 1), .exponent = std::stoi(text.substr(mark + 1))};
}

// The largest error of each number, [lines], where all are rounded in this way.
std::vector<double> largest_errors(std::span<const double> numbers, const std::vector<Digits>& digits, Rounding by) {
  int decimals = std::numeric_limits<int>::min(), significant = 1;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] == 0) continue;
    decimals = std::max(decimals, digits[k].significant - 1 - digits[k].exponent);
    significant = std::max(significant, digits[k].significant);
  }
  std::vector<double> out(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (by == Rounding::decimals) out[k] = 0.5 * std::pow(10.0, -decimals);
    if (by == Rounding::significant_digits)
      out[k] = numbers[k] == 0 ? 0 : 0.5 * std::pow(10.0, digits[k].exponent + 1 - significant);
    if (by == Rounding::single_precision) out[k] = 0x1p-24 * numbers[k];
  }
  return out;
}

struct Limits {
  double low = 0, high = std::numeric_limits<double>::infinity();
};

// The limits of the spacing if the first number is line `first`; nothing if no spacing explains every number.
std::optional<Limits> limits_of(std::span<const double> numbers, const std::vector<double>& error, double first) {
  Limits out;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double line = first + static_cast<double>(k);
    const double low = numbers[k] * (1 - kArithmetic) - error[k], high = numbers[k] * (1 + kArithmetic) + error[k];
    if (line == 0 && low > 0) return std::nullopt;
    if (line == 0) continue;
    out.low = std::max(out.low, low / line);
    out.high = std::min(out.high, high / line);
    if (!(out.low <= out.high)) return std::nullopt;
  }
  return out.low > 0 ? std::optional(out) : std::nullopt;
}

struct Spacing {
  double first = 0;  // number of the first line
  Limits limits;     // in the unit of the file
  double df_Hz = 0;
  int digits = std::numeric_limits<int>::max();  // that the choice needs
  bool round = false;
};

// The roundest spacing within the limits. A form other than the spacing in Hz or in the file's unit must save a digit:
// there are several such forms.
void choose_roundest(Spacing& spacing, double to_Hz, double last) {
  const double low_Hz = spacing.limits.low * to_Hz, high_Hz = spacing.limits.high * to_Hz;
  const auto consider = [&](double round, double df_Hz, int extra_digits) {
    const int digits = digits_of(round).significant + extra_digits;
    if (digits >= spacing.digits) return;
    spacing.digits = digits;
    spacing.df_Hz = df_Hz;
  };
  const double in_Hz = roundest_between(low_Hz, high_Hz);
  consider(in_Hz, in_Hz, 0);
  const double in_unit = roundest_between(spacing.limits.low, spacing.limits.high);
  consider(in_unit, in_unit * to_Hz, 0);
  const double length_s = roundest_between(1 / high_Hz, 1 / low_Hz);
  consider(length_s, 1 / length_s, 1);
  const double end_Hz = roundest_between(low_Hz * last, high_Hz * last);
  consider(end_Hz, end_Hz / last, 1);
  constexpr int kRates = 4;  // numbers of samples: exports often end below half the sampling rate
  auto samples = static_cast<double>(std::bit_ceil(2 * static_cast<std::uint64_t>(last)));
  for (int i = 0; i < kRates; ++i, samples *= 2) {
    const double fs_Hz = roundest_between(low_Hz * samples, high_Hz * samples);
    consider(fs_Hz, fs_Hz / samples, 1);
  }
  // A random number within the limits needs about this many digits.
  const double random_digits = -std::log10(std::max((high_Hz - low_Hz) / high_Hz, kArithmetic));
  spacing.round = spacing.digits <= random_digits - 1;
  if (!spacing.round) spacing.df_Hz = low_Hz + (high_Hz - low_Hz) / 2;
}

// The roundest spacing that explains every number by one kind of rounding. `first` and `rough` are the first line and
// the spacing that the first and the last number give.
std::optional<Spacing> rounded_spacing(std::span<const double> numbers, double to_Hz, double first, double rough) {
  std::vector<Digits> digits;
  for (const double number : numbers) digits.push_back(digits_of(number));
  const auto steps = static_cast<double>(numbers.size() - 1);
  for (const Rounding by : {Rounding::decimals, Rounding::significant_digits, Rounding::single_precision}) {
    const std::vector<double> error = largest_errors(numbers, digits, by);
    const double largest = *std::max_element(error.begin(), error.end());
    if (!(2 * largest < kMaxUnit * rough)) continue;
    constexpr double kMaxFurther = 20;
    const double further = std::min(std::ceil(first * 2 * largest / (steps * rough)), kMaxFurther);
    Spacing best;
    for (double off = -further; off <= further; ++off) {
      if (first + off < 0) continue;
      const auto limits = limits_of(numbers, error, first + off);
      if (!limits) continue;
      Spacing found{.first = first + off, .limits = *limits};
      choose_roundest(found, to_Hz, found.first + steps);
      const bool nearer = std::abs(off) < std::abs(best.first - first);
      if (found.digits < best.digits || (found.digits == best.digits && nearer)) best = found;
    }
    if (best.df_Hz > 0) return best;
  }
  return std::nullopt;
}

std::string rounding_note(const Spacing& spacing, double to_Hz, double written_Hz) {
  constexpr double kNotedDifference = 1e-7;  // relative; a fit of many lines is as accurate
  if (spacing.round) {
    if (std::abs(spacing.df_Hz / written_Hz - 1) <= kNotedDifference) return {};
    return fmt::format(
        "the frequencies are rounded: their spacing is taken as {:.10g} Hz, not {:.10g}; state the spacing if it "
        "differs",
        spacing.df_Hz, written_Hz);
  }
  const double low_Hz = spacing.limits.low * to_Hz, high_Hz = spacing.limits.high * to_Hz;
  if ((high_Hz - low_Hz) / 2 <= kNotedDifference * high_Hz) return {};
  return fmt::format(
      "the frequencies are rounded: their spacing lies between {:.10g} and {:.10g} Hz and is taken as {:.10g} Hz; "
      "state the spacing if you know it",
      low_Hz, high_Hz, spacing.df_Hz);
}

// How far the frequencies are from multiples of a spacing.
struct Offsets {
  double largest = 0;  // in spacings
  bool exact = true, finite = true;
  std::optional<std::size_t> first_off;  // the first one more than kMaxLineOffset off
};

Offsets offsets_of(const std::vector<double>& numbers, double to_Hz, double first, double df_Hz) {
  Offsets out;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double expected_Hz = (first + static_cast<double>(k)) * df_Hz;
    const double off_Hz = std::abs(numbers[k] * to_Hz - expected_Hz);
    out.exact = out.exact && off_Hz <= kExact * expected_Hz;
    out.finite = out.finite && std::isfinite(off_Hz);
    out.largest = std::max(out.largest, off_Hz / df_Hz);
    if (!out.first_off && !(off_Hz <= kMaxLineOffset * df_Hz)) out.first_off = k;
  }
  return out;
}

LineRange line_range(double first, std::size_t count, double df_Hz) {
  LineRange lines{.first = static_cast<std::size_t>(first), .count = count};
  lines.samples = 2 * (lines.first + count - 1);
  lines.fs_Hz = df_Hz * static_cast<double>(lines.samples);
  return lines;
}

}  // namespace

FrequencyLines frequency_lines(const std::vector<double>& numbers, double to_Hz, const std::string& where) {
  const char* const remedy = "save one line per frequency, evenly spaced from 0 Hz or a multiple of the spacing";
  const std::size_t n = numbers.size();
  if (n < 2) throw InputError("fewer than two frequencies", where, remedy);
  const double front_Hz = numbers.front() * to_Hz, back_Hz = numbers.back() * to_Hz;
  const double rough_Hz = (back_Hz - front_Hz) / static_cast<double>(n - 1);
  if (!(front_Hz >= 0) || !(rough_Hz > 0))
    throw InputError("frequencies that are negative, or do not rise", where, remedy);
  const double first = std::round(front_Hz / rough_Hz);
  if (!(first < static_cast<double>(kMaxFrfLines)))
    throw InputError("frequencies too close together (more than 2^28 lines from 0 Hz)", where, remedy);
  const double last = first + static_cast<double>(n - 1), written_Hz = back_Hz / last;
  const Offsets offsets = offsets_of(numbers, to_Hz, first, written_Hz);
  // Beyond these limits, a multiple or an inverse may overflow, and infinity has no digits.
  const bool usable = offsets.finite && rough_Hz > 1e-100 && back_Hz < 1e100;
  const auto rounded = usable ? rounded_spacing(numbers, to_Hz, first, rough_Hz / to_Hz) : std::nullopt;
  if (!rounded && offsets.first_off) {
    throw InputError(fmt::format("the frequency {:.8g} Hz is not a multiple of the spacing of {:.6g} Hz",
                                 numbers[*offsets.first_off] * to_Hz, rough_Hz),
                     where, remedy);
  }
  FrequencyLines out{.lines = line_range(first, n, written_Hz), .spacing = {}, .note = {}};
  const double doubt_Hz = std::max(kKnownSpacing, offsets.largest / last) * written_Hz;
  out.spacing = {written_Hz - doubt_Hz, written_Hz + doubt_Hz};
  if (!rounded || (offsets.exact && rounded->first != first)) return out;
  out.spacing.lowest_Hz = std::min(out.spacing.lowest_Hz, rounded->limits.low * to_Hz);
  out.spacing.highest_Hz = std::max(out.spacing.highest_Hz, rounded->limits.high * to_Hz);
  if (offsets.exact) return out;
  out.lines = line_range(rounded->first, n, rounded->df_Hz);
  out.spacing = {rounded->limits.low * to_Hz, rounded->limits.high * to_Hz};
  out.note = rounding_note(*rounded, to_Hz, written_Hz);
  return out;
}

}  // namespace percuss::acquire
