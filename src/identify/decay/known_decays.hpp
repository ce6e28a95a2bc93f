#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// Decays of known rates in free responses.
struct KnownDecays {
  Eigen::MatrixXcd amplitude;  // [rates, hits × channels] at the first sample
  Eigen::MatrixXd variance;    // [rates, hits × channels] of the real and of the imaginary part of an amplitude
  double explained = 0;        // share of the energy of the lines
};

/// The amplitudes that explain lines first … first + count − 1 best. The noise of a decay is the residual's near
/// its frequency. shapes  amplitude empty where there are fewer than three lines per rate.
KnownDecays fit_known_decays(const std::vector<DecayRate>& rates, const DecaySpectra& spectra, std::size_t first,
                             std::size_t count);

}  // namespace percuss::identify
