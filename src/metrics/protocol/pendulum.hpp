#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::metrics {

/// A period with its standard error; `problem` says in words why there is none, and is empty otherwise.
struct PeriodEstimate {
  double period_s = 0, std_s = 0;
  std::string problem;
};

/// Mean of repeated readings of the period; the error from their scatter, never below that of reading to
/// `resolution_s`.
PeriodEstimate mean_period(const std::vector<double>& periods_s, double resolution_s = 0);

/// From the times at which a swinging bat crosses one light gate. Crossings there and back alternate, and are not
/// evenly spaced unless the gate stands at rest's place; both directions keep the period:
///   t_n = c_d + T ⌊n/p⌋,  d = n mod p                                                          (P2)
/// by least squares for T and the p constants, where p (1 or 2) crossings are counted per period. Needs p + 1 times;
/// the error is from the residuals, never below that of times read to `resolution_s`. A time that is missing or double
/// (spans from n to n + p that differ by more than a fifth) is a problem.
PeriodEstimate period_of_crossings(const std::vector<double>& times_s, std::size_t per_period = 2,
                                   double resolution_s = 0);

}  // namespace percuss::metrics
