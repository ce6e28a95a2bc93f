#include <fmt/format.h>

#include <cmath>

#include "cell.hpp"

namespace percuss::stress {

// The analysis has no absolute scale: every scale whose square a double can hold must work.
std::vector<Cell> scale_cells() {
  std::vector<Cell> cells;
  for (const int force : {-30, -12, 0, 12, 30}) {
    for (const int accel : {-30, -12, 0, 12, 30}) {
      for (const double noise : {0.0, 1e-3}) {
        Cell cell{.group = "scale",
                  .name = fmt::format("force × 1e{}, response × 1e{}{}", force, accel, noise > 0 ? ", 60 dB" : ""),
                  .spec = two_modes(),
                  .expected = {.demand = Demand::all}};
        cell.spec.noise.accel = noise;
        cell.alter = [=](Samples& samples) { scale(samples, std::pow(10, force), std::pow(10, accel)); };
        cell.full_runs = noise > 0 ? 4 : 1;
        cells.push_back(std::move(cell));
      }
    }
  }
  return cells;
}

}  // namespace percuss::stress
