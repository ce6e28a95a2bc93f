#include "frf/leave_one_out.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

namespace percuss::frf {
namespace {

using Eigen::Index;

constexpr Index kBlock = 256;              // lines
constexpr Index kMaxComparedLines = 1024;  // lines: enough to tell whether the hits agree
using Block = Eigen::Array<double, Eigen::Dynamic, 1, 0, kBlock, 1>;

// Separate real and imaginary parts, for vector instructions over several lines.
struct Parts {
  Block re, im;
  Block power() const { return re.square() + im.square(); }
};

Parts parts_of(std::span<const Complex> lines, Index first, Index count, Index step) {
  const Eigen::Map<const Eigen::ArrayXcd, 0, Eigen::InnerStride<>> block(lines.data() + first * step, count,
                                                                         Eigen::InnerStride<>(step));
  return {block.real(), block.imag()};
}

// The residual of a response under the other hits' H1 is (a − f·H1)/(1 − |f|²/Σff), with the H1 of all hits. Returns
// the square of 1/(1 − |f|²/Σff), or 0 where only this hit excited the line.
Block leverage_factor(const Block& ff, const Parts& f) {
  const Block others = ff - f.power();
  return (others > 0).select((ff / others).square(), 0);
}

// Energy of the response that the other hits do not explain. Where they cannot predict it, all of it counts.
double unexplained(const Parts& h1, const Block& factor, const Parts& f, const Parts& a) {
  const double left =
      (((a.re - (h1.re * f.re - h1.im * f.im)).square() + (a.im - (h1.re * f.im + h1.im * f.re)).square()) * factor)
          .sum();
  return factor.minCoeff() > 0 ? left : left + (factor > 0).select(0, a.power()).sum();
}

}  // namespace

std::vector<double> leave_one_out_error(std::span<const std::span<const Complex>> force,
                                        std::span<const std::vector<std::span<const Complex>>> accel) {
  const std::size_t hits = force.size();
  std::vector<double> left(hits), all(hits);
  if (hits < 2) return left;
  const auto all_lines = static_cast<Index>(force.front().size());
  const Index step = (all_lines + kMaxComparedLines - 1) / kMaxComparedLines;
  const Index lines = step > 0 ? (all_lines + step - 1) / step : 0;
  std::vector<Parts> f(hits), a(hits);
  std::vector<Block> factor(hits);
  // In blocks of lines, so that the sums over the hits stay in the cache.
  for (Index first = 0; first < lines; first += kBlock) {
    const Index count = std::min(kBlock, lines - first);
    Block ff = Block::Zero(count);
    for (std::size_t h = 0; h < hits; ++h) {
      f[h] = parts_of(force[h], first, count, step);
      ff += f[h].power();
    }
    for (std::size_t h = 0; h < hits; ++h) factor[h] = leverage_factor(ff, f[h]);
    const Block inverse = (ff > 0).select(ff.inverse(), 0);
    for (std::size_t c = 0; c < accel.front().size(); ++c) {
      Parts fa{Block::Zero(count), Block::Zero(count)};  // Σ conj(F) A
      for (std::size_t h = 0; h < hits; ++h) {
        a[h] = parts_of(accel[h][c], first, count, step);
        fa.re += f[h].re * a[h].re + f[h].im * a[h].im;
        fa.im += f[h].re * a[h].im - f[h].im * a[h].re;
      }
      const Parts h1{fa.re * inverse, fa.im * inverse};
      for (std::size_t h = 0; h < hits; ++h) {
        left[h] += unexplained(h1, factor[h], f[h], a[h]);
        all[h] += a[h].power().sum();
      }
    }
  }
  for (std::size_t h = 0; h < hits; ++h) left[h] = all[h] > 0 ? left[h] / all[h] : 0;
  return left;
}

}  // namespace percuss::frf
