#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include "fftw_baseline.hpp"
#include "pipeline/analysis.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

// The time of an analysis up to each stage, on the bundled bat with its samples in memory and on one thread. The
// counter x_fftw is the time as a multiple of one bare FFTW transform per channel and hit.
namespace percuss {
namespace {

const acquire::Record& bat() {
  static const synth::SyntheticTest test = synth::synthesise(synth::synth_preset("composite-bat"));
  return test.record;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The best of many runs: a disturbed baseline would make x_fftw too small.
double fft_baseline_s() {
  const acquire::Record& record = bat();
  const std::size_t samples = record.rows.front().samples;
  FftwBaseline fftw(samples);
  fftw.fill(std::vector<double>(samples, 1.0));
  double best_s = 1e9;
  for (int attempt = 0; attempt < 50; ++attempt) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t n = 0; n < record.rows.size() * (1 + record.accel.size()); ++n) fftw.transform();
    best_s = std::min(best_s, seconds_since(start));
  }
  return best_s;
}

template <class Demand>
void stage(benchmark::State& state, Demand demand) {
  static const double bare_s = fft_baseline_s();
  const acquire::Record& record = bat();
  const auto start = std::chrono::steady_clock::now();
  for ([[maybe_unused]] auto _ : state) {
    const pipeline::Analysis analysis(record, {.threads = 1});
    benchmark::DoNotOptimize(demand(analysis));
  }
  state.counters["x_fftw"] = seconds_since(start) / static_cast<double>(state.iterations()) / bare_s;
}

void hits_by_force(benchmark::State& state) {
  stage(state, [](const pipeline::Analysis& analysis) { return analysis.force_hits().size(); });
}
void hits_by_response(benchmark::State& state) {
  stage(state, [](const pipeline::Analysis& analysis) { return analysis.hits().size(); });
}
void frf_and_coherence(benchmark::State& state) {
  stage(state, [](const pipeline::Analysis& analysis) { return analysis.frfs().size(); });
}
void modes_and_classifications(benchmark::State& state) {
  stage(state, [](const pipeline::Analysis& analysis) { return analysis.classifications().size(); });
}

BENCHMARK(hits_by_force)->Unit(benchmark::kMillisecond);
BENCHMARK(hits_by_response)->Unit(benchmark::kMillisecond);
BENCHMARK(frf_and_coherence)->Unit(benchmark::kMillisecond);
BENCHMARK(modes_and_classifications)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace percuss
