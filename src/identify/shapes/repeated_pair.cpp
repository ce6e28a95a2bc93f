#include "identify/shapes/repeated_pair.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/model/point_columns.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

constexpr double kMinSecondSingular = 0.1;  // of the first: below, errors of the model may explain it
constexpr double kOwnMode = 0.5;            // half-power bandwidths to another mode
constexpr double kWindow = 2;               // half-power bandwidths on either side of the pole
constexpr double kMinWindowLines = 8;       // on either side
constexpr Index kBackgroundTerms = 3;       // of the polynomial of each FRF
constexpr int kPencilPasses = 12;           // of the linearised fit
constexpr double kSettled = 1e-4;           // change of the split in a pass, of its standard deviation
constexpr double kMinSplit = 5;             // standard deviations of a split that tells the two modes apart
constexpr double kMaxSplit = 0.5;           // half-power bandwidths: the linearised fit converges below
constexpr double kMaxMixing = 0.3;          // standard deviation of the other mode's share in a mode's shape

using Pair = std::array<Complex, 2>;

// Residues over [points, channels], and the index of each FRF in the set.
struct ResidueMatrix {
  MatrixXcd value;
  MatrixXd std;
  std::vector<std::pair<Index, Index>> place;  // [FRFs] row and column
};

// Nothing where an FRF of some point and channel is missing, or occurs twice.
std::optional<ResidueMatrix> matrix_of(const FrfDataset& set, const Mode& mode) {
  std::size_t channels = 0;
  for (const FrfChannel& one : set.channels) channels = std::max(channels, one.channel + 1);
  if (mode.residues.size() != set.channels.size() || set.points.size() * channels != set.channels.size())
    return std::nullopt;
  const auto rows = static_cast<Index>(set.points.size()), columns = static_cast<Index>(channels);
  ResidueMatrix out{.value = MatrixXcd::Zero(rows, columns), .std = MatrixXd::Constant(rows, columns, -1), .place = {}};
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const auto row = static_cast<Index>(set.channels[o].point), column = static_cast<Index>(set.channels[o].channel);
    if (out.std(row, column) >= 0) return std::nullopt;
    out.value(row, column) = mode.residues[o].value;
    out.std(row, column) = mode.residues[o].std;
    out.place.emplace_back(row, column);
  }
  return out;
}

// The lines around the mode, without the other modes, and the linear fit of each FRF there:
// y = a φ(p) + b ∂φ/∂f(p) + background.
class LinearisedFit {
 public:
  LinearisedFit(const FrfDataset& set, const std::vector<Mode>& modes, std::size_t m) : set_(set), mode_(modes[m]) {
    const Pole& pole = mode_.pole;
    const double at = set.lines.position(pole.freq_Hz);
    const double half = std::max(kWindow * pole.half_power_Hz() / set.lines.df_Hz(), kMinWindowLines);
    first_ = set.lines.at(at - half);
    count_ = set.lines.at(at + half) - first_ + 1;
    std::vector<Mode> others = modes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(m));
    const std::vector<VectorXcd> sums = modal_sums(set, others);
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const Eigen::Map<const VectorXcd> frf(set.channels[o].frf.data(), static_cast<Index>(set.lines.count));
      VectorXcd y = frf.segment(static_cast<Index>(first_), static_cast<Index>(count_));
      if (!others.empty()) y -= sums[o].segment(static_cast<Index>(first_), static_cast<Index>(count_));
      measured_.push_back(std::move(y));
    }
    const PointColumns columns(pole, set, first_, count_);
    const MatrixXd background = orthonormal_polynomials(static_cast<Index>(count_), kBackgroundTerms);
    for (const PointForce& point : set.points) {
      const ModeColumn column = columns.at(point);
      MatrixXcd x(static_cast<Index>(count_), 2 + kBackgroundTerms);
      x << column.value, column.by_freq, background.cast<Complex>();
      const VectorXcd size = x.colwise().norm().transpose().cast<Complex>();
      const MatrixXcd unit = x * size.cwiseInverse().asDiagonal();
      const MatrixXcd inverse = size.cwiseInverse().asDiagonal() * inverse_gram(MatrixXcd(unit.adjoint() * unit));
      solve_.emplace_back(inverse * unit.adjoint());
      variance_.push_back((inverse * size.cwiseInverse().asDiagonal()).diagonal().real());
      columns_.push_back(std::move(x));
    }
  }

  bool determined() const { return static_cast<Index>(count_) > 2 * (2 + kBackgroundTerms); }

  struct Change {
    MatrixXcd a, b;         // [points, channels]
    MatrixXd a_var, b_var;  // of the complex values
  };
  // The change of Σ_r A_r and of Σ_r A_r δ_r from the modes A_r at the poles p + δ_r, with δ in Hz.
  Change change(const ResidueMatrix& at, const std::array<MatrixXcd, 2>& residues, const Pair& shift_Hz) const {
    const auto rows = at.value.rows(), columns = at.value.cols();
    Change out{MatrixXcd(rows, columns), MatrixXcd(rows, columns), MatrixXd(rows, columns), MatrixXd(rows, columns)};
    std::vector<PointValues> modes;
    for (const Complex& shift : shift_Hz) modes.emplace_back(shifted(shift), set_, first_, count_);
    std::vector<Complex> work;
    for (std::size_t o = 0; o < measured_.size(); ++o) {
      const std::size_t p = set_.channels[o].point;
      const auto [row, column] = at.place[o];
      VectorXcd y = measured_[o];
      for (std::size_t r = 0; r < modes.size(); ++r) {
        const std::span<const Complex> phi = modes[r].at(set_.points[p], work);
        y -= residues[r](row, column) * Eigen::Map<const VectorXcd>(phi.data(), static_cast<Index>(phi.size()));
      }
      const VectorXcd fit = solve_[p] * y;
      const double left = (y - columns_[p] * fit).squaredNorm() / static_cast<double>(y.size() - fit.size());
      out.a(row, column) = fit(0);
      out.b(row, column) = fit(1);
      out.a_var(row, column) = left * variance_[p](0);
      out.b_var(row, column) = left * variance_[p](1);
    }
    return out;
  }

  // A complex change of the frequency: s = jω(1 + jζ …), so that jδω holds j dω − ω dζ.
  Pole shifted(Complex shift_Hz) const {
    const double freq_Hz = mode_.pole.freq_Hz;
    return {.freq_Hz = freq_Hz + shift_Hz.real(),
            .damping_ratio = mode_.pole.damping_ratio + shift_Hz.imag() / freq_Hz};
  }

 private:
  const FrfDataset& set_;
  const Mode& mode_;
  std::size_t first_ = 0, count_ = 0;
  std::vector<VectorXcd> measured_;         // [FRFs][lines]
  std::vector<MatrixXcd> columns_, solve_;  // [points] and its pseudo-inverse
  std::vector<Eigen::VectorXd> variance_;   // [points] of the unknowns, for noise of variance 1
};

// Two modes from the pencil (B, A), A = Σ φ_r ψ_rᵀ and B = Σ δ_r φ_r ψ_rᵀ within the first two singular vectors of A.
struct PoleShifts {
  Pair shift_Hz;
  std::array<double, 2> std_Hz{};      // of the real part and of the imaginary part
  std::array<MatrixXcd, 2> residues;   // [points, channels]
  std::array<MatrixXd, 2> mixing_std;  // of the residues, from the uncertain separation of the two shapes
  double largest_mixing = 0;           // standard deviation of a share
  double entry_std_Hz = 0;             // of the pencil's elements: of a split that is noise
};

PoleShifts shifts_of(const MatrixXcd& a, const MatrixXcd& b, const MatrixXd& b_var) {
  const Eigen::JacobiSVD<MatrixXcd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const MatrixXcd u = svd.matrixU().leftCols(2), v = svd.matrixV().leftCols(2);
  const Eigen::Vector2d s = svd.singularValues().head(2);
  const Eigen::Vector2cd inverse = s.cwiseInverse().cast<Complex>();
  const Eigen::Matrix2cd pencil = u.adjoint() * b * v * inverse.asDiagonal();
  const Eigen::ComplexEigenSolver<Eigen::Matrix2cd> eigen(pencil);
  const Eigen::Matrix2cd x = eigen.eigenvectors(), back = x.inverse();
  const MatrixXcd points = u * x;                                                                // φ_r
  const MatrixXcd channels = (back * s.cast<Complex>().asDiagonal() * v.adjoint()).transpose();  // ψ_r
  const MatrixXd left = (back * u.adjoint()).cwiseAbs2(), right = (v * inverse.asDiagonal() * x).cwiseAbs2();
  const Eigen::Matrix2d variance = left * b_var * right;  // of the complex elements X⁻¹ K X
  PoleShifts out;
  const std::size_t low = eigen.eigenvalues()(0).real() <= eigen.eigenvalues()(1).real() ? 0 : 1;
  const double apart = std::abs(eigen.eigenvalues()(0) - eigen.eigenvalues()(1));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto r = static_cast<Index>(i == 0 ? low : 1 - low), other = 1 - r;
    out.shift_Hz[i] = eigen.eigenvalues()(r);
    out.std_Hz[i] = std::sqrt(variance(r, r) / 2);
    out.residues[i] = points.col(r) * channels.col(r).transpose();
    const double of_points = std::sqrt(variance(other, r) / 2) / apart,
                 of_channels = std::sqrt(variance(r, other) / 2) / apart;
    out.mixing_std[i] = ((of_points * points.col(other) * channels.col(r).transpose()).cwiseAbs2() +
                         (of_channels * points.col(r) * channels.col(other).transpose()).cwiseAbs2())
                            .cwiseSqrt();
    out.largest_mixing = std::max({out.largest_mixing, of_points * points.col(other).norm() / points.col(r).norm(),
                                   of_channels * channels.col(other).norm() / channels.col(r).norm()});
  }
  const Eigen::Matrix2d entries = u.cwiseAbs2().transpose() * b_var * (v * inverse.asDiagonal()).cwiseAbs2();
  out.entry_std_Hz = std::sqrt(entries.sum() / 2);
  return out;
}

// The linearised fit, repeated from its own result; nothing where it does not settle.
std::optional<PoleShifts> separate(const LinearisedFit& fit, const ResidueMatrix& at, double half_power_Hz) {
  std::array<MatrixXcd, 2> residues;
  residues.fill(MatrixXcd::Zero(at.value.rows(), at.value.cols()));
  Pair shift_Hz{};
  double split_before = 0;
  for (int pass = 0; pass < kPencilPasses; ++pass) {
    const LinearisedFit::Change change = fit.change(at, residues, shift_Hz);
    const MatrixXcd a = residues[0] + residues[1] + change.a;
    const MatrixXcd b = shift_Hz[0] * residues[0] + shift_Hz[1] * residues[1] + change.b;
    PoleShifts found = shifts_of(a, b, change.b_var);
    for (const Complex& shift : found.shift_Hz) {
      const Pole pole = fit.shifted(shift);
      if (!(std::abs(shift) < kMaxSplit * half_power_Hz) || !(pole.damping_ratio > 0)) return std::nullopt;
    }
    const double split = std::abs(found.shift_Hz[1] - found.shift_Hz[0]);
    const bool settled = pass > 0 && std::abs(split - split_before) < kSettled * found.entry_std_Hz;
    if (settled || pass + 1 == kPencilPasses) return found;
    split_before = split;
    residues = found.residues;
    shift_Hz = found.shift_Hz;
  }
  return std::nullopt;
}

bool tells_apart(const PoleShifts& found) {
  const double split = std::abs(found.shift_Hz[1] - found.shift_Hz[0]);
  const double std = std::max(found.entry_std_Hz, std::hypot(found.std_Hz[0], found.std_Hz[1]));
  return split > kMinSplit * std && found.largest_mixing < kMaxMixing;
}

// The mode's row and column of the most significant driving residue.
std::optional<std::pair<Index, Index>> best_driving(const ResidueMatrix& residues, const Mode& mode,
                                                    const std::vector<DrivingPoint>& driving) {
  std::optional<std::pair<Index, Index>> best;
  double most = kSignificant;
  for (const DrivingPoint& at : driving) {
    const Residue* r = find_residue(mode, at.point, at.channel);
    if (r == nullptr || !(at.sign * r->value.real() > most * total_std(*r))) continue;
    most = total_std(*r) > 0 ? at.sign * r->value.real() / total_std(*r) : most;
    best = {static_cast<Index>(at.point), static_cast<Index>(at.channel)};
  }
  return best && best->first < residues.value.rows() ? best : std::nullopt;
}

struct RankOneParts {
  std::array<MatrixXcd, 2> value;
  std::array<MatrixXd, 2> std;
};

// A¹ = A_pd A_dc/A_dd and A² = A − A¹, with the errors of the three factors.
RankOneParts parts_by_driving_point(const ResidueMatrix& all, Index row, Index column) {
  const Complex pivot = all.value(row, column);
  const VectorXcd down = all.value.col(column), across = all.value.row(row).transpose();
  RankOneParts out;
  out.value[0] = down * across.transpose() / pivot;
  out.value[1] = all.value - out.value[0];
  const MatrixXd by_down = all.std.col(column) * (across.cwiseAbs() / std::abs(pivot)).transpose();
  const MatrixXd by_across = (down.cwiseAbs() / std::abs(pivot)) * all.std.row(row);
  const MatrixXd by_pivot = out.value[0].cwiseAbs() * (all.std(row, column) / std::abs(pivot));
  out.std[0] = (by_down.cwiseAbs2() + by_across.cwiseAbs2() + by_pivot.cwiseAbs2()).cwiseSqrt();
  // Exact by definition: their errors cancel.
  out.std[0].col(column) = all.std.col(column);
  out.std[0].row(row) = all.std.row(row);
  out.std[1] = (out.std[0].cwiseAbs2() + all.std.cwiseAbs2()).cwiseSqrt();
  out.value[1].col(column).setZero();
  out.value[1].row(row).setZero();
  return out;
}

RankOneParts parts_by_singular_vectors(const ResidueMatrix& all) {
  const Eigen::JacobiSVD<MatrixXcd> svd(all.value, Eigen::ComputeThinU | Eigen::ComputeThinV);
  RankOneParts out;
  out.value[0] = svd.singularValues()(0) * svd.matrixU().col(0) * svd.matrixV().col(0).adjoint();
  out.value[1] = all.value - out.value[0];
  out.std = {all.std, all.std};
  return out;
}

Mode with_residues(const Mode& mode, const ResidueMatrix& at, const MatrixXcd& value, const MatrixXd& std) {
  Mode out = mode;
  for (std::size_t o = 0; o < out.residues.size(); ++o) {
    const auto [row, column] = at.place[o];
    out.residues[o].value = value(row, column);
    out.residues[o].std = std(row, column);
    out.residues[o].own_pole.reset();
  }
  return out;
}

// Adds a frequency error of `split_Hz`, and the damping error that belongs to it, to the standard deviations: one pole
// does not resolve the two modes.
void add_split(Mode& mode, double split_Hz) {
  const auto widen = [](double& std, double& noise, double more) {
    noise = std::hypot(noise, more);
    std = std::hypot(std, more);
  };
  widen(mode.freq_std_Hz, mode.freq_std_parts_Hz.noise, split_Hz);
  widen(mode.damping_std, mode.damping_std_parts.noise, split_Hz / mode.pole.freq_Hz);
}

RepeatedPair unresolved(const ResidueMatrix& residues, const Mode& mode, const std::vector<DrivingPoint>& driving,
                        double split_Hz) {
  const auto at = best_driving(residues, mode, driving);
  const RankOneParts parts =
      at ? parts_by_driving_point(residues, at->first, at->second) : parts_by_singular_vectors(residues);
  RepeatedPair out{.first = with_residues(mode, residues, parts.value[0], parts.std[0]),
                   .second = with_residues(mode, residues, parts.value[1], parts.std[1])};
  out.split_std_Hz = split_Hz;
  for (Mode* one : {&out.first, &out.second}) add_split(*one, 0.5 * split_Hz);
  return out;
}

RepeatedPair resolved(const LinearisedFit& fit, const ResidueMatrix& residues, const Mode& mode,
                      const PoleShifts& found) {
  RepeatedPair out{.first = {}, .second = {}, .resolved = true};
  std::array<Mode*, 2> modes{&out.first, &out.second};
  for (std::size_t r = 0; r < modes.size(); ++r) {
    const MatrixXd std = (residues.std.cwiseAbs2() + found.mixing_std[r].cwiseAbs2()).cwiseSqrt();
    Mode& one = *modes[r];
    one = with_residues(mode, residues, found.residues[r], std);
    one.pole = fit.shifted(found.shift_Hz[r]);
    // The split explains the scatter of the single pole's frequency between the points and between the hits.
    const double split_Hz = found.shift_Hz[1].real() - found.shift_Hz[0].real();
    if (one.freq_scatter_Hz < split_Hz) one.freq_scatter_Hz = 0;
    one.joint_misfit = 0;
    add_split(one, found.std_Hz[r]);
  }
  out.split_Hz = out.second.pole.freq_Hz - out.first.pole.freq_Hz;
  out.split_std_Hz = std::hypot(found.std_Hz[0], found.std_Hz[1]);
  return out;
}

bool has_close_neighbour(const std::vector<Mode>& modes, std::size_t m) {
  const Pole& own = modes[m].pole;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i != m && std::abs(modes[i].pole.freq_Hz - own.freq_Hz) < kOwnMode * own.half_power_Hz()) return true;
  }
  return false;
}

}  // namespace

bool RankTest::two_modes() const { return deviate > kOnceIn300000 && second_singular > kMinSecondSingular; }

RankTest test_rank(const Mode& mode) {
  const RankOneResidual rest = rank_one_residual(mode);
  RankTest out{.chi2 = rest.chi2, .freedom = rest.freedom, .second_singular = rest.second_singular};
  if (out.freedom > 0) out.deviate = chi2_deviate(out.chi2, out.freedom);
  return out;
}

std::optional<RepeatedPair> repeated_pair(const FrfDataset& set, const std::vector<Mode>& modes, std::size_t m,
                                          const std::vector<DrivingPoint>& driving) {
  const Mode& mode = modes[m];
  if (!test_rank(mode).two_modes() || has_close_neighbour(modes, m)) return std::nullopt;
  const std::optional<ResidueMatrix> residues = matrix_of(set, mode);
  if (!residues) return std::nullopt;
  const double half_power_Hz = mode.pole.half_power_Hz();
  const LinearisedFit fit(set, modes, m);
  std::optional<PoleShifts> found;
  if (fit.determined()) found = separate(fit, *residues, half_power_Hz);
  if (found && tells_apart(*found)) return resolved(fit, *residues, mode, *found);
  const double split_Hz =
      found ? std::hypot(std::abs(found->shift_Hz[1] - found->shift_Hz[0]), found->entry_std_Hz) : half_power_Hz;
  return unresolved(*residues, mode, driving, split_Hz);
}

}  // namespace percuss::identify
