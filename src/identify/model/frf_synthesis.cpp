#include "identify/model/frf_synthesis.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <type_traits>
#include <variant>

#include "core/math/complex.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "identify/model/point_columns.hpp"

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

// The sums over the modes in (1), [channels][count], at lines first … first + count − 1 of the set.
std::vector<Eigen::VectorXcd> sums_at(const FrfDataset& set, const std::vector<Mode>& modes, std::size_t first,
                                      std::size_t count) {
  std::vector<PointValues> values;
  values.reserve(modes.size());
  for (const Mode& mode : modes) values.emplace_back(mode.pole, set, first, count);
  const auto channels = channels_by_point(set);
  std::vector<Eigen::VectorXcd> sums(set.channels.size());
  const auto add = [&](const PointValues& of, std::size_t point, std::size_t o, Complex residue) {
    std::vector<Complex> work;
    add_scaled(sums[o].data(), residue, of.at(set.points[point], work).data(), count);
  };
  parallel_for_cost(channels.size(), kFlopsPerModeLine * count * modes.size(), [&](std::size_t p) {
    for (const std::size_t o : channels[p]) sums[o] = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count));
    std::vector<Complex> work;
    for (std::size_t m = 0; m < modes.size() && !channels[p].empty(); ++m) {
      const auto column = values[m].at(set.points[p], work);
      for (const std::size_t o : channels[p]) {
        const Residue& residue = modes[m].residues[o];
        if (residue.own_pole)
          add(PointValues(*residue.own_pole, set, first, count), p, o, residue.value);
        else
          add_scaled(sums[o].data(), residue.value, column.data(), count);
      }
    }
  });
  return sums;
}

Eigen::Map<const Eigen::VectorXcd> measured(const FrfDataset& set, std::size_t o, Eigen::Index first,
                                            Eigen::Index count) {
  return {set.channels[o].frf.data() + first, count};
}

// Synthesises FRF o, to which the modes contribute `sum` at lines from `first` on. Returns the power of the measured
// FRF.
double synthesise(const FrfDataset& set, std::size_t o, Eigen::Index first,
                  const Eigen::Ref<const Eigen::VectorXcd>& sum, const AnyTermFit& terms, SynthesisedFrf& made) {
  const auto frf = measured(set, o, first, sum.size());
  Eigen::MatrixXcd rest = frf - sum;
  const Eigen::VectorXcd fitted = std::visit([&](const auto& of) { return of.take_from(rest); }, terms);
  const Eigen::VectorXcd whole = frf - rest;  // (1)
  made = {.point = set.channels[o].point,
          .channel = set.channels[o].channel,
          .value = {whole.data(), whole.data() + whole.size()},
          .terms = {fitted.data(), fitted.data() + kTerms}};
  made.frac = frac({frf.data(), made.value.size()}, made.value);
  made.noise_share = noise_share(rest.col(0));
  return frf.squaredNorm();
}

// sums: [channels] the sums of the modes, which begin `offset` lines before the band.
std::vector<SynthesisedFrf> synthesised_from(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums,
                                             const acquire::LineRange& band, Eigen::Index offset) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  if (band.count == 0) return {};
  const AnyTermFit terms = term_fit(band, set.window_decay_per_s());
  const auto first = static_cast<Eigen::Index>(band.first - set.lines.first);
  std::vector<SynthesisedFrf> out(set.channels.size());
  std::vector<double> power(out.size());
  parallel_for_cost(out.size(), kFlopsPerModeLine * band.count, [&](std::size_t o) {
    const auto sum = sums[o].segment(offset, static_cast<Eigen::Index>(band.count));
    power[o] = synthesise(set, o, first, sum, terms, out[o]);
  });
  const double most = power.empty() ? 0 : *std::max_element(power.begin(), power.end());
  constexpr double kFloor = 1e-30;  // of the strongest FRF's power: a dead channel reads −300 dB
  for (std::size_t o = 0; o < out.size() && most > 0; ++o)
    out[o].level_dB = 10 * std::log10(std::max(power[o] / most, kFloor));
  return out;
}

}  // namespace

double frac(std::span<const Complex> measured, std::span<const Complex> synthesised) {
  assert(measured.size() == synthesised.size());
  Complex cross;
  double a = 0, b = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    cross += conj_times(measured[k], synthesised[k]);
    a += std::norm(measured[k]);
    b += std::norm(synthesised[k]);
  }
  return a > 0 && b > 0 ? std::min(1.0, std::norm(cross) / a / b) : 0;  // (2)
}

std::vector<SynthesisedFrf> synthesised_frfs(const FrfDataset& set, const std::vector<Mode>& modes,
                                             const acquire::LineRange& band) {
  if (band.count == 0) return {};
  return synthesised_from(set, sums_at(set, modes, band.first - set.lines.first, band.count), band, 0);
}

std::vector<Eigen::VectorXcd> modal_sums(const FrfDataset& set, const std::vector<Mode>& modes) {
  return sums_at(set, modes, 0, set.lines.count);
}

std::vector<SynthesisedFrf> frfs_from_sums(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums,
                                           const acquire::LineRange& band) {
  return synthesised_from(set, sums, band, static_cast<Eigen::Index>(band.first - set.lines.first));
}

std::vector<Eigen::VectorXcd> residuals_from_sums(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums) {
  const AnyTermFit terms = term_fit(set.lines, set.window_decay_per_s());
  std::vector<Eigen::VectorXcd> residuals(sums.size());
  parallel_for_cost(sums.size(), kFlopsPerModeLine * set.lines.count, [&](std::size_t o) {
    Eigen::MatrixXcd rest = measured(set, o, 0, sums[o].size()) - sums[o];
    std::visit([&](const auto& of) { of.take_from(rest); }, terms);
    residuals[o] = rest.col(0);
  });
  return residuals;
}

}  // namespace percuss::identify
