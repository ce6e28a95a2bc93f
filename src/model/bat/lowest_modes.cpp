#include "model/bat/lowest_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/budget.hpp"
#include "core/error.hpp"

namespace percuss::model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>>;

constexpr double kSettledResidual = 1e-12;  // of a mode's own 1/(ω² + shift)
constexpr double kExhausted = 1e-14;        // of the largest diagonal entry: a shorter new direction is rounding
constexpr Index kFirstVectors = 40;         // plus two per mode
constexpr const char* kRemedyForNumbers = "check the units of profile and material";

// Krylov vectors, and the operator projected on them: a tridiagonal matrix.
class Lanczos {
 public:
  Lanczos(const Factors& factors, const Sparse& mass, const MatrixXd& rigid)
      : factors_(factors),
        mass_(mass),
        rigid_(rigid),
        mass_rigid_(mass * rigid),
        max_vectors_(mass.rows() - rigid.cols()) {
    // The start must not be orthogonal to any mode: this one has no symmetry.
    VectorXd start(mass.rows());
    for (Index i = 0; i < start.size(); ++i) start[i] = 1 + std::sin(1.7 * static_cast<double>(i * i));
    next_ = orthogonal_to_known(start);
    next_ /= std::sqrt(next_.dot(mass_ * next_));
  }

  bool is_complete() const { return size() == max_vectors_ || exhausted_; }
  Index size() const { return vectors_.cols(); }

  void grow_to(Index wanted) {
    wanted = std::min(wanted, max_vectors_);
    Index at = size();
    vectors_.conservativeResize(mass_.rows(), wanted);
    mass_vectors_.conservativeResize(mass_.rows(), wanted);
    diagonal_.conservativeResize(wanted);
    off_diagonal_.conservativeResize(wanted);
    for (; at < wanted && !exhausted_; ++at) {
      check_budget();
      known_ = at + 1;
      vectors_.col(at) = next_;
      mass_vectors_.col(at) = mass_ * next_;
      const VectorXd image = factors_.solve(mass_vectors_.col(at));
      diagonal_[at] = image.dot(mass_vectors_.col(at));
      next_ = orthogonal_to_known(image);
      off_diagonal_[at] = std::sqrt(next_.dot(mass_ * next_));
      exhausted_ = !(off_diagonal_[at] > kExhausted * diagonal_.head(known_).maxCoeff());
      next_ /= off_diagonal_[at];
    }
    vectors_.conservativeResize(Eigen::NoChange, at);
    diagonal_.conservativeResize(at);
    off_diagonal_.conservativeResize(at);
  }

  // Solves for the lowest `count` modes in the span of the vectors. False when a residual is too large.
  bool solve(Index count, double shift, LowestModes& modes) const {
    Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal_, off_diagonal_.head(size() - 1));
    count = std::min(count, size());
    const VectorXd values = solver.eigenvalues().tail(count).reverse();
    const MatrixXd mixes = solver.eigenvectors().rightCols(count).rowwise().reverse();
    if (!is_complete() && !((mixes.bottomRows(1).transpose().array().abs() * off_diagonal_[size() - 1]) <=
                            kSettledResidual * values.array().abs())
                               .all()) {
      return false;
    }
    modes.square = values.cwiseInverse().array() - shift;
    modes.shape = vectors_ * mixes;
    return true;
  }

 private:
  // Orthogonalises twice: the second pass removes the rounding errors of the first.
  VectorXd orthogonal_to_known(VectorXd x) const {
    for (int i = 0; i < 2; ++i) {
      x -= rigid_ * (mass_rigid_.transpose() * x);
      if (known_ > 0) x -= vectors_.leftCols(known_) * (mass_vectors_.leftCols(known_).transpose() * x);
    }
    return x;
  }

  const Factors& factors_;
  const Sparse& mass_;
  const MatrixXd& rigid_;
  MatrixXd mass_rigid_, vectors_, mass_vectors_;
  VectorXd diagonal_, off_diagonal_, next_;
  Index max_vectors_, known_ = 0;
  bool exhausted_ = false;
};

}  // namespace

LowestModes lowest_modes(const Sparse& stiffness, const Sparse& mass, const MatrixXd& rigid, double shift,
                         Index count) {
  const Factors factors(stiffness + shift * mass);
  if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0))
    throw InputError("stiffness and mass differ by too many decades", "finite elements", kRemedyForNumbers);
  Lanczos lanczos(factors, mass, rigid);
  LowestModes modes;
  for (Index size = 2 * count + kFirstVectors;; size *= 2) {
    lanczos.grow_to(size);
    if (lanczos.solve(count, shift, modes)) break;
  }
  if (!modes.shape.allFinite() || !(modes.square.minCoeff() > 0))
    throw InputError("rounding hides the modes", "finite elements", kRemedyForNumbers);
  return modes;
}

}  // namespace percuss::model
