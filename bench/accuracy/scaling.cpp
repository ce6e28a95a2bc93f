#include "scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "acquire/open_measurement.hpp"
#include "core/io/temporary_folder.hpp"
#include "fft_read_baseline.hpp"
#include "forked.hpp"
#include "pipeline/analysis.hpp"
#include "scaling_files.hpp"

namespace percuss::accuracy {
namespace {

constexpr double kExpectedExponent = 1.2;  // of the time over the size, for the choice of the last size

struct ScalingCase {
  std::string of, with;
  std::vector<std::size_t> sizes;
  std::function<synth::SynthSpec(std::size_t)> spec;
  bool files = false;
};

synth::SynthSpec three_modes(std::size_t samples, double fs_Hz) {
  synth::SynthSpec spec{.name = "three-modes", .fs_Hz = fs_Hz, .samples = samples, .seed = 1};
  spec.modes = {{.freq_Hz = 182, .damping_ratio = 0.009, .residue_per_kg = {1}},
                {.freq_Hz = 622, .damping_ratio = 0.006, .residue_per_kg = {-1}},
                {.freq_Hz = 1265, .damping_ratio = 0.005, .residue_per_kg = {0.7}}};
  spec.sensors.assign(1, {});
  spec.hits = 2;
  spec.noise = {.force = 0, .accel = 0.01};
  return spec;
}

synth::SynthSpec small_file() {
  synth::SynthSpec spec = three_modes(256, 2048);
  spec.modes.resize(1);
  spec.pulse.width_s = 2e-3;
  spec.band_high_Hz = 600;
  return spec;
}

synth::SynthSpec many_modes(std::size_t modes) {
  synth::SynthSpec spec = spread_structure(modes, 2);
  for (synth::SynthMode& mode : spec.modes) mode.damping_ratio /= 2;  // keeps sixty modes separate
  return spec;
}

// A test of more than 250 channels repeats 250 channels with new noise.
synth::SynthSpec many_channels(std::size_t channels) {
  synth::SynthSpec spec = spread_structure(6, std::min<std::size_t>(channels, 250));
  spec.runs = channels / spec.sensors.size();
  return spec;
}

synth::SynthSpec many_hits(std::size_t hits) {
  synth::SynthSpec spec = spread_structure(6, 2);
  spec.hits = hits;
  return spec;
}

std::vector<ScalingCase> scaling_cases() {
  std::vector<std::size_t> samples;
  for (std::size_t power = 10; power <= 24; power += 2) samples.push_back(std::size_t{1} << power);
  return {{"samples per hit", "2 hits, 1 channel, 3 modes, 25 600 Hz", samples,
           [](std::size_t n) { return three_modes(n, 25600); }},
          {"channels", "3 hits of 8192 samples, 6 modes", {1, 3, 10, 30, 100, 250, 500, 1000}, many_channels},
          {"hits", "2 channels of 8192 samples, 6 modes", {1, 3, 10, 30, 100}, many_hits},
          {"modes", "3 hits of 8192 samples, 2 channels", {1, 3, 10, 30, 60}, many_modes},
          {"files",
           "CSV, 1 hit of 256 samples each, 1 channel, 1 mode",
           {1, 10, 100, 1000, 10000},
           [](std::size_t) { return small_file(); },
           true}};
}

acquire::Record opened(const std::vector<std::string>& paths) {
  std::vector<acquire::Record> records;
  records.reserve(paths.size());
  for (const std::string& path : paths) records.push_back(acquire::open_record(path));
  return acquire::join_records(std::move(records), acquire::FileGrouping::hits);
}

struct Cost {
  double seconds, bare_s, bytes;
  std::size_t modes;
};

// Runs in its own process: once for the memory; then, if that took less than min_total_s, in alternation with the
// baseline. Otherwise only the baseline runs again.
Cost cost_of(const std::vector<std::string>& paths, const synth::SynthSpec& spec, const TimingOptions& timing) {
  Cost cost{};
  const auto analyse = [&] {
    const pipeline::Analysis analysis(opened(paths),
                                      {.band_Hz = {{spec.band_low_Hz, spec.band_high_Hz}}, .threads = 1});
    cost.modes = analysis.classifications().size();
  };
  const double before_bytes = peak_memory_bytes();
  const double first_s = processor_s_of(analyse);
  cost.bytes = peak_memory_bytes() - before_bytes;
  const FftReadBaseline limit(paths, opened(paths));
  const bool again = first_s < timing.min_total_s;
  const auto best_s = best_interleaved_s({[&] { limit.run(); },
                                          [&] {
                                            if (again) analyse();
                                          }},
                                         timing);
  cost.bare_s = best_s[0];
  cost.seconds = again ? std::min(first_s, best_s[1]) : first_s;
  return cost;
}

double wall_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Writes the files and adds a measured point to `scaling`. Sets `writing_s` to the time of writing. Returns false when
// the analysis failed.
bool measure_at(std::size_t n, const ScalingCase& scaling_case, const TimingOptions& timing, Scaling& scaling,
                double& writing_s) {
  const double start_s = wall_s();
  const TemporaryFolder folder("percuss-accuracy");
  const synth::SynthSpec spec = scaling_case.spec(n);
  const auto paths = scaling_case.files ? many_files(spec, n, folder.path()) : one_file(spec, folder.path());
  writing_s = wall_s() - start_s;
  const auto cost = forked<Cost>([&] { return cost_of(paths, spec, timing); });
  if (!cost) return false;
  scaling.points.push_back({.n = static_cast<double>(n),
                            .seconds = cost->seconds,
                            .time_ratio = cost->seconds / cost->bare_s,
                            .peak_bytes = cost->bytes,
                            .modes = cost->modes,
                            .modes_sought = spec.modes.size()});
  return true;
}

void fit_exponents(Scaling& scaling) {
  std::vector<double> x, time_s, bytes;
  for (const ScalePoint& point : scaling.points) {
    x.push_back(point.n);
    time_s.push_back(point.seconds);
    bytes.push_back(point.peak_bytes);
  }
  scaling.time_exponent = growth_exponent(x, time_s);
  scaling.memory_exponent = growth_exponent(x, bytes);
}

Scaling measured_growth(const ScalingCase& scaling_case, Extent extent, const TimingOptions& timing, double budget_s) {
  Scaling scaling{.of = scaling_case.of, .with = scaling_case.with, .asked = scaling_case.sizes.back(), .points = {}};
  const double end_s = wall_s() + budget_s;
  double writing_s = 0;
  for (const std::size_t n : scaling_case.sizes) {
    if (!scaling.points.empty()) {
      const ScalePoint& last = scaling.points.back();
      const double larger = static_cast<double>(n) / last.n;
      const double next_s =
          writing_s * (scaling_case.files ? 1 : larger) + last.seconds * std::pow(larger, kExpectedExponent);
      if (wall_s() + next_s > end_s) break;
    }
    if (extent == Extent::quick && scaling.points.size() > 1) break;
    if (!measure_at(n, scaling_case, timing, scaling, writing_s)) break;
  }
  fit_exponents(scaling);
  return scaling;
}

}  // namespace

double growth_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.empty()) return 0;
  const double middle = std::sqrt(x.front() * x.back());
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < middle || !(y[i] > 0)) continue;
    const double u = std::log(x[i]), v = std::log(y[i]);
    ++n;
    sx += u;
    sy += v;
    sxx += u * u;
    sxy += u * v;
  }
  const double spread = n * sxx - sx * sx;
  return spread > 0 ? (n * sxy - sx * sy) / spread : 0;
}

std::vector<Scaling> study_scaling(Extent extent, const TimingOptions& timing, double budget_s) {
  const auto all = scaling_cases();
  std::vector<Scaling> scalings;
  scalings.reserve(all.size());
  for (const ScalingCase& scaling_case : all)
    scalings.push_back(measured_growth(scaling_case, extent, timing, budget_s / static_cast<double>(all.size())));
  return scalings;
}

}  // namespace percuss::accuracy
