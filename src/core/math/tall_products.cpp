#include "core/math/tall_products.hpp"

#include <cstring>

#include "core/math/wide_loops.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss {
inline namespace core {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

const double* parts_of(const Complex* z) { return reinterpret_cast<const double*>(z); }

// Σ conj(a)·b. Four independent sums each, because an addition to a sum waits for the one before it.
PERCUSS_WIDE_LOOPS Complex dot_conj(const Complex* a, const Complex* b, Index n) {
  FourDoubles straight{}, crossed{}, x{}, y{};
  Index i = 0;
  for (; i + 1 < n; i += 2) {
    std::memcpy(&x, a + i, sizeof(x));
    std::memcpy(&y, b + i, sizeof(y));
    straight += x * y;
    crossed += x * __builtin_shufflevector(y, y, 1, 0, 3, 2);
  }
  if (i < n) {
    x = FourDoubles{a[i].real(), a[i].imag()};
    straight += x * FourDoubles{b[i].real(), b[i].imag()};
    crossed += x * FourDoubles{b[i].imag(), b[i].real()};
  }
  return {straight[0] + straight[2] + (straight[1] + straight[3]), crossed[0] + crossed[2] - (crossed[1] + crossed[3])};
}

PERCUSS_WIDE_LOOPS Complex dot_real(const double* a, const Complex* b, Index n) {
  FourDoubles sum{}, y{};
  Index i = 0;
  for (; i + 1 < n; i += 2) {
    std::memcpy(&y, b + i, sizeof(y));
    sum += FourDoubles{a[i], a[i], a[i + 1], a[i + 1]} * y;
  }
  if (i < n) sum += a[i] * FourDoubles{b[i].real(), b[i].imag()};
  return {sum[0] + sum[2], sum[1] + sum[3]};
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

PERCUSS_WIDE_LOOPS void add_scaled(Complex* to, double factor, const Complex* column, std::size_t count) {
  auto* sum = reinterpret_cast<double*>(to);
  const double* c = parts_of(column);
  for (std::size_t k = 0; k < 2 * count; ++k) sum[k] += factor * c[k];
}

PERCUSS_WIDE_LOOPS void add_scaled(Complex* to, Complex factor, const double* column, std::size_t count) {
  auto* sum = reinterpret_cast<double*>(to);
  const double re = factor.real(), im = factor.imag();
  for (std::size_t k = 0; k < count; ++k) {
    sum[2 * k] += column[k] * re;
    sum[2 * k + 1] += column[k] * im;
  }
}

PERCUSS_WIDE_LOOPS void add_scaled(Complex* to, Complex factor, const Complex* column, std::size_t count) {
  auto* sum = reinterpret_cast<double*>(to);
  const double* c = parts_of(column);
  const double re = factor.real(), im = factor.imag();
  for (std::size_t k = 0; k < count; ++k) {
    sum[2 * k] += c[2 * k] * re - c[2 * k + 1] * im;
    sum[2 * k + 1] += c[2 * k] * im + c[2 * k + 1] * re;
  }
}

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
    for (Index i = 0; i < columns.cols(); ++i)
      add_scaled(from.col(j).data(), -factors(i, j), columns.col(i).data(), static_cast<std::size_t>(from.rows()));
  });
}

void subtract_product(MatrixXcd& from, const MatrixXd& columns, const MatrixXcd& factors) {
  over_columns(from, columns.cols(), [&](Index j) {
    for (Index i = 0; i < columns.cols(); ++i)
      add_scaled(from.col(j).data(), -factors(i, j), columns.col(i).data(), static_cast<std::size_t>(from.rows()));
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
      for (Index i = 0; i < columns.cols(); ++i)
        add_scaled(left.data(), -shares(i), columns.col(i).data(), static_cast<std::size_t>(left.size()));
    }
  });
  return fit;
}

}  // namespace core
}  // namespace percuss
