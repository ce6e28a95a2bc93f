#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/local_fit.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {

struct CandidateOptions {
  double prominence_dB = 3;  // above the saddles, before noise is allowed for
  double snr = 5;            // amplitude over noise at the peak
};

/// The prominent maxima of Σ|H|² over the channels, ascending.
std::vector<std::size_t> prominent_lines(const FrfDataset& set, const LineNoise& noise,
                                         const CandidateOptions& options = {});

/// First poles from them, in ascending frequency.
std::vector<Pole> candidate_poles(const FrfDataset& set, const LineNoise& noise, const CandidateOptions& options = {});

/// A resonance on a straight background that stands out of the lines' own noise.
struct Resonance {
  double line = 0, half_width = 0;  // lines from the set's first
  double gain = 0;                  // energy that it explains over the noise's, over the channels
};

/// Where what is left of the FRFs (residual [channels][lines], the known modes subtracted) rises so, at every width:
/// one resonance shows at several of them.
std::vector<Resonance> residual_resonances(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual);

/// First poles of modes too weak or too close to a stronger one to show as a peak of their own: the best width of each
/// hidden resonance. The clearest first.
std::vector<Pole> residual_mode_poles(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual);

/// A first pole for each frequency a person points at: that of the nearest peak, unless another frequency is nearer to
/// it; then one of the frequency itself. In the order of the frequencies.
std::vector<Pole> poles_near(const FrfDataset& set, const std::vector<double>& freq_Hz);

}  // namespace percuss::identify
