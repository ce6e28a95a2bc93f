#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/local_fit.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {

struct CandidateOptions {
  double prominence_dB = 3;  // above the saddles; more where the noise demands it
  double snr = 5;            // amplitude over noise
};

/// The spectral lines of the prominent maxima of Σ|H|² over the FRFs, ascending.
std::vector<std::size_t> prominent_lines(const FrfDataset& set, const LineNoise& noise,
                                         const CandidateOptions& options = {});

/// Start values of poles, from these maxima, in ascending frequency.
std::vector<Pole> candidate_poles(const FrfDataset& set, const LineNoise& noise, const CandidateOptions& options = {});

/// A resonance on a straight background that stands out of the noise.
struct Resonance {
  double line = 0;        // counted from the set's first line
  double half_width = 0;  // in lines
  double gain = 0;        // energy that it explains over the noise power, Σ over the FRFs
};

/// The resonances in a residual, [channels][lines], at every width. One resonance appears at several widths.
std::vector<Resonance> residual_resonances(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual);

/// Start values of the poles of modes without a peak of their own, weak or close to a stronger mode: each resonance of
/// the residual at its best width. The most significant first.
std::vector<Pole> residual_mode_poles(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual);

/// A stated frequency stands for the highest line within this part of the frequency, or within this many lines if that
/// is more.
inline constexpr double kStatedRange = 0.005, kStatedRangeLines = 4;

/// A start value of a pole for each stated frequency, in their order: the pole of the highest line in its range. Where
/// another stated frequency is nearer to that pole, the result is a pole at the frequency itself.
std::vector<Pole> poles_near(const FrfDataset& set, const std::vector<double>& freq_Hz);

}  // namespace percuss::identify
