#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// What makes the force's spectrum wrong: the noise within the gate, or also the ringing that the gate cuts off.
enum class ForceErrors { noise, all };

/// What the force channel's noise within the gate does to the FRFs of a point, and the ringing that drowned in it and
/// was cut off: a gain 1 + ε(ω), common to all responses, smooth over frequency because the gate is short. Column i is
/// ε at the lines given for the i-th of independent standard normal variables; Σ over columns of |ε|² is its variance.
/// Empty where the noise is not known.
/// shape  [lines.size(), variables].
/// theory (4.11)
Eigen::MatrixXcd gain_errors(const FrfDataset& set, std::size_t point, const std::vector<std::size_t>& lines,
                             ForceErrors of = ForceErrors::all);

/// Deviation of that gain near a frequency, of real and imaginary part each.
double gain_deviation(const FrfDataset& set, std::size_t point, double freq_Hz);

}  // namespace percuss::identify
