#pragma once
#include <Eigen/Core>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// The variance of the lines of a residual, E|R(k)|², per channel: the median of the hits' mean power in blocks of
/// lines, interpolated between the blocks. Peaks in less than half of a block do not change it. It is at least
/// `floor` (E|R|² of rounding) in every channel. shapes  floor [channels]; result [lines, channels].
Eigen::MatrixXd decay_line_noise(const DecaySpectra& residual, const Eigen::VectorXd& floor);

/// The power of rounding: the mean power of a channel's lines times the square of the accuracy of the model's columns.
/// shape [channels].
Eigen::VectorXd decay_rounding(const DecaySpectra& measured);

}  // namespace percuss::identify
