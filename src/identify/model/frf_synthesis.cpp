#include "identify/model/frf_synthesis.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel/parallel.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

constexpr Eigen::Index kTerms = 4;
constexpr std::size_t kFlopsPerModeLine = 40;  // operations per spectral line and mode

Eigen::MatrixXcd residual_columns(const acquire::LineRange& band, double decay_per_s) {
  Eigen::MatrixXcd out(static_cast<Eigen::Index>(band.count), kTerms);
  const double end = kTwoPi * band.freq_Hz(band.count - 1);
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    const Complex s = Complex(decay_per_s, kTwoPi * band.freq_Hz(static_cast<std::size_t>(k))) / end;
    out(k, 0) = 1;
    out(k, 1) = s * s;
    out(k, 2) = s * s * s * s;
    out(k, 3) = s * s * s * s * s * s;
  }
  return out;
}

// [terms, lines] the least-squares coefficients of the columns. By QR: over a narrow band the powers of s are nearly
// dependent. With fewer lines than terms, the last coefficients are 0.
Eigen::MatrixXcd coefficients_from(const Eigen::MatrixXcd& columns) {
  const Eigen::Index used = std::min(columns.cols(), columns.rows());
  const Eigen::HouseholderQR<Eigen::MatrixXcd> factors(columns.leftCols(used));
  const Eigen::MatrixXcd basis = factors.householderQ() * Eigen::MatrixXcd::Identity(columns.rows(), used);
  Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(columns.cols(), columns.rows());
  out.topRows(used) = factors.matrixQR().topRows(used).triangularView<Eigen::Upper>().solve(basis.adjoint());
  return out;
}

double noise_share(const Eigen::VectorXcd& residual) {
  const Eigen::Index n = residual.size() - 2;
  const double energy = residual.size() > 2 ? residual.segment(1, n).squaredNorm() : 0;
  if (!(energy > 0)) return 0;
  return std::min(
      1.0, (residual.segment(1, n) - 0.5 * (residual.head(n) + residual.tail(n))).squaredNorm() / (1.5 * energy));
}

// The terms common to all FRFs, and the synthesis of one FRF.
class Synthesis {
 public:
  Synthesis(const FrfDataset& set, const std::vector<Mode>& modes, const acquire::LineRange& band)
      : set_(set),
        modes_(modes),
        first_(band.first - set.lines.first),
        count_(band.count),
        terms_(residual_columns(band, set.window_decay_per_s())),
        fit_(coefficients_from(terms_)) {
    whole_.reserve(modes.size());
    for (const Mode& mode : modes) {
      whole_.push_back(
          untruncated_column(mode.pole, set.window_decay_per_s(), set.lines, first_, count_, ColumnContent::value));
    }
  }

  // Synthesises FRF o into `made`. Returns the power of the measured FRF.
  double make(std::size_t o, SynthesisedFrf& made) const {
    const FrfChannel& channel = set_.channels[o];
    const auto begin = channel.frf.begin() + static_cast<std::ptrdiff_t>(first_);
    const std::vector<Complex> measured(begin, begin + static_cast<std::ptrdiff_t>(count_));
    const auto lines = static_cast<Eigen::Index>(count_);
    Eigen::VectorXcd sum = of_modes(o);
    const Eigen::VectorXcd rest = Eigen::Map<const Eigen::VectorXcd>(measured.data(), lines) - sum;
    const Eigen::VectorXcd fitted = fit_ * rest;
    sum += terms_ * fitted;  // (1)
    made = {.point = channel.point,
            .channel = channel.channel,
            .value = {sum.data(), sum.data() + lines},
            .terms = {fitted.data(), fitted.data() + kTerms}};
    made.frac = frac(measured, made.value);
    made.noise_share = noise_share(rest - terms_ * fitted);
    double power = 0;
    for (const Complex& h : measured) power += std::norm(h);
    return power;
  }

 private:
  Eigen::VectorXcd of_modes(std::size_t o) const {
    const PointForce& force = set_.points[set_.channels[o].point];
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count_));
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const Residue& residue = modes_[m].residues[o];
      const ModeColumn column =
          residue.own_pole ? mode_column(*residue.own_pole, force, set_.lines, first_, count_, ColumnContent::value)
                           : subtract_truncation(whole_[m], modes_[m].pole, force, set_.lines, first_);
      sum += residue.value * column.value;
    }
    return sum;
  }

  const FrfDataset& set_;
  const std::vector<Mode>& modes_;
  std::size_t first_, count_;
  Eigen::MatrixXcd terms_, fit_;
  std::vector<ModeColumn> whole_;
};

}  // namespace

double frac(const std::vector<Complex>& measured, const std::vector<Complex>& synthesised) {
  assert(measured.size() == synthesised.size());
  Complex cross;
  double a = 0, b = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    cross += std::conj(measured[k]) * synthesised[k];
    a += std::norm(measured[k]);
    b += std::norm(synthesised[k]);
  }
  return a > 0 && b > 0 ? std::min(1.0, std::norm(cross) / a / b) : 0;  // (2)
}

std::vector<SynthesisedFrf> synthesised_frfs(const FrfDataset& set, const std::vector<Mode>& modes,
                                             const acquire::LineRange& band) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  if (band.count == 0) return {};
  const Synthesis synthesis(set, modes, band);
  std::vector<SynthesisedFrf> out(set.channels.size());
  std::vector<double> power(out.size());
  parallel_for_cost(out.size(), kFlopsPerModeLine * band.count * (modes.size() + 1),
                    [&](std::size_t o) { power[o] = synthesis.make(o, out[o]); });
  const double most = power.empty() ? 0 : *std::max_element(power.begin(), power.end());
  constexpr double kFloor = 1e-30;  // of the strongest FRF's power: a dead channel reads −300 dB
  for (std::size_t o = 0; o < out.size() && most > 0; ++o)
    out[o].level_dB = 10 * std::log10(std::max(power[o] / most, kFloor));
  return out;
}

}  // namespace percuss::identify
