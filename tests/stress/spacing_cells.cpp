#include <fmt/format.h>

#include "cell.hpp"

namespace percuss::stress {
namespace {

struct Pair {
  double freq_Hz, damping_ratio, bandwidths;
  bool alike = false;  // equal ratios of residues, as of two hoop modes at one point: only the poles tell them apart
};

synth::SynthSpec pair_of(const Pair& pair) {
  const double apart_Hz = pair.bandwidths * 2 * pair.damping_ratio * pair.freq_Hz;
  synth::SynthSpec spec = structure(
      {{.freq_Hz = pair.freq_Hz, .damping_ratio = pair.damping_ratio, .residue_per_kg = {1, 0.5}},
       {.freq_Hz = pair.freq_Hz + apart_Hz, .damping_ratio = pair.damping_ratio, .residue_per_kg = {0.6, -0.8}}});
  if (pair.alike) spec.modes[1].residue_per_kg = {0.8, 0.4};
  return spec;
}

}  // namespace

// The record is long enough for both modes to decay at 0.2 % (60 dB in 0.55 s at 1000 Hz).
std::vector<Cell> spacing_cells() {
  std::vector<Cell> cells;
  for (const double damping_ratio : {0.002, 0.01, 0.05}) {
    for (const double bandwidths : {0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5, 2.0}) {
      for (const double snr_dB : {20.0, 40.0, 60.0, 80.0}) {
        for (const bool alike : {false, true}) {
          Cell cell{.group = "spacing",
                    .name = fmt::format("{:.2f} bandwidths of {:g} %, {:g} dB{}", bandwidths, damping_ratio * 100,
                                        snr_dB, alike ? ", alike at both sensors" : ""),
                    .spec = pair_of({1000, damping_ratio, bandwidths, alike})};
          cell.spec.noise.accel = ratio_of_dB(snr_dB);
          cell.runs = 2;
          cell.full_runs = 16;
          cell.calibrated = true;
          cells.push_back(std::move(cell));
        }
      }
    }
  }
  for (const double bandwidths : {0.1, 0.2, 0.35, 0.5, 1.0, 2.0}) {
    Cell cell{.group = "spacing",
              .name = fmt::format("{:.2f} bandwidths of 1 %, no noise", bandwidths),
              .spec = pair_of({1000, 0.01, bandwidths})};
    cells.push_back(std::move(cell));
  }
  for (const double snr_dB : {40.0, 80.0}) {
    Cell cell{.group = "spacing",
              .name = fmt::format("repeated root, {:g} dB", snr_dB),
              .spec = pair_of({1000, 0.01, 0}),
              .expected = {.text = "one mode for the two (one struck point cannot separate them), within 5σ",
                           .demand = Demand::all}};
    cell.spec.noise.accel = ratio_of_dB(snr_dB);
    cell.runs = 4;
    cell.full_runs = 32;
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace percuss::stress
