// percuss_effort_ratio [LO:HI FILE]...
// Prints the time of FRFs and of each effort, in ms and as a multiple of the time of bare FFTW transforms, and the time
// of each stage in ms. The bare transforms are of the same records in memory: one per channel and hit, planned with
// FFTW_MEASURE, on one thread, in the same run. The multiple in brackets refers to as many transforms of one signal
// that stays in the cache. Without files, the program uses the bundled composite bat, which has a split hoop mode. All
// measurements alternate, so that a disturbance affects all alike; each time is the shortest of several rounds.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "acquire/open_measurement.hpp"
#include "fftw_baseline.hpp"
#include "pipeline/analysis.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"
#include "wall_time.hpp"

namespace percuss {
namespace {

constexpr double kMinTotal_s = 3;  // total time of the analyses; there are at least three rounds

acquire::Record in_memory(const acquire::Record& record) {
  std::vector<std::vector<double>> force;
  std::vector<std::vector<std::vector<double>>> accel;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const std::size_t samples = record.rows[row].samples;
    record.read_force_N(row, 0, force.emplace_back(samples));
    accel.emplace_back();
    for (std::size_t c = 0; c < record.accel.size(); ++c)
      record.read_accel_mps2(row, c, 0, accel.back().emplace_back(samples));
  }
  acquire::Record copy = acquire::record_in_memory(record.fs_Hz, std::move(force), std::move(accel));
  copy.rows = record.rows;
  copy.accel = record.accel;
  for (acquire::SignalInfo& signal : copy.accel) signal.to_SI = 1;
  copy.continuous = record.continuous;
  return copy;
}

// Bare FFTW transforms of the force and the accelerations of a record, which are copied first.
class BareTransforms {
 public:
  explicit BareTransforms(const acquire::Record& record) : fftw_(record.rows.front().samples, FFTW_MEASURE) {
    const std::size_t samples = record.rows.front().samples;
    for (std::size_t row = 0; row < record.rows.size(); ++row) {
      record.read_force_N(row, 0, new_signal(samples));
      for (std::size_t c = 0; c < record.accel.size(); ++c) record.read_accel_mps2(row, c, 0, new_signal(samples));
    }
  }
  void run() {
    for (const auto& values : values_) fftw_.transform(values.get());
  }
  // The same number of transforms of one signal that stays in the cache.
  void run_cached() {
    for (std::size_t n = 0; n < values_.size(); ++n) fftw_.transform(values_.front().get());
  }

 private:
  std::span<double> new_signal(std::size_t samples) {
    values_.push_back(fftw_samples(samples));
    return {values_.back().get(), samples};
  }

  FftwBaseline fftw_;
  std::vector<FftwSamples> values_;
};

struct Measured {
  std::optional<identify::Effort> effort;  // none: only FRFs
  double best_s = 1e9;
  std::size_t modes = 0;
  std::string stages;

  void run(const acquire::Record& record, pipeline::AnalysisOptions options) {
    if (effort) options.modes.effort = *effort;
    std::string stage_times;
    const double took = seconds_of([&] {
      const pipeline::Analysis analysis(record, options);
      if (effort) {
        modes = analysis.classifications().size();
      } else {
        (void)analysis.frfs();
      }
      for (const auto& stage : analysis.trace().stages())
        stage_times += fmt::format(" {} {:.2f}", stage.name, stage.seconds * 1e3);
    });
    if (took >= best_s) return;
    best_s = took;
    stages = stage_times;
  }
};

void compare(const std::string& name, const acquire::Record& record, pipeline::AnalysisOptions options) {
  options.threads = 1;
  BareTransforms bare(record);
  double bare_s = 1e9, cached_s = 1e9;
  std::vector<Measured> measured{{}, {identify::Effort::quick}, {identify::Effort::standard}, {identify::Effort::best}};
  double all_s = 0;
  for (int n = 0; n < 3 || all_s < kMinTotal_s; ++n) {
    bare_s = std::min(bare_s, seconds_of([&] { bare.run(); }));
    cached_s = std::min(cached_s, seconds_of([&] { bare.run_cached(); }));
    all_s += seconds_of([&] {
      for (Measured& one : measured) one.run(record, options);
    });
  }
  fmt::print("{}: {} rows of {} samples, {} channels; bare transforms {:.2f} ms, {:.2f} ms within the cache\n", name,
             record.rows.size(), record.rows.front().samples, 1 + record.accel.size(), bare_s * 1e3, cached_s * 1e3);
  for (const Measured& one : measured) {
    fmt::print("  {:8} {:9.2f} ms  {:6.2f} x ({:.2f} x)  {} modes; ms in{}\n",
               one.effort ? name_of(*one.effort) : "FRFs", one.best_s * 1e3, one.best_s / bare_s, one.best_s / cached_s,
               one.modes, one.stages);
  }
}

std::pair<double, double> band_of(const std::string& text) {
  const auto colon = text.find(':');
  return {std::strtod(text.c_str(), nullptr), std::strtod(text.c_str() + colon + 1, nullptr)};
}

}  // namespace
}  // namespace percuss

int main(int count, char** arguments) {
  using namespace percuss;
  try {
    if (count < 3) compare("composite-bat", synth::synthesise(synth::synth_preset("composite-bat")).record, {});
    for (int i = 1; i + 1 < count; i += 2)
      compare(arguments[i + 1], in_memory(acquire::open_record(arguments[i + 1])), {.band_Hz = band_of(arguments[i])});
  } catch (const std::exception& problem) {
    fmt::print(stderr, "percuss_effort_ratio: {}\n", problem.what());
    return 1;
  }
  return 0;
}
