#include "identify/model/point_columns.hpp"

#include <algorithm>
#include <array>

#include "core/math/complex.hpp"
#include "core/math/wide_loops.hpp"

namespace percuss::identify {
namespace {

// The factors of a truncated decay that do not depend on the force, for a pole and its conjugate, at the lines from
// `first` on.
struct DecayColumn {
  std::size_t first;
  const Complex *kernel, *mirror;
};

// q: [hits] the state of the mode at the end of the record.
PERCUSS_WIDE_LOOPS void fill_decay(std::span<Complex> decay, const PointForce& force, const std::vector<Complex>& q,
                                   const DecayColumn& column) {
  // The inner loops run over lines, so that the compiler vectorises them.
  constexpr std::size_t kBlock = 128;
  std::array<double, kBlock> rr{}, ii{}, ri{}, ir{};
  for (std::size_t begin = 0; begin < decay.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, decay.size() - begin);
    // conj(F)·q and conj(F)·conj(q) share their products.
    const Complex* first = force.spectra[0].get() + column.first + begin;
    for (std::size_t i = 0; i < count; ++i) {
      rr[i] = first[i].real() * q[0].real();
      ii[i] = first[i].imag() * q[0].imag();
      ri[i] = first[i].real() * q[0].imag();
      ir[i] = first[i].imag() * q[0].real();
    }
    for (std::size_t h = 1; h < q.size(); ++h) {
      const Complex* f = force.spectra[h].get() + column.first + begin;
      for (std::size_t i = 0; i < count; ++i) {
        rr[i] += f[i].real() * q[h].real();
        ii[i] += f[i].imag() * q[h].imag();
        ri[i] += f[i].real() * q[h].imag();
        ir[i] += f[i].imag() * q[h].real();
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = begin + i;
      const Complex all = times(column.kernel[k], {rr[i] + ii[i], ri[i] - ir[i]}) +
                          times(column.mirror[k], {rr[i] - ii[i], -ri[i] - ir[i]});
      decay[k] = all * (1 / force.ff[column.first + k]);
    }
  }
}

bool is_truncated(const Pole& pole, const FrfDataset& set) {
  return std::any_of(set.points.begin(), set.points.end(),
                     [&](const PointForce& force) { return !decays_within_record(pole, force, set.lines); });
}

}  // namespace

TruncatedDecay::TruncatedDecay(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines,
                               std::size_t first, std::size_t count)
    : first_(first), truncation_(pole, window_decay_per_s, lines) {
  kernel_.reserve(count);
  mirror_.reserve(count);
  for (const Truncation::Factors& of : truncation_.factors(first, count)) {
    kernel_.push_back(of.value);
    mirror_.push_back(of.mirror);
  }
}

std::vector<Complex> TruncatedDecay::at(const PointForce& force) const {
  std::vector<Complex> decay(kernel_.size());
  fill_decay(decay, force, truncation_.end_states(force).q,
             {.first = first_, .kernel = kernel_.data(), .mirror = mirror_.data()});
  return decay;
}

PointValues::PointValues(const Pole& pole, const FrfDataset& set, std::size_t first, std::size_t count)
    : pole_(pole),
      lines_(set.lines),
      whole_(untruncated_column(pole, set.window_decay_per_s(), set.lines, first, count, ColumnContent::value).value) {
  if (is_truncated(pole, set)) missing_.emplace(pole, set.window_decay_per_s(), set.lines, first, count);
}

std::span<const Complex> PointValues::at(const PointForce& force, std::vector<Complex>& work) const {
  const auto count = static_cast<std::size_t>(whole_.size());
  if (!missing_ || decays_within_record(pole_, force, lines_)) return {whole_.data(), count};
  work = missing_->at(force);
  for (std::size_t k = 0; k < count; ++k) work[k] = whole_(static_cast<Eigen::Index>(k)) - work[k];
  return work;
}

PointColumns::PointColumns(const Pole& pole, const FrfDataset& set, std::size_t first, std::size_t count)
    : pole_(pole),
      lines_(set.lines),
      first_(first),
      whole_(untruncated_column(pole, set.window_decay_per_s(), set.lines, first, count)),
      truncation_(pole, set.window_decay_per_s(), set.lines) {
  if (is_truncated(pole, set)) factors_ = truncation_.factors(first, count);
}

ModeColumn PointColumns::at(const PointForce& force) const {
  ModeColumn column = whole_;
  if (!factors_.empty() && !decays_within_record(pole_, force, lines_))
    truncation_.subtract_from(column, factors_, force, first_);
  return column;
}

}  // namespace percuss::identify
