#include "core/math/tall_products.hpp"

#include <algorithm>
#include <array>
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

// Σ conj(a)·b. `straight` and `crossed` hold four independent sums each, because an addition to a sum waits for the one
// before it.
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

constexpr Index kLeft = 3, kRight = 4;  // columns per tile: their sums stay in registers

double total(const FourDoubles& sum) { return sum[0] + sum[1] + (sum[2] + sum[3]); }

// dots[i][j] = Σ left[i]·right[j] of n numbers. Each sum is a variable: the compiler would keep an array in memory.
PERCUSS_WIDE_LOOPS void dot_tile(const std::array<const double*, kLeft>& left,
                                 const std::array<const double*, kRight>& right, Index n,
                                 std::array<double, kLeft * kRight>& dots) {
  FourDoubles a0{}, a1{}, a2{}, b0{}, b1{}, b2{}, c0{}, c1{}, c2{}, d0{}, d1{}, d2{}, x0{}, x1{}, x2{};
  Index k = 0;
  for (; k + 3 < n; k += 4) {
    std::memcpy(&x0, left[0] + k, sizeof(x0));
    std::memcpy(&x1, left[1] + k, sizeof(x1));
    std::memcpy(&x2, left[2] + k, sizeof(x2));
    const auto add = [&](const double* column, FourDoubles& sum0, FourDoubles& sum1, FourDoubles& sum2) {
      FourDoubles y{};
      std::memcpy(&y, column + k, sizeof(y));
      sum0 += x0 * y;
      sum1 += x1 * y;
      sum2 += x2 * y;
    };
    add(right[0], a0, a1, a2);
    add(right[1], b0, b1, b2);
    add(right[2], c0, c1, c2);
    add(right[3], d0, d1, d2);
  }
  dots = {total(a0), total(b0), total(c0), total(d0), total(a1), total(b1),
          total(c1), total(d1), total(a2), total(b2), total(c2), total(d2)};
  for (std::size_t i = 0; i < dots.size(); ++i) {
    for (Index at = k; at < n; ++at) dots[i] += left[i / kRight][at] * right[i % kRight][at];
  }
}

constexpr Index kStrip = 8;  // rows of a strip of a product

// out[j][0 … kStrip) = Σ_i columns[i·stride …]·factors[j][i], for kRight columns of the result.
PERCUSS_WIDE_LOOPS void product_tile(const double* columns, Index stride, Index count,
                                     const std::array<const double*, kRight>& factors,
                                     const std::array<double*, kRight>& out) {
  FourDoubles a0{}, a1{}, b0{}, b1{}, c0{}, c1{}, d0{}, d1{}, x0{}, x1{};
  for (Index i = 0; i < count; ++i) {
    std::memcpy(&x0, columns + i * stride, sizeof(x0));
    std::memcpy(&x1, columns + i * stride + 4, sizeof(x1));
    a0 += factors[0][i] * x0;
    a1 += factors[0][i] * x1;
    b0 += factors[1][i] * x0;
    b1 += factors[1][i] * x1;
    c0 += factors[2][i] * x0;
    c1 += factors[2][i] * x1;
    d0 += factors[3][i] * x0;
    d1 += factors[3][i] * x1;
  }
  const auto store = [](double* to, const FourDoubles& first, const FourDoubles& second) {
    std::memcpy(to, &first, sizeof(first));
    std::memcpy(to + 4, &second, sizeof(second));
  };
  store(out[0], a0, a1);
  store(out[1], b0, b1);
  store(out[2], c0, c1);
  store(out[3], d0, d1);
}

// The columns first … first + N − 1 of a matrix; beyond the last column, the last one again.
template <std::size_t N, class Matrix>
auto columns_of(Matrix& matrix, Index first) {
  std::array<decltype(matrix.data()), N> columns;
  for (std::size_t i = 0; i < N; ++i)
    columns[i] = matrix.data() + std::min(first + static_cast<Index>(i), matrix.cols() - 1) * matrix.outerStride();
  return columns;
}

// to += factor · column.
PERCUSS_WIDE_LOOPS void add_scaled(Complex* to, Complex factor, const double* column, std::size_t count) {
  auto* sum = reinterpret_cast<double*>(to);
  const double re = factor.real(), im = factor.imag();
  for (std::size_t k = 0; k < count; ++k) {
    sum[2 * k] += column[k] * re;
    sum[2 * k + 1] += column[k] * im;
  }
}

// task(j) for every column of `matrix`; `others` columns are multiplied with each.
template <class Task>
void over_columns(const MatrixXcd& matrix, Index others, const Task& task) {
  constexpr Index kFlopsPerElement = 8;  // flops of a complex product and a sum
  parallel_for_cost(static_cast<std::size_t>(matrix.cols()),
                    static_cast<std::size_t>(kFlopsPerElement * matrix.rows() * others),
                    [&](std::size_t j) { task(static_cast<Index>(j)); });
}

}  // namespace

PERCUSS_WIDE_LOOPS void add_scaled(Complex* to, Complex factor, const Complex* column, std::size_t count) {
  const double re = factor.real(), im = factor.imag();
  const FourDoubles turn{-im, im, -im, im};
  auto* sums = reinterpret_cast<double*>(to);
  FourDoubles x{}, sum{};
  std::size_t k = 0;
  for (; k + 1 < count; k += 2) {
    std::memcpy(&x, column + k, sizeof(x));
    std::memcpy(&sum, sums + 2 * k, sizeof(sum));
    sum += x * re + __builtin_shufflevector(x, x, 1, 0, 3, 2) * turn;
    std::memcpy(sums + 2 * k, &sum, sizeof(sum));
  }
  if (k < count) {
    const Complex last = column[k];
    to[k] += Complex(last.real() * re - last.imag() * im, last.imag() * re + last.real() * im);
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

MatrixXd tall_transposed_product(const Eigen::Ref<const MatrixXd>& left, const Eigen::Ref<const MatrixXd>& right) {
  MatrixXd out(left.cols(), right.cols());
  std::array<double, kLeft * kRight> dots{};
  for (Index j = 0; j < right.cols(); j += kRight) {
    for (Index i = 0; i < left.cols(); i += kLeft) {
      dot_tile(columns_of<kLeft>(left, i), columns_of<kRight>(right, j), left.rows(), dots);
      const Index height = std::min(kLeft, left.cols() - i), width = std::min(kRight, right.cols() - j);
      using Dots = Eigen::Matrix<double, kLeft, kRight, Eigen::RowMajor>;
      out.block(i, j, height, width) = Eigen::Map<const Dots>(dots.data()).topLeftCorner(height, width);
    }
  }
  return out;
}

MatrixXd tall_product(const Eigen::Ref<const MatrixXd>& columns, const Eigen::Ref<const MatrixXd>& factors) {
  if (columns.cols() == 0) return MatrixXd::Zero(columns.rows(), factors.cols());  // no data to point into
  MatrixXd out(columns.rows(), factors.cols());
  const Index whole = columns.rows() / kStrip * kStrip;
  for (Index row = 0; row < whole; row += kStrip) {
    for (Index j = 0; j < out.cols(); j += kRight) {
      auto to = columns_of<kRight>(out, j);
      for (double*& at : to) at += row;
      product_tile(columns.data() + row, columns.outerStride(), columns.cols(), columns_of<kRight>(factors, j), to);
    }
  }
  for (Index row = whole; row < columns.rows(); ++row) {
    for (Index j = 0; j < out.cols(); ++j) {
      double sum = 0;  // in the order of a tile, so that a row gives the same bits in any strip
      for (Index i = 0; i < columns.cols(); ++i) sum += factors(i, j) * columns(row, i);
      out(row, j) = sum;
    }
  }
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
