#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percuss::accuracy {

namespace {

constexpr double kSameTime = 1.1, kSameError = 1.01;  // factors within which figures count as equal

bool beats(const Figure& one, const Figure& other) {
  const bool no_worse = one.error <= other.error * kSameError && one.time_ratio <= other.time_ratio * kSameTime;
  return no_worse && (one.error * kSameError < other.error || one.time_ratio * kSameTime < other.time_ratio);
}

}  // namespace

void mark_pareto_front(std::vector<Figure>& figures) {
  for (Figure& figure : figures) {
    figure.on_pareto_front =
        std::isfinite(figure.error) &&
        std::none_of(figures.begin(), figures.end(), [&](const Figure& f) { return beats(f, figure); });
  }
}

const Case& case_of(const TaskFigures& task, const std::string& over, const std::string& value) {
  for (const Sweep& sweep : task.sweeps) {
    if (sweep.over != over) continue;
    for (const Case& one : sweep.cases) {
      if (one.value == value) return one;
    }
  }
  throw std::logic_error("no case " + value + " of " + over);
}

const Figure& figure_of(const Case& one, const std::string& method) {
  const auto found =
      std::find_if(one.figures.begin(), one.figures.end(), [&](const Figure& f) { return f.method == method; });
  if (found == one.figures.end()) throw std::logic_error("no method " + method);
  return *found;
}

std::string shown_figure(double value) {
  if (!std::isfinite(value) || value == 0) return "–";
  // Writes neither 1.2e+03 nor 123.45: digits beyond the third become zeros or are dropped.
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  if (decimals > 6) return fmt::format("{:.1e}", value);
  const double round = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  return fmt::format("{:.{}f}", std::round(value / round) * round, decimals);
}

}  // namespace percuss::accuracy
