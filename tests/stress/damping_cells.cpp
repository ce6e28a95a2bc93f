#include <fmt/format.h>

#include "cell.hpp"

namespace percuss::stress {

std::vector<Cell> damping_cells() {
  std::vector<Cell> cells;
  for (const double damping_ratio : {1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.29}) {
    for (const double snr_dB : {20.0, 40.0, 60.0, 80.0, 0.0}) {
      const std::string noise = snr_dB > 0 ? fmt::format("{:g} dB", snr_dB) : "no noise";
      Cell cell{.group = "damping", .name = fmt::format("{:g} %, {}", damping_ratio * 100, noise), .spec = two_modes()};
      cell.spec.modes[1].damping_ratio = damping_ratio;
      cell.spec.noise.accel = snr_dB > 0 ? ratio_of_dB(snr_dB) : 0;
      cell.runs = snr_dB > 0 ? 4 : 1;
      cell.full_runs = snr_dB > 0 ? 32 : 1;
      cell.calibrated = true;
      cells.push_back(std::move(cell));
    }
  }
  // Hardly any decay within the record: at its end, the slowest mode still has 95 % of its amplitude.
  for (const double snr_dB : {40.0, 80.0}) {
    Cell cell{.group = "damping",
              .name = fmt::format("no decay within 0.1 s, {:g} dB", snr_dB),
              .spec = two_modes(),
              .expected = {.says = {"truncated_decay"}},
              .runs = 4,
              .full_runs = 32,
              .calibrated = true};
    cell.spec.samples = 819;
    cell.spec.modes[0].damping_ratio = 2.5e-4;
    cell.spec.modes[1].damping_ratio = 2e-4;
    cell.spec.noise.accel = ratio_of_dB(snr_dB);
    cells.push_back(std::move(cell));
  }
  // An exponential window correlates the noise of neighbouring lines, and more for a faster decay.
  for (const double end : {0.1, 0.01, 1e-3}) {
    for (const double snr_dB : {20.0, 40.0, 60.0}) {
      Cell cell{.group = "damping",
                .name = fmt::format("exponential window falling to {:g}, {:g} dB", end, snr_dB),
                .spec = two_modes(),
                .runs = 4,
                .full_runs = 32,
                .exponential_end = end,
                .calibrated = true};
      cell.spec.noise.accel = ratio_of_dB(snr_dB);
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

}  // namespace percuss::stress
