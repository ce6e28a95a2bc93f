#include "frf/agreement.hpp"

#include <cstddef>

#include "core/complex.hpp"

namespace percuss {
std::vector<double> unexplained_by_others(std::span<const std::vector<Complex>* const> force,
                                          std::span<const std::vector<const std::vector<Complex>*>> accel) {
  const std::size_t hits = force.size();
  std::vector<double> left(hits), all(hits);
  if (hits < 2) return left;
  const std::size_t lines = force.front()->size();
  for (std::size_t c = 0; c < accel.front().size(); ++c) {
    for (std::size_t k = 0; k < lines; ++k) {
      Complex fa;
      double ff = 0;
      for (std::size_t h = 0; h < hits; ++h) {
        fa += conj_times((*force[h])[k], (*accel[h][c])[k]);
        ff += std::norm((*force[h])[k]);
      }
      for (std::size_t h = 0; h < hits; ++h) {
        const Complex f = (*force[h])[k];
        const Complex a = (*accel[h][c])[k];
        const double rest = ff - std::norm(f);
        const Complex frf = rest > 0 ? (fa - conj_times(f, a)) / rest : Complex{};
        left[h] += std::norm(a - conj_times(std::conj(frf), f));
        all[h] += std::norm(a);
      }
    }
  }
  for (std::size_t h = 0; h < hits; ++h) left[h] = all[h] > 0 ? left[h] / all[h] : 0;
  return left;
}

}  // namespace percuss
