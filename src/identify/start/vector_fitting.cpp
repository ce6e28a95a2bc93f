#include "identify/start/vector_fitting.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/budget.hpp"
#include "core/units.hpp"
#include "identify/model/residual_terms.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int kRelocations = 10;
constexpr double kStartDamping = 0.01;
constexpr double kMinNoise = 1e-6;          // of an FRF's largest line
constexpr double kConstraintWeight = 1e-3;  // of the row that excludes σ = 0, relative to the other rows
constexpr std::size_t kBlocksPerPole = 4;
constexpr double kMaxStartDamping = 0.45;
constexpr double kMinNoiseScale = 1e-150;  // lower limit of a noise, so that its inverse stays finite

// Averages over blocks of lines. Frequencies are divided by the highest one, so that powers of s stay near 1.
struct AveragedLines {
  AveragedLines(const FrfDataset& set, std::size_t lines_per_block)
      : unit_radps(kTwoPi * set.lines.freq_Hz(set.lines.count - 1)) {
    const auto blocks = static_cast<Index>(set.lines.count / lines_per_block);
    const auto size = static_cast<Index>(lines_per_block);
    const MatrixXd terms = out_of_band_terms(set.lines);
    s.resize(blocks);
    residual_terms.resize(blocks, terms.cols());
    for (Index b = 0; b < blocks; ++b) {
      const double middle = static_cast<double>(b * size) + 0.5 * static_cast<double>(size - 1);
      const double freq_Hz = set.lines.freq_Hz(0) + middle * set.lines.df_Hz();
      s(b) = Complex(set.window_decay_per_s(), kTwoPi * freq_Hz) / unit_radps;
      residual_terms.row(b) = terms.middleRows(b * size, size).colwise().mean();
    }
    const LineNoise noise(set);
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const std::vector<double> power = noise.local(o);
      const Eigen::Map<const VectorXcd> all(set.channels[o].frf.data(), static_cast<Index>(set.lines.count));
      const Eigen::Map<const VectorXd> noise_power(power.data(), static_cast<Index>(power.size()));
      const double least = std::max(kMinNoise * all.cwiseAbs().maxCoeff(), kMinNoiseScale);
      frf.emplace_back(blocks);
      weight.emplace_back(blocks);
      for (Index b = 0; b < blocks; ++b) {
        frf.back()(b) = all.segment(b * size, size).mean();
        weight.back()(b) = 1 / std::max(std::sqrt(noise_power.segment(b * size, size).mean()), least);
      }
    }
  }

  double unit_radps;
  VectorXcd s;                   // jω (σ + jω under an exponential window) over unit_radps
  MatrixXd residual_terms;       // [blocks, terms]
  std::vector<VectorXcd> frf;    // [channels][blocks]
  std::vector<VectorXd> weight;  // … one over the noise
};

class PoleRelocation {
 public:
  PoleRelocation(const AveragedLines& lines, std::size_t count) : lines_(lines), poles_(static_cast<Index>(count)) {
    const double low = first(), width = last() - first();
    for (Index m = 0; m < poles_.size(); ++m)
      poles_(m) = start_pole(low + width * static_cast<double>(m) / static_cast<double>(count - 1));
  }

  // Moves the poles once. False where they stay, because the equations have no solution.
  bool step() {
    fill_columns();
    const Index unknowns = 2 * poles_.size() + 1;  // of σ: real and imaginary parts of c, and d
    MatrixXd rows(unknowns * static_cast<Index>(lines_.frf.size()) + 1, unknowns);
    for (std::size_t o = 0; o < lines_.frf.size(); ++o) {
      check_budget();
      rows.middleRows(static_cast<Index>(o) * unknowns, unknowns) = equations_of_weight_function(o);
    }
    // The mean of Re σ over the lines is 1.
    const double scale = kConstraintWeight * rows.topRows(rows.rows() - 1).norm();
    rows.bottomRows(1).leftCols(unknowns - 1) = scale * pole_columns_.real().colwise().mean();
    rows(rows.rows() - 1, unknowns - 1) = scale;
    const VectorXd sizes = rows.colwise().norm();
    if (!sizes.allFinite() || !(sizes.minCoeff() > 0)) return false;
    VectorXd right = VectorXd::Zero(rows.rows());
    right(rows.rows() - 1) = scale;
    const VectorXd solved =
        (rows * sizes.cwiseInverse().asDiagonal()).eval().householderQr().solve(right).cwiseQuotient(sizes);
    const double d = solved(unknowns - 1);
    if (!solved.allFinite() || d == 0) return false;
    move_to_zeros(solved, d);
    return true;
  }

  std::vector<Pole> poles() const {
    std::vector<Pole> out;
    for (const Complex& s : poles_) {
      const Pole pole{.freq_Hz = std::abs(s) * lines_.unit_radps / kTwoPi, .damping_ratio = -s.real() / std::abs(s)};
      const bool inside = std::abs(s) > first() && std::abs(s) < last();
      if (inside && pole.damping_ratio > 0 && pole.damping_ratio < kMaxStartDamping) out.push_back(pole);
    }
    std::sort(out.begin(), out.end(), [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
    return out;
  }

 private:
  static Complex start_pole(double omega) { return {-kStartDamping * omega, omega}; }
  double first() const { return lines_.s(0).imag(); }
  double last() const { return lines_.s(lines_.s.size() - 1).imag(); }

  // The columns of each pole and its complex conjugate: one for the real and one for the imaginary part of c or R.
  void fill_columns() {
    const Index count = poles_.size();
    const Index blocks = lines_.s.size();
    pole_columns_.resize(blocks, 2 * count);
    for (Index m = 0; m < count; ++m) {
      const VectorXcd one = (lines_.s.array() - poles_(m)).inverse();
      const VectorXcd mirror = (lines_.s.array() - std::conj(poles_(m))).inverse();
      pole_columns_.col(2 * m) = one + mirror;
      pole_columns_.col(2 * m + 1) = Complex(0, 1) * (one - mirror);
    }
    const Index terms = lines_.residual_terms.cols();
    model_columns_.resize(blocks, 2 * count + 2 * terms);
    model_columns_.leftCols(2 * count) = lines_.s.array().square().matrix().asDiagonal() * pole_columns_;
    model_columns_.middleCols(2 * count, terms) = lines_.residual_terms.cast<Complex>();
    model_columns_.rightCols(terms) = Complex(0, 1) * lines_.residual_terms.cast<Complex>();
    const Eigen::RowVectorXd sizes = model_columns_.colwise().norm();
    model_columns_ *= sizes.cwiseInverse().asDiagonal();
  }

  // The equations of (1) for one FRF, in which its residues and residual terms are eliminated.
  MatrixXd equations_of_weight_function(std::size_t channel) const {
    const VectorXcd weight = lines_.weight[channel].cast<Complex>();
    const VectorXcd weighted = weight.cwiseProduct(lines_.frf[channel]);
    const Index own = model_columns_.cols(), unknowns = pole_columns_.cols() + 1;
    MatrixXcd columns(weight.size(), own + unknowns);
    columns.leftCols(own) = weight.asDiagonal() * model_columns_;
    columns.middleCols(own, unknowns - 1) = -(weighted.asDiagonal() * pole_columns_);
    columns.rightCols(1) = -weighted;
    MatrixXd rows(2 * weight.size(), columns.cols());
    rows << columns.real(), columns.imag();
    const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> factors(rows);  // in place
    return MatrixXd(factors.matrixQR().block(own, own, unknowns, unknowns).triangularView<Eigen::Upper>());
  }

  // The zeros of σ are the eigenvalues of Λ − b cᵀ/d.
  void move_to_zeros(const VectorXd& coefficients, double d) {
    const Index count = poles_.size();
    MatrixXd matrix = MatrixXd::Zero(2 * count, 2 * count);
    for (Index m = 0; m < count; ++m) {
      const Complex pole = poles_(m);
      matrix.block<2, 2>(2 * m, 2 * m) << pole.real(), pole.imag(), -pole.imag(), pole.real();
      matrix.row(2 * m) -= 2 / d * coefficients.head(2 * count).transpose();
    }
    const VectorXcd zeros = matrix.eigenvalues();
    std::vector<Complex> moved;
    for (const Complex& zero : zeros)
      if (zero.imag() > 0) moved.emplace_back(-std::abs(zero.real()), zero.imag());
    // Two real zeros replace a complex pair. The missing pair begins again in the middle of the widest gap.
    std::sort(moved.begin(), moved.end(), [](const Complex& a, const Complex& b) { return a.imag() < b.imag(); });
    while (static_cast<Index>(moved.size()) < count) moved.insert(moved.end(), start_pole(middle_of_widest_gap(moved)));
    std::copy_n(moved.begin(), count, poles_.begin());
  }

  // The middle of the widest gap between neighbouring poles, or between a pole and an end of the lines. The poles are
  // sorted first, because poles that were added stand at the end.
  double middle_of_widest_gap(std::vector<Complex> poles) const {
    std::sort(poles.begin(), poles.end(), [](const Complex& a, const Complex& b) { return a.imag() < b.imag(); });
    double before = first(), widest = -1, middle = before;
    poles.emplace_back(0, last());
    for (const Complex& pole : poles) {
      const double at = std::clamp(pole.imag(), before, last());
      if (at - before > widest) {
        widest = at - before;
        middle = 0.5 * (at + before);
      }
      before = at;
    }
    return middle;
  }

  const AveragedLines& lines_;
  VectorXcd poles_;
  MatrixXcd pole_columns_, model_columns_;
};

}  // namespace

std::vector<Pole> vector_fitting_poles(const FrfDataset& set, std::size_t count, double resolution_Hz) {
  const auto most = static_cast<double>(set.lines.count) / static_cast<double>(kBlocksPerPole * count);
  const double asked = std::min(resolution_Hz / set.lines.df_Hz(), most);
  if (count < 2 || set.channels.empty() || most < 1) return {};
  const AveragedLines lines(set, std::max<std::size_t>(static_cast<std::size_t>(asked), 1));
  PoleRelocation relocation(lines, count);
  for (int i = 0; i < kRelocations; ++i)
    if (!relocation.step()) return {};
  return relocation.poles();
}

}  // namespace percuss::identify
