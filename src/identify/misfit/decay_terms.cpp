#include "identify/misfit/decay_terms.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "core/math/complex.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/model/point_columns.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMinGain = 14;        // F statistic of a term's two unknowns: by chance in one of a million modes
constexpr double kMinExplained = 0.5;  // of the smooth residual: else the term only follows some other misfit
constexpr double kDifference = 0.1;    // half-power bandwidths, for the second derivative

// How the pole changes during the decay: with the remaining amplitude, or with time.
enum class Term { with_amplitude, with_time };

// The columns of the extra terms of a mode at any point, for a residue of 1.
class TermColumns {
 public:
  TermColumns(const FrfDataset& set, const ModeWindow& window, const Pole& pole)
      : width_Hz_(pole.half_power_Hz()),
        faster_({.freq_Hz = pole.freq_Hz, .damping_ratio = 2 * pole.damping_ratio}, set, window.first, window.count),
        below_(shifted(pole, -kDifference), set, window.first, window.count),
        above_(shifted(pole, kDifference), set, window.first, window.count) {}
  VectorXcd with_amplitude(const PointForce& force) const {
    std::vector<Complex> work;
    const auto value = faster_.at(force, work);
    return Eigen::Map<const VectorXcd>(value.data(), static_cast<Index>(value.size()));
  }
  VectorXcd with_time(const PointForce& force) const {
    return (above_.at(force).by_freq - below_.at(force).by_freq) * width_Hz_;
  }

 private:
  static Pole shifted(const Pole& pole, double half_power_bandwidths) {
    return {.freq_Hz = pole.freq_Hz + half_power_bandwidths * pole.half_power_Hz(),
            .damping_ratio = pole.damping_ratio};
  }

  double width_Hz_;
  PointValues faster_;
  PointColumns below_, above_;
};

// Inner products of a part's regressors: the slopes of its poles, then the two extra terms of each mode. The polynomial
// and the columns of the modes are projected out of the regressors first.
struct PartProducts {
  MatrixXcd gram;   // [slopes + terms, slopes + terms]
  MatrixXcd score;  // with the residual, [slopes + terms, channels]
};

std::vector<PartProducts> products_of(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& poles,
                                      const VariableProjection& projection, const ProjectedState& state) {
  std::vector<TermColumns> terms;
  for (const Pole& pole : poles) terms.emplace_back(set, window, pole);
  std::vector<PartProducts> products;
  for (const ProjectedPart& part : state.parts) {
    const PointForce& force = set.points[set.channels[part.channels.front()].point];
    const auto n = static_cast<Index>(2 * poles.size());
    MatrixXcd slopes(part.slopes.rows(), 2 * n);
    slopes.leftCols(n) = part.slopes;
    for (std::size_t m = 0; m < terms.size(); ++m) {
      slopes.col(n + static_cast<Index>(2 * m)) = terms[m].with_amplitude(force);
      slopes.col(n + static_cast<Index>(2 * m) + 1) = terms[m].with_time(force);
    }
    projection.project_out(part, slopes);
    products.push_back({.gram = adjoint_gram(slopes), .score = adjoint_product(slopes, part.residual)});
  }
  return products;
}

// Normal equations of the poles and of one complex coefficient of a term, whose real and imaginary part are the last
// unknowns.
NormalEquations with_term(const ProjectedState& state, const std::vector<PartProducts>& products, const VectorXd& noise,
                          std::size_t mode, Term term) {
  const Index n = state.parts.front().slopes.cols();
  const Index term_column = n + static_cast<Index>(2 * mode) + (term == Term::with_time ? 1 : 0);
  NormalEquations normal{.matrix = MatrixXd::Zero(n + 2, n + 2), .right = VectorXd::Zero(n + 2)};
  const auto column_of = [&](Index unknown) { return unknown < n ? unknown : term_column; };
  for (std::size_t p = 0; p < products.size(); ++p) {
    const ProjectedPart& part = state.parts[p];
    VectorXcd residue(n + 2);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto channel = static_cast<Index>(i);
      const double w = noise(static_cast<Index>(part.channels[i]));
      for (Index c = 0; c < n; ++c) residue(c) = part.amplitude(c / 2, channel) / w;
      residue(n) = part.amplitude(static_cast<Index>(mode), channel) / w;
      residue(n + 1) = Complex(0, 1) * residue(n);
      for (Index r = 0; r < n + 2; ++r) {
        normal.right(r) += conj_times(residue(r), products[p].score(column_of(r), channel)).real() / w;
        for (Index c = 0; c < n + 2; ++c) {
          const Complex product = times(products[p].gram(column_of(r), column_of(c)), residue(c));
          normal.matrix(r, c) += conj_times(residue(r), product).real();
        }
      }
    }
  }
  return normal;
}

double residual_cost(const ProjectedState& state, const VectorXd& noise) {
  double cost = 0;
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i)
      cost += part.residual.col(static_cast<Index>(i)).squaredNorm() /
              std::pow(noise(static_cast<Index>(part.channels[i])), 2);
  }
  return cost;
}

// The part of the cost that differs from line to line, as noise does: from second differences of the residual.
double noise_cost(const ProjectedState& state, const VectorXd& noise) {
  double cost = 0;
  for (const ProjectedPart& part : state.parts) {
    const Index lines = part.residual.rows() - 2;
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto r = part.residual.col(static_cast<Index>(i));
      const VectorXcd rough = r.segment(1, lines) - 0.5 * (r.head(lines) + r.tail(lines));
      cost += rough.squaredNorm() / (kWhiteRoughness * std::pow(noise(static_cast<Index>(part.channels[i])), 2));
    }
  }
  return cost;
}

}  // namespace

VectorXd decay_term_shift(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& poles,
                          const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise) {
  const auto n = static_cast<Index>(2 * poles.size());
  VectorXd largest = VectorXd::Zero(n);
  const double cost = residual_cost(state, noise);
  const double misfit = std::max(0.0, cost - noise_cost(state, noise));
  const auto terms = static_cast<double>(LocalFitOptions{}.residual_terms);
  const double degrees = 2 * static_cast<double>(noise.size()) *
                         std::max(1.0, static_cast<double>(window.count) - static_cast<double>(poles.size()) - terms);
  const std::vector<PartProducts> products = products_of(set, window, poles, projection, state);
  for (std::size_t m = 0; m < poles.size(); ++m) {
    for (const Term term : std::array{Term::with_amplitude, Term::with_time}) {
      const NormalEquations normal = with_term(state, products, noise, m, term);
      const VectorXd all = inverse_gram(normal.matrix) * normal.right;
      const VectorXd few = inverse_gram(MatrixXd(normal.matrix.topLeftCorner(n, n))) * normal.right.head(n);
      const double gained = all.dot(normal.right) - few.dot(normal.right.head(n));
      const double left = std::max(cost - all.dot(normal.right), 1e-12 * cost);
      if (!(gained > 2 * kMinGain * left / degrees && gained > kMinExplained * misfit)) continue;
      largest = largest.cwiseMax((all.head(n) - few).cwiseAbs());
    }
  }
  return largest;
}

}  // namespace percuss::identify
