#include <fmt/format.h>

#include "cell.hpp"

namespace percuss::stress {
namespace {

constexpr double kNone = 1000;  // dB

std::string text_of(double snr_dB) { return snr_dB < kNone ? fmt::format("{:g} dB", snr_dB) : "no noise"; }

// Where the pulse barely exceeds its noise, the gain of the FRF is uncertain by 10 %, and reported modes must still be
// right. Below 20 dB no pulse is visible.
Expectation expected_at(double force_dB) {
  if (force_dB < 20) return {.exit_code = 4, .reason = "no_pulse"};
  if (force_dB < 40) return {.demand = Demand::none, .or_refused = {"no_pulse"}};
  return {};
}

}  // namespace

std::vector<Cell> noise_cells() {
  std::vector<Cell> cells;
  for (const double force_dB : {0.0, 20.0, 40.0, 60.0, 80.0, kNone}) {
    for (const double accel_dB : {0.0, 20.0, 40.0, 60.0, 80.0, kNone}) {
      Cell cell{.group = "noise",
                .name = fmt::format("force {}, response {}", text_of(force_dB), text_of(accel_dB)),
                .spec = two_modes(),
                .expected = expected_at(force_dB),
                .runs = 4,
                .full_runs = 32,
                .calibrated = force_dB >= 40};
      cell.spec.noise = {.force = force_dB < kNone ? ratio_of_dB(force_dB) : 0,
                         .accel = accel_dB < kNone ? ratio_of_dB(accel_dB) : 0};
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

}  // namespace percuss::stress
