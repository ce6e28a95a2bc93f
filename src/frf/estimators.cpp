#include "frf/estimators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/math/complex.hpp"
#include "core/math/wide_loops.hpp"

namespace percuss::frf {
namespace {

// (3) for one line; `scale` is the ratio of the rms acceleration to the rms force, which makes the two channels
// comparable.
Complex total_least_squares(double ff, double aa, Complex fa, double scale) {
  const double a = aa / (scale * scale);
  const Complex cross = fa / scale;
  if (std::abs(cross) == 0) return 0;
  const double half = 0.5 * (a - ff);
  const double root = std::sqrt(half * half + std::norm(cross));
  // Of the two equal forms, each branch takes the one without cancellation.
  return half >= 0 ? scale * (half + root) / std::conj(cross) : scale * cross / (root - half);
}

double rms_ratio(const CrossSpectra& spectra) {
  const double ff = std::accumulate(spectra.ff.begin(), spectra.ff.end(), 0.0);
  const double aa = std::accumulate(spectra.aa.begin(), spectra.aa.end(), 0.0);
  return aa > 0 ? std::sqrt(aa / ff) : 1;
}

// Adds the spectra of a hit at the lines first … end − 1.
PERCUSS_WIDE_LOOPS void add_hit(const Complex* f, const Complex* a, std::size_t first, std::size_t end,
                                CrossSpectra& sum) {
  double *ff = sum.ff.data(), *aa = sum.aa.data();
  Complex* fa = sum.fa.data();
  for (std::size_t k = first; k < end; ++k) {
    ff[k] += std::norm(f[k]);
    aa[k] += std::norm(a[k]);
    fa[k] += conj_times(f[k], a[k]);
  }
}

}  // namespace

const char* name_of(Estimator estimator) {
  switch (estimator) {
    case Estimator::h1:
      return "H1";
    case Estimator::h2:
      return "H2";
    case Estimator::hv:
      return "Hv";
  }
  return "";
}

CrossSpectra cross_spectra(std::span<const std::span<const Complex>> force,
                           std::span<const std::span<const Complex>> accel) {
  assert(force.size() == accel.size() && !force.empty());
  const std::size_t lines = force.front().size();
  CrossSpectra sum{.ff = std::vector<double>(lines),
                   .aa = std::vector<double>(lines),
                   .fa = std::vector<Complex>(lines),
                   .averages = force.size()};
  for (std::size_t first = 0; first < lines; first += kLinesPerBlock) {
    const std::size_t end = std::min(first + kLinesPerBlock, lines);
    for (std::size_t h = 0; h < force.size(); ++h) {
      const auto f = force[h];
      const auto a = accel[h];
      assert(f.size() == lines && a.size() == lines);
      add_hit(f.data(), a.data(), first, end, sum);
    }
  }
  return sum;
}

Frf estimate_frf(const CrossSpectra& spectra, const LineRange& lines, Estimator estimator) {
  const std::size_t count = spectra.ff.size();
  Frf frf{.value = std::vector<Complex>(count), .averages = spectra.averages};
  const bool averaged = spectra.averages > 1;
  if (averaged) {
    frf.std.resize(count);
    frf.coherence.resize(count);
  }
  require_force(spectra.ff, lines);
  const double scale = estimator == Estimator::hv ? rms_ratio(spectra) : 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double ff = spectra.ff[k];
    const double aa = spectra.aa[k];
    const Complex fa = spectra.fa[k];
    const Complex h1 = fa / ff;  // (1)
    switch (estimator) {
      case Estimator::h1:
        frf.value[k] = h1;
        break;
      case Estimator::h2:
        frf.value[k] = std::norm(fa) > 0 ? aa / std::conj(fa) : Complex{};  // (2)
        break;
      case Estimator::hv:
        frf.value[k] = total_least_squares(ff, aa, fa, scale);
        break;
    }
    if (!averaged) continue;
    // (4) and (5) from the residual energy, which is exact even where the coherence rounds to 1.
    const double unexplained = std::max(0.0, aa - std::norm(fa) / ff);
    frf.coherence[k] = aa > 0 ? std::min(1.0, 1 - unexplained / aa) : 0;
    frf.std[k] = std::sqrt(unexplained / (ff * static_cast<double>(spectra.averages - 1)));
  }
  return frf;
}

void require_force(std::span<const double> ff, const LineRange& lines) {
  const auto none = std::find_if(ff.begin(), ff.end(), [](double power) { return !(power > 0); });
  if (none == ff.end()) return;
  const auto line = static_cast<std::size_t>(none - ff.begin());
  throw InputError(fmt::format("the force has no energy at {:.6g} Hz", lines.freq_Hz(line)), "FRF", "narrow the band",
                   {"band"});
}

}  // namespace percuss::frf
