#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// Neighbouring modes that are fitted together, and the spectral lines to which they are fitted.
struct DecayGroup {
  std::vector<DecayRate> rates;
  std::vector<std::pair<std::size_t, std::size_t>> windows;  // first line and count; ascending, disjoint
  Eigen::VectorXd level{};  // [hits × channels] noise power of a hit over its channel's geometric mean; empty: all 1
  Eigen::VectorXd line_std{};  // of the noise in the lines of the windows, relative; empty: all 1
};

struct DecayGroupFit {
  std::vector<DecayRate> rates;  // in the order of the group
  Eigen::MatrixXcd amplitude;    // [modes, hits × channels] at the first sample
  Eigen::MatrixXd covariance;    // of (Re s, Im s) of each mode, [2 modes, 2 modes]
  /// [hits × channels] variance of the real and of the imaginary part of a line where line_std is 1.
  Eigen::VectorXd noise;
  Eigen::MatrixXd inverse_gram;  // [2 modes, 2 modes] of the columns; times `noise`: covariance of an amplitude
  /// [hits] The step of the rates to the optimum of each hit alone (linear estimate), and the hit's normal matrix.
  std::vector<Eigen::VectorXd> hit_step;
  std::vector<Eigen::MatrixXd> hit_information;
  /// √((1 + c)/(1 − c)) for the correlation c of neighbouring lines' residuals: the standard deviation of a sum of many
  /// such residuals, relative to independent ones. Above 1 where the model leaves structure; 1 where c is not
  /// significant.
  double misfit = 1;
  bool converged = false;
};

/// The accuracy of a group fit. rough: few steps, for a search that fits the group again later.
enum class DecayAccuracy { rough, full };

/// Maximum likelihood of the group's rates in noise of a known spectrum and one variance per channel: amplitudes are
/// eliminated by QR (variable projection), the rates found by Levenberg–Marquardt steps. `data` are spectra without all
/// other modes, over the group's windows one after the other, [lines, hits × channels]. The amplitudes of each hit and
/// channel are free complex numbers. Restricting them to products of one number per hit and one per channel would not
/// lower the Cramér–Rao bound of the rates.
DecayGroupFit fit_decay_group(const DecayGroup& group, const DecaySpectra& spectra, const Eigen::MatrixXcd& data,
                              DecayAccuracy accuracy = DecayAccuracy::full);

}  // namespace percuss::identify
