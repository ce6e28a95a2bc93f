#pragma once
#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace percuss {
inline namespace core {

// Products of tall matrices with few columns. Eigen's general product copies both factors into blocks first, which
// takes longer than the product of such matrices.

/// leftᴴ·right. shapes: left [n, a], right [n, b], result [a, b].
Eigen::MatrixXcd adjoint_product(const Eigen::MatrixXcd& left, const Eigen::MatrixXcd& right);

/// leftᴴ·right[first … first + left.size() − 1].
std::complex<double> adjoint_dot(const Eigen::VectorXcd& left, const Eigen::VectorXcd& right, Eigen::Index first = 0);

/// columnsᴴ·columns. shapes: columns [n, a], result [a, a].
Eigen::MatrixXcd adjoint_gram(const Eigen::MatrixXcd& columns);

/// leftᵀ·right. shapes: left [n, a], right [n, b], result [a, b].
Eigen::MatrixXcd transposed_product(const Eigen::MatrixXd& left, const Eigen::MatrixXcd& right);
Eigen::MatrixXd tall_transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& left,
                                        const Eigen::Ref<const Eigen::MatrixXd>& right);

/// columns·factors. shapes: columns [n, a], factors [a, b], result [n, b].
Eigen::MatrixXd tall_product(const Eigen::Ref<const Eigen::MatrixXd>& columns,
                             const Eigen::Ref<const Eigen::MatrixXd>& factors);

/// from −= columns·factors. shapes: from [n, b], columns [n, a], factors [a, b].
void subtract_product(Eigen::MatrixXcd& from, const Eigen::MatrixXcd& columns, const Eigen::MatrixXcd& factors);
void subtract_product(Eigen::MatrixXcd& from, const Eigen::MatrixXd& columns, const Eigen::MatrixXcd& factors);

/// to += factor · column. shapes: to [count], column [count].
void add_scaled(std::complex<double>* to, std::complex<double> factor, const std::complex<double>* column,
                std::size_t count);

struct ColumnFit {
  Eigen::MatrixXcd amplitude;  // [a, outputs]
  Eigen::MatrixXcd residual;   // [n, outputs]
};

/// Least-squares fit of `columns` to the columns `outputs` of `data`. Each column of `data` is finished while it is in
/// the cache.
/// shapes: columns [n, a], inverse_gram (columnsᴴ·columns)⁻¹, data [n, …].
ColumnFit fit_columns(const Eigen::MatrixXcd& columns, const Eigen::MatrixXcd& inverse_gram,
                      const Eigen::MatrixXcd& data, const std::vector<std::size_t>& outputs);

}  // namespace core
}  // namespace percuss
