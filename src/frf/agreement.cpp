#include "frf/agreement.hpp"

#include <algorithm>
#include <cstddef>

#include "core/complex.hpp"

namespace percuss {

std::vector<double> unexplained_by_others(std::span<const std::vector<Complex>* const> force,
                                          std::span<const std::vector<const std::vector<Complex>*>> accel) {
  const std::size_t hits = force.size();
  std::vector<double> left(hits), all(hits);
  if (hits < 2) return left;
  const std::size_t lines = force.front()->size();
  std::vector<double> ff(lines);
  std::vector<Complex> fa(lines);
  for (std::size_t h = 0; h < hits; ++h) {
    const auto& f = *force[h];
    for (std::size_t k = 0; k < lines; ++k) ff[k] += std::norm(f[k]);
  }
  for (std::size_t c = 0; c < accel.front().size(); ++c) {
    std::fill(fa.begin(), fa.end(), Complex{});
    for (std::size_t h = 0; h < hits; ++h) {
      const auto& f = *force[h];
      const auto& a = *accel[h][c];
      for (std::size_t k = 0; k < lines; ++k) fa[k] += conj_times(f[k], a[k]);
    }
    for (std::size_t h = 0; h < hits; ++h) {
      const auto& f = *force[h];
      const auto& a = *accel[h][c];
      double misfit = 0, power = 0;
      for (std::size_t k = 0; k < lines; ++k) {
        // a − f (Σfa − f* a)/(Σff − |f|²), the other hits' H1, over one denominator.
        const double others = ff[k] - std::norm(f[k]);
        const double of_others = std::norm(ff[k] * a[k] - times(fa[k], f[k])) / (others * others);
        power += std::norm(a[k]);
        misfit += others > 0 ? of_others : std::norm(a[k]);
      }
      left[h] += misfit;
      all[h] += power;
    }
  }
  for (std::size_t h = 0; h < hits; ++h) left[h] = all[h] > 0 ? left[h] / all[h] : 0;
  return left;
}

}  // namespace percuss
