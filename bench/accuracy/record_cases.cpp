#include "record_cases.hpp"

#include <fmt/format.h>

#include <cmath>

#include "synth/random_stream.hpp"
#include "synth/read_spec.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::size_t kMainRuns = 64, kRuns = 16, kQuickRuns = 2;
constexpr double kMainNoise = 0.01;
constexpr std::uint64_t kPurpose = 0xACC;  // of the random streams

// The spec states noise relative to the RMS over the record, which falls with the record's length. The correction keeps
// the noise of the sensor constant.
synth::SynthSpec main_bat(double length_s = 1, double noise = kMainNoise, double force_noise = 0) {
  synth::SynthSpec spec = synth::synth_preset("composite-bat");
  spec.samples = static_cast<std::size_t>(std::lround(length_s * spec.fs_Hz));
  spec.noise = {.force = force_noise, .accel = noise * std::sqrt(length_s)};
  return spec;
}

class Sweeper {
 public:
  explicit Sweeper(Extent extent) : extent_(extent) {}

  void begin(std::string over) { sweeps_.push_back({std::move(over), {}}); }
  // Quick: the main case and one case of each sweep.
  void add(std::string value, synth::SynthSpec spec, bool main = false) {
    if (extent_ == Extent::quick && !main && !sweeps_.back().cases.empty()) return;
    spec.runs = extent_ == Extent::quick ? kQuickRuns : main ? kMainRuns : kRuns;
    sweeps_.back().cases.push_back({std::move(value), std::move(spec)});
  }
  std::vector<RecordSweep> take() { return std::move(sweeps_); }

 private:
  Extent extent_;
  std::vector<RecordSweep> sweeps_;
};

}  // namespace

synth::SynthSpec spread_structure(std::size_t modes, std::size_t channels) {
  synth::SynthSpec spec{.name = "spread", .fs_Hz = 8192, .samples = 8192, .seed = 1};
  spec.hits = 3;
  spec.noise = {.force = 0, .accel = kMainNoise};
  spec.sensors.assign(channels, {});
  for (std::size_t c = 0; c < channels; ++c)
    spec.sensors[c].position_m = 0.8 * static_cast<double>(c) / static_cast<double>(channels);
  synth::RandomStream random({kPurpose, modes, channels});
  const double step_Hz = 2850 / static_cast<double>(modes);
  for (std::size_t m = 0; m < modes; ++m) {
    synth::SynthMode mode{.freq_Hz = 150 + step_Hz * (static_cast<double>(m) + random.uniform(0.3, 0.7)),
                          .damping_ratio = random.uniform(0.002, 0.005)};
    for (std::size_t c = 0; c < channels; ++c)
      mode.residue_per_kg.push_back((random.uniform() < 0.5 ? -1 : 1) * random.uniform(0.3, 1.5));
    spec.modes.push_back(std::move(mode));
  }
  return spec;
}

std::vector<RecordSweep> record_sweeps(Extent extent) {
  Sweeper sweeper(extent);
  sweeper.begin("noise");
  for (const double noise : {0.0001, 0.001, 0.01, 0.03, 0.1})
    sweeper.add(fmt::format("{:g} %", 100 * noise), main_bat(1, noise), noise == kMainNoise);
  sweeper.begin("noise of the force");
  for (const double noise : {1e-3, 1e-4, 1e-5})
    sweeper.add(fmt::format("{:g} %", 100 * noise), main_bat(1, 0.01, noise));
  sweeper.begin("record length");
  for (const double length_s : {0.125, 0.25, 0.5, 2.0, 4.0})
    sweeper.add(fmt::format("{:g} s", length_s), main_bat(length_s));
  sweeper.begin("modes");
  for (const std::size_t modes : {1U, 3U, 10U, 30U})
    sweeper.add(fmt::format("{} mode{}", modes, modes == 1 ? "" : "s"), spread_structure(modes, 2));
  sweeper.begin("channels");
  for (const std::size_t channels : {1U, 4U, 16U, 64U})
    sweeper.add(fmt::format("{} channel{}", channels, channels == 1 ? "" : "s"), spread_structure(6, channels));
  return sweeper.take();
}

}  // namespace percuss::accuracy
