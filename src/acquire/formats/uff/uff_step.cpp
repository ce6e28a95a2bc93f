#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acquire/formats/uff/uff_contents.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/io/time_stamps.hpp"

namespace percuss::acquire {
namespace {

constexpr double kUnchanged = 1e-9;  // relative

std::size_t significant_digits(double value) {
  std::string text = fmt::format("{:.14e}", std::abs(value));
  text.resize(text.find('e'));
  while (text.back() == '0') text.pop_back();
  return text.size();
}

std::optional<double> number_after(std::string_view line, std::string_view key) {
  const auto at = line.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view rest = line.substr(at + key.size());
  const ParsedNumber number = parse_number(rest.substr(0, rest.find(';')), false);
  return number.problem == NumberProblem::none ? std::optional(number.value) : std::nullopt;
}

}  // namespace

UffAnnotation uff_annotation(const UffFunction& function) {
  UffAnnotation out;
  out.by_percuss = function.id[4].starts_with("percuss");
  if (!out.by_percuss) return out;
  const std::string &fifth_line = function.id[4], &fourth_line = function.id[3];
  out.node_offset = fifth_line.find("node = point + 1") != std::string::npos ? 1 : 0;
  out.continuous = fifth_line.find("; continuous") != std::string::npos;
  out.dx = number_after(fifth_line, "dx =");
  out.averages = static_cast<std::size_t>(
      std::min(std::max(number_after(fourth_line, "averages =").value_or(0), 0.0), kMaxAverages));
  out.angle_deg = number_after(fourth_line, "angle_deg =");
  out.position_m = number_after(fourth_line, "position_m =");
  out.decay_per_s = number_after(fourth_line, "decay_per_s =");
  constexpr std::string_view kEstimator = "estimator = ";
  if (function.id[1].starts_with(kEstimator))
    out.estimator = one_line(trimmed(std::string_view(function.id[1]).substr(kEstimator.size())), 60);
  return out;
}

double uff_step(const UffFunction& function, bool frequency, double to_SI, UffStepNote& note) {
  const double dx = function.dx;
  if (!(dx > 0) || !std::isfinite(dx)) return dx;
  const double half_unit = 0.5 * std::pow(10.0, -decimals_of(function.dx_text, false));
  if (!(half_unit / dx < 1e-3)) return dx;  // too few digits to choose a rounder step
  const double low = dx - half_unit, high = dx + half_unit;
  const auto stated = uff_annotation(function).dx;
  if (stated && *stated >= low * (1 - kUnchanged) && *stated <= high * (1 + kUnchanged)) return *stated;
  const double round_inverse = roundest_between(1 / high, 1 / low), round_step = roundest_between(low, high);
  const bool take_step = frequency && significant_digits(round_step) <= significant_digits(round_inverse);
  const double step = take_step ? round_step : 1 / round_inverse;
  if (std::abs(step / dx - 1) > kUnchanged) {
    note.largest_error = std::max(std::abs(low / step - 1), std::abs(high / step - 1));
    note.text =
        frequency
            ? fmt::format(
                  "spacing {:.10g} Hz: of all spacings that round to {}, it (or its inverse) has the fewest digits",
                  step * to_SI, trimmed(function.dx_text))
            : fmt::format(
                  "sampling rate {:.10g} Hz: of all rates whose time step rounds to {} {}, it has the fewest digits",
                  round_inverse / to_SI, trimmed(function.dx_text),
                  function.abscissa.unit.empty() ? "s" : function.abscissa.unit);
  }
  return step;
}

}  // namespace percuss::acquire
