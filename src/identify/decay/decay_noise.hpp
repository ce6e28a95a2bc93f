#pragma once
#include <Eigen/Core>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// The variance of the lines of a residual, E|R(k)|², per hit and channel. Records of several files may differ in noise
/// by any factor. The variance is therefore a product: a level of each hit in each channel, times a spectrum that all
/// hits of the channel share. For the spectrum, the power of each hit is divided by the hit's level and averaged over
/// the hits. The spectrum is the mean power that follows from the median of this average in each block of lines,
/// interpolated between the blocks. Peaks in a small part of a block hardly change it. The variance is at least `floor`
/// (E|R|² of rounding).
/// shapes  floor [hits × channels]; result [lines, hits × channels].
Eigen::MatrixXd decay_line_noise(const DecaySpectra& residual, const Eigen::VectorXd& floor);

/// The standard deviation of the lines relative to its geometric mean, averaged over channels, hits and an octave
/// around each line. `noise` as of decay_line_noise(). shape [lines].
Eigen::VectorXd smooth_noise_std(const Eigen::MatrixXd& noise);

/// The power of the rounding of samples: the mean power of a hit's lines in a channel times the square of the
/// resolution of records. Rounded numbers without other noise have larger errors where the response is large; the
/// search would take them for decays. shape [hits × channels].
Eigen::VectorXd decay_rounding(const DecaySpectra& measured);

}  // namespace percuss::identify
