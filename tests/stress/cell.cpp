#include "cell.hpp"

#include <cmath>
#include <utility>

namespace percuss::stress {

namespace {

// FNV-1a hash of the cell's name and the run, so that the noise of the cells is independent.
std::uint64_t own_seed(const std::string& name, std::uint64_t run) {
  std::uint64_t hash = 14695981039346656037U ^ run;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash >> 12U;  // exact as a JSON number
}

}  // namespace

synth::SyntheticTest test_of(const Cell& cell, std::uint64_t run) {
  synth::SynthSpec spec = cell.spec;
  spec.seed = own_seed(cell.group + "/" + cell.name, run);
  synth::SyntheticTest test = synth::synthesise(spec, 1);
  if (!cell.alter) return test;
  Samples samples = samples_of(test.record);
  cell.alter(samples);
  test.record = record_of(std::move(samples), test.record);
  return test;
}

pipeline::AnalysisOptions options_of(const synth::SynthSpec& spec, double exponential_end) {
  return {.band_Hz = std::pair{spec.band_low_Hz, spec.band_high_Hz}, .exponential_end = exponential_end, .threads = 1};
}

Check check_of(Cell cell) {
  Check check{.group = cell.group,
              .name = cell.name,
              .expectation = text_of(cell.expected),
              .defect = cell.defect,
              .runs = cell.runs,
              .full_runs = cell.full_runs};
  check.record = [cell](std::uint64_t run) { return test_of(cell, run).record; };
  check.run = [cell = std::move(cell)](std::uint64_t run) {
    synth::SyntheticTest test = test_of(cell, run);
    const CommandResult outcome = analyse(std::move(test.record), options_of(cell.spec, cell.exponential_end));
    Result result = judge(outcome, true_modes(test.truth), cell.expected);
    result.calibrated = cell.calibrated;
    return result;
  };
  return check;
}

synth::SynthSpec structure(std::vector<synth::SynthMode> modes) {
  synth::SynthSpec spec;
  spec.fs_Hz = 8192;
  spec.samples = 8192;
  spec.band_low_Hz = 60;
  spec.band_high_Hz = 3000;
  spec.modes = std::move(modes);
  spec.structure.rigid_line_per_kg = {1.2, 0.4};
  spec.pretrigger_s = 0.02;
  return spec;
}

synth::SynthSpec two_modes() {
  return structure({{.freq_Hz = 400, .damping_ratio = 0.01, .residue_per_kg = {1, 0.5}},
                    {.freq_Hz = 1100, .damping_ratio = 0.005, .residue_per_kg = {0.6, -0.8}}});
}

double ratio_of_dB(double snr_dB) { return std::pow(10, -snr_dB / 20); }

}  // namespace percuss::stress
