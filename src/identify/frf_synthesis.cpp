#include "identify/frf_synthesis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/linear_algebra.hpp"
#include "core/units.hpp"

namespace percuss {
namespace {

constexpr Eigen::Index kTerms = 3;

Eigen::MatrixXcd residual_columns(const LineRange& band, double decay_per_s) {
  Eigen::MatrixXcd out(static_cast<Eigen::Index>(band.count), kTerms);
  const double end = kTwoPi * band.freq_Hz(band.count - 1);
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    const Complex s = Complex(decay_per_s, kTwoPi * band.freq_Hz(static_cast<std::size_t>(k))) / end;
    out(k, 0) = 1;
    out(k, 1) = s * s;
    out(k, 2) = s * s * s * s;
  }
  return out;
}

double noise_share(const Eigen::VectorXcd& left) {
  const Eigen::Index n = left.size() - 2;
  const double energy = left.size() > 2 ? left.segment(1, n).squaredNorm() : 0;
  if (!(energy > 0)) return 0;
  return std::min(1.0, (left.segment(1, n) - 0.5 * (left.head(n) + left.tail(n))).squaredNorm() / (1.5 * energy));
}

}  // namespace

double frac(const std::vector<Complex>& measured, const std::vector<Complex>& made) {
  assert(measured.size() == made.size());
  Complex cross;
  double a = 0, b = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    cross += std::conj(measured[k]) * made[k];
    a += std::norm(measured[k]);
    b += std::norm(made[k]);
  }
  return a > 0 && b > 0 ? std::min(1.0, std::norm(cross) / a / b) : 0;  // (2)
}

std::vector<SynthesisedFrf> synthesised_frfs(const FrfSet& set, const std::vector<Mode>& modes, const LineRange& band) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  std::vector<SynthesisedFrf> out;
  if (band.count == 0) return out;
  const Eigen::MatrixXcd terms = residual_columns(band, set.window_decay_per_s());
  const Eigen::MatrixXcd fit = inverse_gram(Eigen::MatrixXcd(terms.adjoint() * terms)) * terms.adjoint();
  const std::size_t first = band.first - set.lines.first;
  std::vector<ModeColumn> whole;
  whole.reserve(modes.size());
  for (const Mode& mode : modes)
    whole.push_back(whole_column(mode.pole, set.window_decay_per_s(), set.lines, first, band.count, Need::value));
  std::vector<double> levels;
  for (std::size_t o = 0; o < set.outputs.size(); ++o) {
    const Output& output = set.outputs[o];
    const auto begin = output.frf.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<Complex> measured(begin, begin + static_cast<std::ptrdiff_t>(band.count));
    const auto lines = static_cast<Eigen::Index>(band.count);
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(lines);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const PointForce& force = set.points[output.point];
      const Residue& residue = modes[m].residues[o];
      const ModeColumn column = residue.own_pole
                                    ? mode_column(*residue.own_pole, force, set.lines, first, band.count, Need::value)
                                    : without_missing(whole[m], modes[m].pole, force, set.lines, first);
      sum += residue.value * column.value;
    }
    const Eigen::VectorXcd rest = Eigen::Map<const Eigen::VectorXcd>(measured.data(), lines) - sum;
    const Eigen::VectorXcd fitted = fit * rest;
    sum += terms * fitted;  // (1)
    SynthesisedFrf made{.point = output.point,
                        .channel = output.channel,
                        .value = {sum.data(), sum.data() + lines},
                        .terms = {fitted.data(), fitted.data() + kTerms}};
    made.frac = frac(measured, made.value);
    made.noise_share = noise_share(rest - terms * fitted);
    out.push_back(std::move(made));
    double power = 0;
    for (const Complex& h : measured) power += std::norm(h);
    levels.push_back(power);
  }
  const double most = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
  constexpr double kFloor = 1e-30;  // of the strongest's power: a dead channel reads −300 dB
  for (std::size_t o = 0; o < out.size() && most > 0; ++o)
    out[o].level_dB = 10 * std::log10(std::max(levels[o] / most, kFloor));
  return out;
}

}  // namespace percuss
