#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace percuss::model {

/// Solutions of K q = ω² M q, the lowest first.
struct LowestModes {
  Eigen::VectorXd square;  // ω², [modes]
  Eigen::MatrixXd shape;   // [unknowns, modes], shape_r · M · shape_s = 1 for r = s, else 0
};

/// The lowest `count` modes (fewer where there are fewer) of a structure beside its `rigid` ones, which cost no energy
/// and are given: Lanczos's method on (K + shift M)⁻¹ M with all vectors kept orthogonal in M, among themselves and to
/// the rigid ones; continued until the residuals are at rounding. For narrow bands: a step costs as much as K has
/// entries. shapes: K, M [n, n] symmetric, M positive; rigid [n, k], orthonormal in M. shift (rad/s)² above 0, of the
/// order of the lowest ω². errors  InputError where K + shift M is not positive or the method does not settle.
LowestModes lowest_modes(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass,
                         const Eigen::MatrixXd& rigid, double shift, Eigen::Index count);

}  // namespace percuss::model
