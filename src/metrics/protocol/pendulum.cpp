#include "metrics/protocol/pendulum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "metrics/protocol/averages.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

// Largest change of an interval, over the period. Damping and noise change it by less, a lost crossing by half or more.
constexpr double kMaxUneven = 0.2;

std::string uneven_crossing(const std::vector<double>& times_s, std::size_t p) {
  std::vector<double> spans;
  for (std::size_t n = 0; n + p < times_s.size(); ++n) spans.push_back(times_s[n + p] - times_s[n]);
  const double usual = median(spans);
  for (std::size_t n = 0; n < spans.size(); ++n) {
    if (std::abs(spans[n] - usual) > kMaxUneven * usual) {
      return fmt::format(
          "time {} is {:.4g} s after time {}, but the usual interval is {:.4g} s: a time is missing or counted twice",
          n + p + 1, spans[n], n + 1, usual);
    }
  }
  return {};
}

}  // namespace

PeriodEstimate mean_period(const std::vector<double>& periods_s, double resolution_s) {
  if (periods_s.empty()) return {.problem = "no period is given"};
  const double scatter_s = standard_error_of(periods_s);
  const double independent = scatter_s > 0 ? static_cast<double>(periods_s.size()) : 1;
  return {.period_s = mean_of(periods_s),
          .std_s = std::hypot(scatter_s, reading_std(resolution_s) / std::sqrt(independent))};
}

PeriodEstimate period_of_crossings(const std::vector<double>& times_s, std::size_t p, double resolution_s) {
  const std::size_t count = times_s.size();
  if (count < p + 1)
    return {.problem = fmt::format("the number of times is {}, but a period needs at least {}", count, p + 1)};
  for (std::size_t n = 1; n < count; ++n) {
    if (!(times_s[n] > times_s[n - 1]))
      return {.problem = fmt::format("time {} does not come after time {}", n + 1, n)};
  }
  if (std::string problem = uneven_crossing(times_s, p); !problem.empty()) return {.problem = std::move(problem)};
  // (P2): with the means of their directions subtracted, all times lie on one line, whose slope is the period.
  std::vector<double> turns(count), turn_mean(p, 0), time_mean(p, 0), members(p, 0);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t whole = n / p;
    turns[n] = static_cast<double>(whole);
    turn_mean[n % p] += turns[n];
    time_mean[n % p] += times_s[n];
    members[n % p] += 1;
  }
  const auto turn = [&](std::size_t n) { return turns[n] - turn_mean[n % p] / members[n % p]; };
  const auto time = [&](std::size_t n) { return times_s[n] - time_mean[n % p] / members[n % p]; };
  double xx = 0, xy = 0, residual_square = 0;
  for (std::size_t n = 0; n < count; ++n) {
    xx += turn(n) * turn(n);
    xy += turn(n) * time(n);
  }
  const double period = xy / xx;
  for (std::size_t n = 0; n < count; ++n)
    residual_square += (time(n) - period * turn(n)) * (time(n) - period * turn(n));
  double variance = count > p + 1 ? residual_square / static_cast<double>(count - p - 1) : 0;
  if (variance < std::pow(kReadingTolerance * period, 2)) variance = 0;  // rounded times that fit exactly tell no error
  const double read = reading_std(resolution_s);
  return {.period_s = period, .std_s = std::sqrt(std::max(variance, read * read) / xx)};
}

}  // namespace percuss::metrics
