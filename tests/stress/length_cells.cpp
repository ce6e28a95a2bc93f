#include <fmt/format.h>

#include "cell.hpp"

namespace percuss::stress {
namespace {

constexpr double kHundredth = 0.01;  // of the relative bandwidth and of the damping ratio of the mode at 1100 Hz

Cell row_of(std::size_t samples, double pretrigger_s, Expectation expected) {
  Cell cell{.group = "length",
            .name = fmt::format("{} samples", samples),
            .spec = two_modes(),
            .alter = [=](Samples& all) { cut(all, samples); },
            .expected = std::move(expected)};
  cell.spec.pretrigger_s = pretrigger_s;
  cell.spec.onset_spread_s = 0;
  cell.spec.noise.accel = 1e-3;
  cell.spec.samples = 64;
  while (cell.spec.samples < samples) cell.spec.samples *= 2;
  return cell;
}

// The onset is 16 samples after the start of the row.
std::vector<Cell> short_rows() {
  constexpr double kPretrigger_s = 0.002;
  std::vector<Cell> cells;
  for (const std::size_t samples : {1U, 2U, 3U, 7U, 13U, 16U})
    cells.push_back(row_of(samples, kPretrigger_s, {.exit_code = 4, .reason = "no_pulse"}));
  for (const std::size_t samples : {17U, 19U, 23U, 31U})
    cells.push_back(row_of(samples, kPretrigger_s, {.exit_code = 3, .reason = "record longer"}));
  for (const std::size_t samples : {61U, 127U, 251U}) {
    cells.push_back(row_of(samples, kPretrigger_s, {.demand = Demand::none, .or_refused = {"lines"}}));
    cells.back().full_runs = 16;
  }
  return cells;
}

}  // namespace

std::vector<Cell> length_cells() {
  std::vector<Cell> cells = short_rows();
  for (const std::size_t samples : {509U, 1021U, 2053U, 4093U, 8191U, 8209U, 65537U}) {
    cells.push_back(row_of(samples, 0.02, {.demand = Demand::all}));
    cells.back().calibrated = true;
    // This pre-trigger is shorter than the ringing of the anti-alias filter before the pulse.
    cells.push_back(row_of(samples, 0.002, {.demand = Demand::all}));
    cells.back().name += ", pre-trigger of 16";
    cells.back().expected.says = {"short_pretrigger"};
    cells.back().expected.warns = "short_pretrigger";  // standard deviations may be too small by a factor of two
    cells.back().expected.freq_relative = kHundredth * 2 * 0.005;
    cells.back().expected.damping_absolute = kHundredth * 0.005;
    for (Cell* cell : {&cells.back(), &cells[cells.size() - 2]}) {
      cell->runs = 2;
      cell->full_runs = 32;
    }
  }
  Cell longest{.group = "length", .name = "2^24 samples, 6 hits in one row", .spec = two_modes()};
  longest.spec.layout = synth::SynthLayout::continuous;
  longest.spec.samples = std::size_t{1} << 24U;
  longest.spec.sensors.resize(1);
  longest.spec.structure.rigid_line_per_kg = {1.2};
  for (synth::SynthMode& mode : longest.spec.modes) mode.residue_per_kg.resize(1);
  longest.spec.hits = 6;
  longest.spec.noise.accel = 1e-4;
  longest.expected.demand = Demand::all;
  cells.push_back(std::move(longest));
  return cells;
}

}  // namespace percuss::stress
