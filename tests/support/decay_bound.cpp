#include "support/decay_bound.hpp"

#include <Eigen/LU>
#include <cmath>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::test {

Eigen::MatrixXd decay_bound(const NoisyDecays& decays) {
  const auto modes = static_cast<Eigen::Index>(decays.poles.size());
  const auto rows = static_cast<Eigen::Index>(decays.noise_std.size());
  const Eigen::Index unknowns = 2 * modes + 2 * modes * rows;
  Eigen::MatrixXd fisher = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(decays.samples), unknowns);
    for (Eigen::Index m = 0; m < modes; ++m) {
      const Complex s = identify::decay_rate_of(decays.poles[static_cast<std::size_t>(m)]).rate_radps;
      const Complex a = decays.amplitude[static_cast<std::size_t>(m)][static_cast<std::size_t>(i)];
      const Eigen::Index at = 2 * modes + 2 * (m * rows + i);
      for (Eigen::Index n = 0; n < by.rows(); ++n) {
        const double t = static_cast<double>(n) / decays.fs_Hz;
        const Complex e = std::exp(s * t);
        by(n, 2 * m) = (a * t * e).real();
        by(n, 2 * m + 1) = (Complex(0, 1) * a * t * e).real();
        by(n, at) = e.real();
        by(n, at + 1) = -e.imag();
      }
    }
    const double std = decays.noise_std[static_cast<std::size_t>(i)];
    fisher += by.transpose() * by / (std * std);
  }
  return fisher.inverse().topLeftCorner(2 * modes, 2 * modes);
}

}  // namespace percuss::test
