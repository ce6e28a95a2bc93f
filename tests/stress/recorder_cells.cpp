#include <fmt/format.h>

#include "cell.hpp"

namespace percuss::stress {
namespace {

constexpr double kTenth = 0.1;

Cell cell_of(const std::string& name, Expectation expected) {
  Cell cell{.group = "recorder", .name = name, .spec = two_modes(), .expected = std::move(expected)};
  cell.spec.noise = {.force = 1e-4, .accel = 1e-3};
  cell.runs = 2;
  cell.full_runs = 64;
  return cell;
}

// The largest force is 300 N, the largest acceleration near 500 m/s².
std::vector<Cell> offsets_drifts_and_hum() {
  std::vector<Cell> cells;
  for (const double fraction : {0.01, 0.1, 1.0}) {
    Cell both = cell_of(fmt::format("constant offset, {:g} of the peaks", fraction), {.demand = Demand::all});
    both.spec.recorder.force_bias_N = 300 * fraction;
    both.spec.recorder.accel_bias_mps2 = 500 * fraction;
    cells.push_back(std::move(both));
    Cell drift = cell_of(fmt::format("drift over the record, {:g} of the peak", fraction), {.demand = Demand::all});
    drift.spec.recorder.accel_drift_mps2_per_s = 500 * fraction;
    cells.push_back(std::move(drift));
  }
  // Drifts of ten and of a hundred times the motion of the structure are subtracted; a finding must state this.
  for (const double fraction : {10.0, 100.0}) {
    Cell drift = cell_of(fmt::format("drift over the record, {:g} of the peak", fraction),
                         {.demand = Demand::all, .says = {"offset"}});
    drift.spec.recorder.accel_drift_mps2_per_s = 500 * fraction;
    cells.push_back(std::move(drift));
  }
  for (const double mains_Hz : {50.0, 60.0}) {
    for (const double fraction : {1e-4, 1e-3, 0.01, 0.1}) {
      Cell hum = cell_of(fmt::format("hum at {:g} Hz and odd harmonics, {:g} of the peak", mains_Hz, fraction),
                         {.text = "both modes within 5σ, no mode at the mains' harmonics", .demand = Demand::all});
      hum.alter = [=](Samples& samples) { add_hum(samples, mains_Hz, fraction); };
      cells.push_back(std::move(hum));
    }
  }
  return cells;
}

std::vector<Cell> limits() {
  Cell force = cell_of("force clipped in every hit", {.exit_code = 4, .reason = "overload"});
  force.spec.pulse.peak_spread = 0;
  force.spec.recorder.force_clip_N = 150;
  Cell some =
      cell_of("force clipped in three hits of five", {.demand = Demand::all, .says = {"overload", "rejected_hits"}});
  some.spec.pulse.peak_spread = 0.02;
  some.spec.recorder.force_clip_N = 150;
  some.spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::weak, .ratio = 0.4},
                      {.hit = 3, .kind = synth::SynthFaultKind::weak, .ratio = 0.45}};
  Cell accel = cell_of("response clipped in every hit", {.exit_code = 4, .reason = "overload"});
  accel.spec.pulse.peak_spread = 0;
  accel.spec.recorder.accel_clip_mps2 = 100;
  Cell tops = cell_of("tops of the response clipped", {.demand = Demand::all, .or_refused = {"overload"}});
  tops.spec.pulse.peak_spread = 0;
  tops.spec.recorder.accel_clip_mps2 = 250;
  std::vector<Cell> cells{std::move(force), std::move(some), std::move(accel), std::move(tops)};
  for (const int bits : {1, 2, 4, 6, 8, 10, 12, 16, 24}) {
    Cell rounded =
        cell_of(fmt::format("{} bits", bits), {.warns = "coarse_steps", .or_refused = {"no_pulse", "overload"}});
    rounded.spec.noise = {};
    // Quantisation depends on the signal and is not noise: the warning states that standard deviations do not hold.
    // From 8 bits on, both modes must still be found to a tenth of the narrower one's relative bandwidth.
    if (bits >= 8) {
      rounded.expected.freq_relative = kTenth * 2 * 0.005;
      rounded.expected.damping_absolute = kTenth * 0.005;
    }
    rounded.spec.recorder.bits = bits;
    cells.push_back(std::move(rounded));
  }
  Cell single = cell_of("single precision", {.demand = Demand::all});
  single.spec.noise = {};
  single.alter = round_to_float;
  cells.push_back(std::move(single));
  return cells;
}

std::vector<Cell> wiring() {
  Cell reversed = cell_of("force with the wrong sign", {.demand = Demand::all, .says = {"polarity"}});
  reversed.alter = [](Samples& samples) { scale(samples, -1, 1); };
  Cell one = cell_of("force with the wrong sign in one hit", {.demand = Demand::all, .says = {"polarity"}});
  one.spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::reversed}};
  Cell sensor = cell_of("second sensor the wrong way round", {.demand = Demand::all});
  sensor.spec.sensors[1].sign = -1;
  Cell swapped = cell_of("force and first response exchanged", {.exit_code = 4, .reason = "no_pulse"});
  swapped.alter = swap_force_and_first_accel;
  Cell no_force = cell_of("force channel dead", {.exit_code = 4, .reason = "no_pulse"});
  no_force.alter = [](Samples& samples) { scale(samples, 0, 1); };
  Cell no_accel = cell_of("responses dead",
                          {.text = "no mode, says dead_channel", .demand = Demand::none, .says = {"dead_channel"}});
  no_accel.alter = [](Samples& samples) { scale(samples, 1, 0); };
  Cell one_dead = cell_of("second response dead", {.demand = Demand::all, .says = {"dead_channel"}});
  one_dead.alter = [](Samples& samples) {
    for (auto& row : samples.accel_mps2) row[1].assign(row[1].size(), 0);
  };
  return {std::move(reversed), std::move(one),      std::move(sensor),  std::move(swapped),
          std::move(no_force), std::move(no_accel), std::move(one_dead)};
}

}  // namespace

std::vector<Cell> recorder_cells() {
  std::vector<Cell> cells = offsets_drifts_and_hum();
  for (Cell& cell : limits()) cells.push_back(std::move(cell));
  for (Cell& cell : wiring()) cells.push_back(std::move(cell));
  return cells;
}

}  // namespace percuss::stress
