#include "record_study.hpp"

#include <fmt/format.h>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "core/io/temporary_folder.hpp"
#include "fft_read_baseline.hpp"
#include "frf_figures.hpp"
#include "mode_figures.hpp"
#include "pipeline/run_analyses.hpp"

namespace percuss::accuracy {
namespace {

constexpr const char* kTime = "bare FFTW + reading";

pipeline::AnalysisOptions options_for(const synth::SynthSpec& spec) {
  return {.band_Hz = {{spec.band_low_Hz, spec.band_high_Hz}}, .threads = 1};
}

// Sets `time_ratio` of every estimator (`frfs`) and every effort (`modes`): its run time over the baseline's, measured
// in alternation.
void measure_times(const acquire::Record& run, const synth::SynthSpec& spec, const TimingOptions& timing,
                   std::vector<Figure>& frfs, std::vector<Figure>& modes) {
  const TemporaryFolder folder("percuss-accuracy");
  const std::string path = folder.file("run.h5");
  acquire::write_hdf5(path, run, true);
  const FftReadBaseline limit({path}, run);
  std::vector<std::function<void()>> works{[&] { limit.run(); }};
  for (const frf::Estimator estimator : {frf::Estimator::h1, frf::Estimator::h2, frf::Estimator::hv}) {
    works.emplace_back([&, estimator] {
      pipeline::AnalysisOptions options = options_for(spec);
      options.estimator = estimator;
      pipeline::Analysis(acquire::open_record(path), options).frfs();
    });
  }
  for (const identify::Effort effort : kEfforts) {
    works.emplace_back([&, effort] {
      pipeline::AnalysisOptions options = options_for(spec);
      options.modes.effort = effort;
      pipeline::Analysis(acquire::open_record(path), options).classifications();
    });
  }
  const std::vector<double> best_s = best_interleaved_s(works, timing);
  for (std::size_t i = 0; i < frfs.size(); ++i) frfs[i].time_ratio = best_s[1 + i] / best_s[0];
  for (std::size_t i = 0; i < modes.size(); ++i) modes[i].time_ratio = best_s[1 + frfs.size() + i] / best_s[0];
}

}  // namespace

RecordStudy study_records(Extent extent, const TimingOptions& timing) {
  RecordStudy study{.frfs = {.name = "frf",
                             .title = "Frequency responses",
                             .error = "error of the FRF, %",
                             .time = kTime,
                             .more = {"worst at a resonance, dB"},
                             .sweeps = {}},
                    .modes = {.name = "modes",
                              .title = "Modes",
                              .error = "error of the frequency, ppm",
                              .time = kTime,
                              .more = {"damping, %", "over the bound", "coverage, %", "found, %", "spurious, per run"},
                              .sweeps = {}}};
  for (const RecordSweep& sweep : record_sweeps(extent)) {
    study.frfs.sweeps.push_back({sweep.over, {}});
    study.modes.sweeps.push_back({sweep.over, {}});
    for (const RecordCase& one : sweep.cases) {
      const synth::SyntheticTest test = synth::synthesise(one.spec);
      const auto runs = pipeline::split_runs(test.record);
      std::vector<Figure> frfs = frf_errors(runs, test.truth), modes = mode_errors(runs, test.truth);
      measure_times(runs.front().second, one.spec, timing, frfs, modes);
      mark_pareto_front(frfs);
      mark_pareto_front(modes);
      study.frfs.sweeps.back().cases.push_back({one.value, std::move(frfs)});
      study.modes.sweeps.back().cases.push_back({one.value, std::move(modes)});
    }
  }
  return study;
}

}  // namespace percuss::accuracy
