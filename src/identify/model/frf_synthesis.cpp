#include "identify/model/frf_synthesis.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <variant>

#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

constexpr Eigen::Index kTerms = 4;
constexpr std::size_t kFlopsPerModeLine = 40;  // operations per spectral line and mode

// The least-squares fit of the residual terms 1, s², s⁴, s⁶ to an FRF; s is divided by the highest ω. By QR: over a
// narrow band the powers of s are nearly dependent. With fewer lines than terms, the last coefficients are 0.
template <class Scalar>
class TermFit {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  TermFit(const acquire::LineRange& band, double decay_per_s) {
    Matrix columns(static_cast<Eigen::Index>(band.count), kTerms);
    const double end = kTwoPi * band.freq_Hz(band.count - 1);
    for (Eigen::Index k = 0; k < columns.rows(); ++k) {
      const Scalar s2 = square_of_s(kTwoPi * band.freq_Hz(static_cast<std::size_t>(k)) / end, decay_per_s / end);
      columns(k, 0) = 1;
      columns(k, 1) = s2;
      columns(k, 2) = s2 * s2;
      columns(k, 3) = s2 * s2 * s2;
    }
    const Eigen::Index used = std::min(columns.cols(), columns.rows());
    const Eigen::HouseholderQR<Matrix> factors(columns.leftCols(used));
    basis_ = factors.householderQ() * Matrix::Identity(columns.rows(), used);
    upper_ = factors.matrixQR().topRows(used);
  }

  // The coefficients of the terms in `rest` [lines, 1]; subtracts the terms from it.
  Eigen::VectorXcd take_from(Eigen::MatrixXcd& rest) const {
    Eigen::MatrixXcd shares;
    if constexpr (std::is_same_v<Scalar, double>)
      shares = transposed_product(basis_, rest);
    else
      shares = adjoint_product(basis_, rest);
    subtract_product(rest, basis_, shares);
    Eigen::VectorXcd coefficients = Eigen::VectorXcd::Zero(kTerms);
    const Eigen::MatrixXcd upper = upper_.template cast<Complex>();
    coefficients.head(basis_.cols()) = upper.triangularView<Eigen::Upper>().solve(shares).col(0);
    return coefficients;
  }

 private:
  static Scalar square_of_s(double omega, double decay) {
    if constexpr (std::is_same_v<Scalar, double>) {
      return -omega * omega;
    } else {
      return Complex(decay, omega) * Complex(decay, omega);
    }
  }

  Matrix basis_, upper_;
};

// Without a window, s² is real.
using AnyTermFit = std::variant<TermFit<double>, TermFit<Complex>>;

AnyTermFit term_fit(const acquire::LineRange& band, double decay_per_s) {
  if (decay_per_s == 0) return TermFit<double>(band, 0);
  return TermFit<Complex>(band, decay_per_s);
}

double noise_share(const Eigen::VectorXcd& residual) {
  const Eigen::Index n = residual.size() - 2;
  const double energy = residual.size() > 2 ? residual.segment(1, n).squaredNorm() : 0;
  if (!(energy > 0)) return 0;
  return std::min(
      1.0, (residual.segment(1, n) - 0.5 * (residual.head(n) + residual.tail(n))).squaredNorm() / (1.5 * energy));
}

// The contribution of the modes to an FRF, at some lines of the set.
class ModeColumns {
 public:
  ModeColumns(const FrfDataset& set, const std::vector<Mode>& modes, std::size_t first, std::size_t count)
      : set_(set), modes_(modes), first_(first), count_(count) {
    values_.reserve(modes.size());
    for (const Mode& mode : modes) values_.emplace_back(mode.pole, set.window_decay_per_s(), set.lines, first_, count_);
  }

  Eigen::VectorXcd sum_of(std::size_t o) const {
    const PointForce& force = set_.points[set_.channels[o].point];
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count_));
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const Residue& residue = modes_[m].residues[o];
      if (residue.own_pole) {
        ModeValues(*residue.own_pole, set_.window_decay_per_s(), set_.lines, first_, count_)
            .add_to({sum.data(), count_}, residue.value, force);
      } else {
        values_[m].add_to({sum.data(), count_}, residue.value, force);
      }
    }
    return sum;
  }

 private:
  const FrfDataset& set_;
  const std::vector<Mode>& modes_;
  std::size_t first_, count_;
  std::vector<ModeValues> values_;
};

// Synthesises FRF o, to which the modes contribute `sum`. Returns the power of the measured FRF.
double synthesise(const FrfDataset& set, std::size_t o, std::size_t first, const Eigen::VectorXcd& sum,
                  const AnyTermFit& terms, SynthesisedFrf& made) {
  const FrfChannel& channel = set.channels[o];
  const Eigen::Index lines = sum.size();
  const auto begin = channel.frf.begin() + static_cast<std::ptrdiff_t>(first);
  const std::vector<Complex> measured(begin, begin + lines);
  const Eigen::Map<const Eigen::VectorXcd> frf(measured.data(), lines);
  Eigen::MatrixXcd rest = frf - sum;
  const Eigen::VectorXcd fitted = std::visit([&](const auto& of) { return of.take_from(rest); }, terms);
  const Eigen::VectorXcd whole = frf - rest;  // (1)
  made = {.point = channel.point,
          .channel = channel.channel,
          .value = {whole.data(), whole.data() + lines},
          .terms = {fitted.data(), fitted.data() + kTerms}};
  made.frac = frac(measured, made.value);
  made.noise_share = noise_share(rest.col(0));
  double power = 0;
  for (const Complex& h : measured) power += std::norm(h);
  return power;
}

// sum(o): the contribution of the modes to FRF o at the lines of the band.
template <class Sum>
std::vector<SynthesisedFrf> synthesised_from(const FrfDataset& set, const acquire::LineRange& band, std::size_t flops,
                                             const Sum& sum) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  if (band.count == 0) return {};
  const AnyTermFit terms = term_fit(band, set.window_decay_per_s());
  std::vector<SynthesisedFrf> out(set.channels.size());
  std::vector<double> power(out.size());
  parallel_for_cost(out.size(), flops, [&](std::size_t o) {
    power[o] = synthesise(set, o, band.first - set.lines.first, sum(o), terms, out[o]);
  });
  const double most = power.empty() ? 0 : *std::max_element(power.begin(), power.end());
  constexpr double kFloor = 1e-30;  // of the strongest FRF's power: a dead channel reads −300 dB
  for (std::size_t o = 0; o < out.size() && most > 0; ++o)
    out[o].level_dB = 10 * std::log10(std::max(power[o] / most, kFloor));
  return out;
}

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
  if (band.count == 0) return {};
  const ModeColumns columns(set, modes, band.first - set.lines.first, band.count);
  return synthesised_from(set, band, kFlopsPerModeLine * band.count * (modes.size() + 1),
                          [&](std::size_t o) { return columns.sum_of(o); });
}

std::vector<Eigen::VectorXcd> modal_sums(const FrfDataset& set, const std::vector<Mode>& modes) {
  const ModeColumns columns(set, modes, 0, set.lines.count);
  std::vector<Eigen::VectorXcd> sums(set.channels.size());
  parallel_for_cost(sums.size(), kFlopsPerModeLine * set.lines.count * modes.size(),
                    [&](std::size_t o) { sums[o] = columns.sum_of(o); });
  return sums;
}

std::vector<SynthesisedFrf> frfs_from_sums(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums,
                                           const acquire::LineRange& band) {
  const auto first = static_cast<Eigen::Index>(band.first - set.lines.first);
  return synthesised_from(set, band, kFlopsPerModeLine * band.count, [&](std::size_t o) -> Eigen::VectorXcd {
    return sums[o].segment(first, static_cast<Eigen::Index>(band.count));
  });
}

}  // namespace percuss::identify
