#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// A decay that a matched filter finds in a residual.
struct DecayCandidate {
  DecayRate rate;
  /// Σ over hits and channels of the matched energy over the noise. Pure noise gives hits × channels on average.
  double energy = 0;
};

struct DecaySearchLimits {
  std::pair<double, double> band_Hz;
  std::size_t max_candidates = 4;
  std::vector<DecayRate> refused;  // no candidate within their half-power bandwidth
};

/// The energy that noise exceeds once in 1000 searches of `places` places. At each place, the energy of noise is a sum
/// of `spectra` (hits × channels) exponential variables (Chernoff's bound of a Gamma variable).
double decay_threshold(std::size_t spectra, std::size_t places);

/// The strongest decays of a residual that rise above the noise, well apart from each other, the strongest first. The
/// residual is whitened by its noise, and each decay rate of a geometric series is a matched filter:
///   T(ω, σ) = Σ_i |Σ_n x_i[n] exp(−(σ + jω) nΔ)|² / Σ_n exp(−2σ nΔ)                     (1)
/// with x of unit variance. theory (4.24)
/// shapes  noise [lines, hits × channels] of decay_line_noise.
std::vector<DecayCandidate> strongest_decays(const DecaySpectra& residual, const Eigen::MatrixXd& noise,
                                             const DecaySearchLimits& limits);

}  // namespace percuss::identify
