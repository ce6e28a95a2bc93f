#pragma once
#include <Eigen/Core>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// The variance of the lines of a residual, E|R(k)|², per hit and channel. Records of several files may differ in noise
/// by any factor, so each hit has a level of its own in each channel; the hits of a channel share its dependence on the
/// frequency. That is the median of the hits' mean power over their levels in blocks of lines, interpolated between the
/// blocks. Peaks in less than half of a block do not change it. It is at least `floor` (E|R|² of rounding).
/// shapes  floor [hits × channels]; result [lines, hits × channels].
Eigen::MatrixXd decay_line_noise(const DecaySpectra& residual, const Eigen::VectorXd& floor);

/// The power of rounding: the mean power of a hit's lines in a channel times the square of the accuracy of the model's
/// columns. shape [hits × channels].
Eigen::VectorXd decay_rounding(const DecaySpectra& measured);

}  // namespace percuss::identify
