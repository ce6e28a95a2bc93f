#include "percuss/synth.hpp"

#include <utility>

#include "api/handles.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"
#include "synth/truth_json.hpp"

namespace percuss {
namespace api {
namespace {

synth::SynthMode internal_mode(const SynthMode& mode) {
  return {.freq_Hz = mode.freq_Hz,
          .damping_ratio = mode.damping_ratio,
          .type = mode.type == ModeType::hoop ? synth::SynthModeType::hoop : synth::SynthModeType::bending,
          .order = mode.order,
          .angle_rad = mode.angle_rad,
          .amplitude_per_sqrt_kg = mode.amplitude_per_sqrt_kg};
}

SynthMode public_mode(const synth::SynthMode& mode) {
  return {.freq_Hz = mode.freq_Hz,
          .damping_ratio = mode.damping_ratio,
          .type = mode.type == synth::SynthModeType::hoop ? ModeType::hoop : ModeType::bending,
          .order = mode.order,
          .angle_rad = mode.angle_rad,
          .amplitude_per_sqrt_kg = mode.amplitude_per_sqrt_kg};
}

synth::SynthSpec internal_spec(const SynthSpec& spec) {
  synth::SynthSpec out;
  out.fs_Hz = spec.fs_Hz;
  out.samples = spec.samples;
  for (const SynthMode& mode : spec.modes) out.modes.push_back(internal_mode(mode));
  out.sensors.clear();
  for (const SynthPlace& at : spec.sensors)
    out.sensors.push_back({.position_m = at.position_m, .angle_rad = at.angle_rad});
  out.points.clear();
  for (const SynthPlace& at : spec.points)
    out.points.push_back({.position_m = at.position_m, .angle_rad = at.angle_rad});
  out.hits = spec.hits;
  out.pulse.peak_N = spec.peak_N;
  out.pulse.width_s = spec.pulse_s;
  out.noise = {.force = spec.force_noise, .accel = spec.accel_noise};
  out.seed = spec.seed;
  return out;
}

// The test of this specification, with the seed and the threads of `options`.
SynthTest made(synth::SynthSpec spec, const SynthOptions& options) {
  spec.seed = options.seed.value_or(spec.seed);
  synth::SyntheticTest test = synth::synthesise(spec, options.threads);
  SynthTest out{
      .record = make_record(std::move(test.record)), .modes = {}, .truth_json = synth::truth_json(test.truth)};
  for (const synth::SynthMode& mode : spec.modes) out.modes.push_back(public_mode(mode));
  return out;
}

}  // namespace
}  // namespace api

SynthTest synthesise(const SynthSpec& spec) { return api::made(api::internal_spec(spec), {}); }

std::vector<std::string> synth_presets() {
  std::vector<std::string> out;
  for (const synth::SynthPreset& preset : synth::synth_presets()) out.emplace_back(preset.name);
  return out;
}

SynthTest synthesise_preset(const std::string& name, const SynthOptions& options) {
  return api::made(synth::synth_preset(name), options);
}

SynthTest synthesise_json(const std::string& spec, const SynthOptions& options) {
  return api::made(synth::parse_synth_spec(spec, "spec"), options);
}

}  // namespace percuss
