#pragma once
#include <functional>
#include <string>
#include <vector>

#include "check.hpp"
#include "expectation.hpp"
#include "samples.hpp"
#include "synth/spec.hpp"

namespace percuss::stress {

/// A cell of the stress suite's tables: a synthetic test, its further changes, and the expected outcome.
struct Cell {
  std::string group, name;
  synth::SynthSpec spec;
  std::function<void(Samples&)> alter{};
  Expectation expected{};
  std::string defect{};  // Check::defect
  std::size_t runs = 1, full_runs = 1;
  double exponential_end = 0;  // AnalysisOptions::exponential_end
  bool calibrated = false;     // Result::calibrated
};
Check check_of(Cell cell);

/// The changed test of a cell with its truth. Every cell and run has its own noise and hits.
synth::SyntheticTest test_of(const Cell& cell, std::uint64_t run);
pipeline::AnalysisOptions options_of(const synth::SynthSpec& spec, double exponential_end = 0);

/// The common structure of the cells: two accelerometers, five hits, one second at 8192 Hz, band 60 to 3000 Hz.
synth::SynthSpec structure(std::vector<synth::SynthMode> modes);
/// The same with modes at 400 Hz (1 %) and 1100 Hz (0.5 %).
synth::SynthSpec two_modes();

/// The noise as a fraction, as in spec.noise, for this signal-to-noise ratio.
double ratio_of_dB(double snr_dB);

std::vector<Cell> spacing_cells();
std::vector<Cell> damping_cells();
std::vector<Cell> noise_cells();
std::vector<Cell> recorder_cells();
std::vector<Cell> scale_cells();
std::vector<Cell> length_cells();
std::vector<Cell> structure_cells();
std::vector<Check> invariance_checks();

}  // namespace percuss::stress
