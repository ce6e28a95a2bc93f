#include "deflection_study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "core/io/temporary_folder.hpp"
#include "core/parallel/parallel.hpp"
#include "deflection_bound.hpp"
#include "deflection_truth.hpp"
#include "fft_read_baseline.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/run_analyses.hpp"
#include "synth/schedule.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::size_t kBeamMainRuns = 64, kBeamRuns = 16, kBeamQuickRuns = 2;
constexpr double kBeamLength_s = 1.2, kBeamNoise = 1e-3;
constexpr std::array kMethods{metrics::DeflectionMethod::small_interval, metrics::DeflectionMethod::frequency,
                              metrics::DeflectionMethod::drift_free, metrics::DeflectionMethod::modal};

struct BeamCase {
  std::string value;
  double length_s = kBeamLength_s, noise = kBeamNoise;
  std::size_t modes = 3, channels = 1, runs = kBeamRuns;
};

synth::SynthSpec held_beam(const BeamCase& one) {
  constexpr std::array<synth::SynthPole, 3> poles{{{14.5, 0.012}, {90, 0.01}, {322, 0.008}}};
  constexpr std::array residues{3.2, 1.1, -0.8};
  synth::SynthSpec spec{.name = "held-beam", .fs_Hz = 10000, .seed = 7, .band_low_Hz = 5, .band_high_Hz = 1000};
  // The noise is a fraction of the RMS over the record. This RMS falls as the record gets longer.
  spec.noise = {.force = 0, .accel = one.noise * std::sqrt(one.length_s / kBeamLength_s)};
  spec.samples = static_cast<std::size_t>(std::lround(one.length_s * spec.fs_Hz));
  spec.hits = 3;
  spec.runs = one.runs;
  spec.pretrigger_s = 0.1;
  spec.pulse = {.width_s = 0.0025, .peak_N = 800};
  spec.recorder.accel_bias_mps2 = 0.3;
  spec.recorder.accel_drift_mps2_per_s = 0.1;
  spec.structure.rigid_line_per_kg.assign(one.channels, 0.0);
  spec.sensors.assign(one.channels, {});
  for (std::size_t m = 0; m < one.modes; ++m) {
    synth::SynthMode mode{.freq_Hz = poles.at(m).freq_Hz, .damping_ratio = poles.at(m).damping_ratio};
    for (std::size_t c = 0; c < one.channels; ++c) {  // along the beam, towards its support
      mode.residue_per_kg.push_back(residues.at(m) *
                                    (1 - 0.6 * static_cast<double>(c) / static_cast<double>(one.channels)));
    }
    spec.modes.push_back(std::move(mode));
  }
  return spec;
}

// The largest deflection of each hit, [hits][channels].
std::vector<std::vector<double>> true_peaks_m(const synth::Truth& truth) {
  std::vector<synth::SynthPole> poles;
  for (const synth::SynthMode& mode : truth.spec.modes) poles.push_back({mode.freq_Hz, mode.damping_ratio});
  std::vector<std::vector<double>> peaks;
  for (const synth::TrueHit& hit : truth.hits) {
    const TrueDeflection exact(synth::pulses_of(truth.spec, hit).front(), poles);
    peaks.emplace_back();
    for (const auto& residues : truth.residue_per_kg.front()) peaks.back().push_back(exact.peak(residues).value_m);
  }
  return peaks;
}

pipeline::ImpactTest deflections_of(acquire::Record record, const synth::SynthSpec& spec,
                                    metrics::DeflectionMethod method) {
  const pipeline::Analysis analysis(std::move(record),
                                    {.band_Hz = {{spec.band_low_Hz, spec.band_high_Hz}}, .threads = 1});
  return pipeline::deflect(analysis, {.deflection = {.method = method}});
}

struct DeflectionTally {
  double error = 0, over_bound = 0, detected = 0, covered = 0, hits = 0;
};

DeflectionTally deflection_tally(const pipeline::ImpactTest& test, const std::vector<std::vector<double>>& truth_m,
                                 const std::vector<double>& bound) {
  DeflectionTally tally;
  for (const pipeline::DeflectedHit& hit : test.hits) {
    ++tally.hits;
    if (!hit.deflection.has_peak()) continue;
    const double exact = std::abs(truth_m[hit.hit][hit.channel]);
    const double error = std::abs(hit.deflection.peak_m) - exact;
    tally.error += std::pow(error / exact, 2);
    tally.over_bound += std::pow(error / exact / bound[hit.channel], 2);
    tally.covered += std::abs(error) <= kInterval * hit.deflection.peak_std_m ? 1 : 0;
    ++tally.detected;
  }
  return tally;
}

std::vector<Figure> errors(const synth::SyntheticTest& test, const std::vector<std::pair<int, acquire::Record>>& runs) {
  const auto truth_m = true_peaks_m(test.truth);
  const std::vector<double> bound = deflection_bound(test.truth);
  std::vector<Figure> figures;
  for (const metrics::DeflectionMethod method : kMethods) {
    std::vector<DeflectionTally> each(runs.size());
    parallel_for(runs.size(), 0, [&](std::size_t i) {
      each[i] = deflection_tally(deflections_of(runs[i].second, test.truth.spec, method), truth_m, bound);
    });
    DeflectionTally all;
    for (const DeflectionTally& one : each) {
      all.error += one.error;
      all.over_bound += one.over_bound;
      all.detected += one.detected;
      all.covered += one.covered;
      all.hits += one.hits;
    }
    const bool has_std = method == metrics::DeflectionMethod::drift_free || method == metrics::DeflectionMethod::modal;
    figures.push_back({.method = name_of(method),
                       .label = {},
                       .error = 100 * std::sqrt(all.error / all.detected),
                       .over_bound = std::sqrt(all.over_bound / all.detected),
                       .more = {has_std ? fmt::format("{:.1f}", 100 * all.covered / all.detected) : "–",
                                fmt::format("{:.0f}", 100 * all.detected / all.hits)}});
  }
  return figures;
}

void measure_deflection_times(const acquire::Record& run, const synth::SynthSpec& spec, const TimingOptions& timing,
                              std::vector<Figure>& figures) {
  const TemporaryFolder folder("percuss-accuracy");
  const std::string path = folder.file("run.h5");
  acquire::write_hdf5(path, run, true);
  const FftReadBaseline limit({path}, run);
  std::vector<std::function<void()>> works{[&] { limit.run(); }};
  for (const metrics::DeflectionMethod method : kMethods)
    works.emplace_back([&, method] { deflections_of(acquire::open_record(path), spec, method); });
  const std::vector<double> best_s = best_interleaved_s(works, timing);
  for (std::size_t i = 0; i < figures.size(); ++i) figures[i].time_ratio = best_s[1 + i] / best_s[0];
}

Case measured(BeamCase one, Extent extent, const TimingOptions& timing) {
  if (extent == Extent::quick) one.runs = kBeamQuickRuns;
  const synth::SyntheticTest test = synth::synthesise(held_beam(one));
  const auto runs = pipeline::split_runs(test.record);
  std::vector<Figure> figures = errors(test, runs);
  measure_deflection_times(runs.front().second, test.truth.spec, timing, figures);
  mark_pareto_front(figures);
  return {one.value, std::move(figures)};
}

std::vector<std::pair<std::string, std::vector<BeamCase>>> beam_cases() {
  return {
      {"noise",
       {{.value = "0.01 %", .noise = 1e-4},
        {.value = "0.1 %", .runs = kBeamMainRuns},
        {.value = "1 %", .noise = 1e-2}}},
      {"record length",
       {{.value = "0.3 s", .length_s = 0.3}, {.value = "0.6 s", .length_s = 0.6}, {.value = "2.4 s", .length_s = 2.4}}},
      {"modes", {{.value = "1 mode", .modes = 1}, {.value = "2 modes", .modes = 2}}},
      {"channels", {{.value = "4 channels", .channels = 4}, {.value = "16 channels", .channels = 16}}}};
}

}  // namespace

TaskFigures study_deflection(Extent extent, const TimingOptions& timing) {
  TaskFigures task{.name = "deflection",
                   .title = "Largest deflection",
                   .error = "error of the largest deflection, %",
                   .time = "bare FFTW + reading",
                   .more = {"coverage, %", "detected, %"},
                   .sweeps = {}};
  for (const auto& [over, cases] : beam_cases()) {
    task.sweeps.push_back({over, {}});
    for (const BeamCase& one : cases) {
      if (extent == Extent::quick && one.runs != kBeamMainRuns && !task.sweeps.back().cases.empty()) continue;
      task.sweeps.back().cases.push_back(measured(one, extent, timing));
    }
  }
  return task;
}

}  // namespace percuss::accuracy
