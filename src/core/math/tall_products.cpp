#include "core/math/tall_products.hpp"

#include "core/parallel/parallel.hpp"

namespace percuss {
inline namespace core {
namespace {

using Complex = std::complex<double>;
using Eigen::Array2d;
using Eigen::Index;
using Eigen::Map;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// Σ conj(a)·b in two independent sums over alternate elements, because each addition to one sum waits for the previous
// one.
Complex dot_conj(const Complex* a, const Complex* b, Index n) {
  const auto at = [](const Complex* z, Index i) { return Map<const Array2d>(reinterpret_cast<const double*>(z + i)); };
  Array2d straight = Array2d::Zero(), crossed = Array2d::Zero(), straight2 = Array2d::Zero(),
          crossed2 = Array2d::Zero();
  Index i = 0;
  for (; i + 1 < n; i += 2) {
    const Array2d x = at(a, i), y = at(b, i), x2 = at(a, i + 1), y2 = at(b, i + 1);
    straight += x * y;
    crossed += x * y.reverse();
    straight2 += x2 * y2;
    crossed2 += x2 * y2.reverse();
  }
  if (i < n) {
    const Array2d x = at(a, i), y = at(b, i);
    straight += x * y;
    crossed += x * y.reverse();
  }
  straight += straight2;
  crossed += crossed2;
  return {straight[0] + straight[1], crossed[0] - crossed[1]};
}

Complex dot_real(const double* a, const Complex* b, Index n) {
  Array2d sum = Array2d::Zero(), sum2 = Array2d::Zero();
  Index i = 0;
  for (; i + 1 < n; i += 2) {
    sum += a[i] * Map<const Array2d>(reinterpret_cast<const double*>(b + i));
    sum2 += a[i + 1] * Map<const Array2d>(reinterpret_cast<const double*>(b + i + 1));
  }
  if (i < n) sum += a[i] * Map<const Array2d>(reinterpret_cast<const double*>(b + i));
  sum += sum2;
  return {sum[0], sum[1]};
}

// task(j) for every column of `matrix`; `others` columns are multiplied with each.
template <class Task>
void over_columns(const MatrixXcd& matrix, Index others, const Task& task) {
  constexpr Index kPerElement = 8;  // flops of a complex product and a sum
  parallel_for_cost(static_cast<std::size_t>(matrix.cols()),
                    static_cast<std::size_t>(kPerElement * matrix.rows() * others),
                    [&](std::size_t j) { task(static_cast<Index>(j)); });
}

}  // namespace

MatrixXcd adjoint_product(const MatrixXcd& left, const MatrixXcd& right) {
  MatrixXcd out(left.cols(), right.cols());
  over_columns(right, left.cols(), [&](Index j) {
    for (Index i = 0; i < left.cols(); ++i) out(i, j) = dot_conj(left.col(i).data(), right.col(j).data(), left.rows());
  });
  return out;
}

Complex adjoint_dot(const Eigen::VectorXcd& left, const Eigen::VectorXcd& right, Index first) {
  return dot_conj(left.data(), right.data() + first, left.size());
}

MatrixXcd adjoint_gram(const MatrixXcd& columns) {
  MatrixXcd out(columns.cols(), columns.cols());
  for (Index j = 0; j < columns.cols(); ++j) {
    out(j, j) = columns.col(j).squaredNorm();
    for (Index i = 0; i < j; ++i) {
      out(i, j) = dot_conj(columns.col(i).data(), columns.col(j).data(), columns.rows());
      out(j, i) = std::conj(out(i, j));
    }
  }
  return out;
}

MatrixXcd transposed_product(const MatrixXd& left, const MatrixXcd& right) {
  MatrixXcd out(left.cols(), right.cols());
  over_columns(right, left.cols(), [&](Index j) {
    for (Index i = 0; i < left.cols(); ++i) out(i, j) = dot_real(left.col(i).data(), right.col(j).data(), left.rows());
  });
  return out;
}

void subtract_product(MatrixXcd& from, const MatrixXcd& columns, const MatrixXcd& factors) {
  over_columns(from, columns.cols(), [&](Index j) {
    for (Index i = 0; i < columns.cols(); ++i) from.col(j) -= columns.col(i) * factors(i, j);
  });
}

void subtract_product(MatrixXcd& from, const MatrixXd& columns, const MatrixXcd& factors) {
  over_columns(from, columns.cols(), [&](Index j) {
    for (Index i = 0; i < columns.cols(); ++i) {
      const Array2d factor(factors(i, j).real(), factors(i, j).imag());
      const double* c = columns.col(i).data();
      auto* to = reinterpret_cast<double*>(from.col(j).data());
      for (Index k = 0; k < from.rows(); ++k) Map<Array2d>(to + 2 * k) -= c[k] * factor;
    }
  });
}

ColumnFit fit_columns(const MatrixXcd& columns, const MatrixXcd& inverse_gram, const MatrixXcd& data,
                      const std::vector<std::size_t>& outputs) {
  constexpr Index kPasses = 2;  // the normal equations alone lose half the digits
  const auto count = static_cast<Index>(outputs.size());
  ColumnFit fit{.amplitude = MatrixXcd::Zero(columns.cols(), count), .residual = MatrixXcd(columns.rows(), count)};
  over_columns(fit.residual, 2 * kPasses * columns.cols(), [&](Index j) {
    auto left = fit.residual.col(j);
    left = data.col(static_cast<Index>(outputs[static_cast<std::size_t>(j)]));
    for (Index pass = 0; pass < kPasses; ++pass) {
      Eigen::VectorXcd shares(columns.cols());
      for (Index i = 0; i < columns.cols(); ++i) shares(i) = dot_conj(columns.col(i).data(), left.data(), left.size());
      shares = inverse_gram.lazyProduct(shares).eval();
      fit.amplitude.col(j) += shares;
      for (Index i = 0; i < columns.cols(); ++i) left -= columns.col(i) * shares(i);
    }
  });
  return fit;
}

}  // namespace core
}  // namespace percuss
