#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mode's frequency or damping ratio in each hit, where it scatters significantly.
struct HitSeries {
  std::size_t mode = 0;
  bool is_freq = true;             // else the damping ratio
  std::vector<std::size_t> hits;   // hits that determine the value
  std::vector<double> value, std;  // [hits]
};

/// The larger of the slopes over the hits' force and over their order, in standard deviations of the noise: a test that
/// sees a trend before χ² does.
double trend_deviate(const HitSeries& series, const std::vector<double>& peak_N);

/// Whether a regression line explains 70 % of the χ² of the values with a slope that passes a t test (1 %, two-sided).
/// The line is over the order of the hits, or over their force, its square or its logarithm.
/// peak_N  [hits of the test]
bool follows_a_law(const HitSeries& series, const std::vector<double>& peak_N);

/// Decides for all series together whether the forces of the hits or their order explain the scatter, and describes the
/// modes' trends accordingly (Mode::amplitude, Mode::drift). Describes no trend unless a regression line explains 70 %
/// of the χ² of some series and its slope passes a t test (1 %, two-sided). A trend does not average out: the standard
/// deviation of a value that follows it is at least the spread of the trend over the hits.
/// peak_N  [hits of the test]
void explain_scatter(const std::vector<HitSeries>& series, const std::vector<double>& peak_N, std::vector<Mode>& modes);

}  // namespace percuss::identify
