#include <fmt/format.h>

#include <cmath>

#include "cell.hpp"

namespace percuss::stress {
namespace {

// 60 modes from 80 to 2900 Hz: spaced in proportion to their frequencies, 12 half-power bandwidths at 0.25 %.
synth::SynthSpec sixty_modes() {
  std::vector<synth::SynthMode> modes;
  for (int m = 0; m < 60; ++m) {
    const double angle = 0.7 * m;
    modes.push_back({.freq_Hz = 80 * std::pow(2900.0 / 80, m / 59.0),
                     .damping_ratio = 0.0025,
                     .residue_per_kg = {std::cos(angle) + 0.2, std::sin(angle)}});
  }
  synth::SynthSpec spec = structure(std::move(modes));
  spec.samples = 32768;
  return spec;
}

std::vector<Cell> many_modes() {
  std::vector<Cell> cells;
  for (const double snr_dB : {40.0, 60.0, 80.0}) {
    Cell cell{.group = "structure",
              .name = fmt::format("60 modes, {:g} dB", snr_dB),
              .spec = sixty_modes(),
              .expected = {},
              .full_runs = 4,
              .calibrated = true};
    cell.spec.noise.accel = ratio_of_dB(snr_dB);
    cells.push_back(std::move(cell));
  }
  return cells;
}

// One sensor at a node of the mode, or both.
std::vector<Cell> nodes() {
  Cell one{.group = "structure",
           .name = "one sensor on a node of a mode",
           .spec = two_modes(),
           .expected = {.demand = Demand::all},
           .runs = 4,
           .full_runs = 32,
           .calibrated = true};
  one.spec.modes[1].residue_per_kg = {0, 0.8};
  one.spec.noise.accel = 1e-3;
  Cell both = one;
  both.name = "both sensors on nodes of a mode";
  both.expected.text = "the other mode within 5σ, nothing else (no signal contains the mode on the nodes)";
  both.spec.modes[1].residue_per_kg = {0, 0};
  Cell near = one;
  near.name = "both sensors near nodes, 1e-4 of the antinode";
  near.expected = {};
  near.spec.modes[1].residue_per_kg = {1e-4, -1e-4};
  return {std::move(one), std::move(both), std::move(near)};
}

// The rigid-body accelerance alone; with the flanks of modes below and above the band; the same with a weak mode in the
// band.
std::vector<Cell> bands_with_few_modes() {
  std::vector<Cell> cells;
  for (const double snr_dB : {20.0, 60.0, 0.0}) {
    const std::string noise = snr_dB > 0 ? fmt::format("{:g} dB", snr_dB) : "no noise";
    Cell rigid{.group = "structure",
               .name = "no mode, rigid body alone, " + noise,
               .spec = structure({}),
               .expected = {.text = "no mode"},
               .runs = 4,
               .full_runs = 32};
    rigid.spec.noise.accel = snr_dB > 0 ? ratio_of_dB(snr_dB) : 0;
    Cell flanks = rigid;
    flanks.name = "no mode in the band, flanks of two beside it, " + noise;
    flanks.spec.modes = two_modes().modes;
    flanks.spec.modes[0].freq_Hz = 70;
    flanks.spec.modes[1].freq_Hz = 3200;
    flanks.spec.band_low_Hz = 300;
    flanks.spec.band_high_Hz = 2000;
    Cell beside = flanks;
    beside.name = "one mode in the band, flanks of stronger ones beside it, " + noise;
    beside.spec.modes.push_back({.freq_Hz = 900, .damping_ratio = 0.004, .residue_per_kg = {0.1, 0.1}});
    beside.expected = {.demand = Demand::all};
    beside.calibrated = true;
    for (Cell* cell : {&rigid, &flanks, &beside}) cells.push_back(std::move(*cell));
  }
  return cells;
}

}  // namespace

std::vector<Cell> structure_cells() {
  std::vector<Cell> cells = many_modes();
  for (Cell& cell : nodes()) cells.push_back(std::move(cell));
  for (Cell& cell : bands_with_few_modes()) cells.push_back(std::move(cell));
  return cells;
}

}  // namespace percuss::stress
