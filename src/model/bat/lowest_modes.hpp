#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace percuss::model {

/// Solutions of K q = ω² M q, lowest first.
struct LowestModes {
  Eigen::VectorXd square;  // ω², [modes]
  Eigen::MatrixXd shape;   // [unknowns, modes], shape_r · M · shape_s = 1 for r = s, else 0
};

/// Computes the lowest `count` elastic modes of a structure (all of them where there are fewer). Its rigid-body modes
/// are given. Lanczos's method on (K + shift M)⁻¹ M keeps all vectors M-orthogonal, to each other and to the
/// rigid-body modes. It continues until the residuals reach rounding. The cost of a step is proportional to the
/// entries of K, so K should have a narrow band.
/// shapes  K, M [n, n] symmetric, M positive definite; rigid [n, k], orthonormal in M
/// shift   (rad/s)², above 0, of the order of the lowest ω²
/// errors  InputError where K + shift M is not positive definite, or where rounding hides the modes.
LowestModes lowest_modes(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass,
                         const Eigen::MatrixXd& rigid, double shift, Eigen::Index count);

}  // namespace percuss::model
