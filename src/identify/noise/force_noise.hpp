#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Errors of the force's spectrum: the noise within the gate, or also the ringing that the gate cuts off.
enum class ForceErrors { noise, all };

/// The gain error ε(ω) of a point's FRFs, from the force channel's noise within the gate and from the ringing that the
/// gate cuts off. The gain 1 + ε(ω) is common to all responses. It is smooth over frequency where the gates are short;
/// with a gate that also holds a second contact, it changes within the inverse of the contact's delay.
/// Column i is ε at `lines` for the i-th of independent standard normal variables, so that Σ|ε|² over the columns is
/// the variance. Empty where the noise is unknown.
/// shape  [lines.size(), variables].
/// theory (4.11)
Eigen::MatrixXcd gain_errors(const FrfDataset& set, std::size_t point, const std::vector<std::size_t>& lines,
                             ForceErrors of = ForceErrors::all);

/// Standard deviation of one part (real or imaginary) of the gain error near a frequency: the square root of the mean
/// of the two variances.
double gain_std(const FrfDataset& set, std::size_t point, double freq_Hz);

/// Standard deviation of the gain error's real part near a frequency: the relative error of the FRFs' amplitudes. Where
/// the gate is much shorter than half a period, nearly all of the error is real.
/// theory (4.28)
double gain_amplitude_std(const FrfDataset& set, std::size_t point, double freq_Hz);

}  // namespace percuss::identify
