#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::metrics {

/// A period with its standard error. If there is no period, `problem` states the reason.
struct PeriodEstimate {
  double period_s = 0, std_s = 0;
  std::string problem;
};

/// The mean of repeated readings of the period. The standard error combines the scatter of the n readings and the
/// error of reading to `resolution_s`, each divided by √n. Equal readings share one rounding error, which is not
/// divided by √n. The standard error is 0 if neither scatter nor resolution is known.
PeriodEstimate mean_period(const std::vector<double>& periods_s, double resolution_s = 0);

/// The period from the times at which a swinging bat crosses one light gate. Crossings in the two directions alternate.
/// They are evenly spaced only if the gate stands at the position of rest, but each direction keeps the period:
///   t_n = c_d + T ⌊n/p⌋,  d = n mod p                                                          (P2)
/// T and the p constants follow by least squares, with p (1 or 2) crossings per period and at least p + 1 times. The
/// standard error comes from the residuals, and is never below the error of times read to `resolution_s`. It is 0 for
/// times of unknown resolution that fit exactly. A missing or double time is a problem: an interval from n to n + p
/// then differs from the median interval by more than a fifth.
PeriodEstimate period_of_crossings(const std::vector<double>& times_s, std::size_t per_period = 2,
                                   double resolution_s = 0);

}  // namespace percuss::metrics
