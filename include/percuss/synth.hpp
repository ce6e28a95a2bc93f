#pragma once
/// Synthetic hammer tests whose modes are exactly known: for learning, and for testing programs.
///
/// @code
/// #include <iostream>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::SynthTest test = percuss::synthesise({
///       .modes = {{.freq_Hz = 180, .damping_ratio = 0.01}, {.freq_Hz = 620, .damping_ratio = 0.006, .order = 2}},
///       .hits = 3,
///       .accel_noise = 1e-3,
///   });
///   std::cout << test.record.rows() << " hits; the first mode is at " << test.modes.at(0).freq_Hz << " Hz\n";
///   for (const std::string& name : percuss::synth_presets()) std::cout << name << '\n';
/// }
/// @endcode
#include <percuss/modes.hpp>
#include <percuss/record.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace percuss {

struct SynthMode {
  double freq_Hz = 0, damping_ratio = 0;
  ModeType type = ModeType::bending;  // bending or hoop
  int order = 1;                      // bending: of the free-free beam; hoop: axial half-waves
  double angle_rad = 0;               // plane of bending; an antinode of the hoop pattern
  double amplitude_per_sqrt_kg = 1;   // mass-normalised shape at the knob (bending), at the antinode (hoop)
};

/// The place of a sensor or of a point to hit: distance from the barrel's end, and angle around the barrel.
struct SynthPlace {
  double position_m = 0, angle_rad = 0;
};

/// The main values of a test of a free bat. synthesise_json takes more values: docs/guides/synth.md describes them.
struct SynthSpec {
  double fs_Hz = 25600;
  std::size_t samples = 25600;  // per hit
  std::vector<SynthMode> modes{};
  std::vector<SynthPlace> sensors{{.position_m = 0.0508}, {.position_m = 0.0508, .angle_rad = 1.5707963267948966}};
  std::vector<SynthPlace> points{{.position_m = 0.1524}};  // several: roving hammer
  std::size_t hits = 5;                                    // per point
  double peak_N = 300, pulse_s = 0.3e-3;                   // haversine; peaks spread by ±25 %, widths by ±10 %
  double force_noise = 0;                                  // standard deviation as a fraction of the largest force
  double accel_noise = 0;                                  // standard deviation as a fraction of the RMS of the channel
  std::uint64_t seed = 0;
};

struct SynthTest {
  Record record;
  std::vector<SynthMode> modes;  // the truth
  std::string truth_json;        // the document percuss/synth-truth/1
};

/// Equal specs and seeds give equal samples. errors  InputError: a value out of range.
SynthTest synthesise(const SynthSpec& spec);

struct SynthOptions {
  std::optional<std::uint64_t> seed{};  // of the noise and of the hits; default: the spec's
  std::size_t threads = 0;              // 0: all; the samples do not depend on it
};

/// Names of the built-in specs: "composite-bat", "wood-bat", …
std::vector<std::string> synth_presets();
/// errors  InputError: no such preset.
SynthTest synthesise_preset(const std::string& name, const SynthOptions& options = {});
/// From the text of a spec, as `percuss synth --example` prints one. errors  InputError: not a valid spec.
SynthTest synthesise_json(const std::string& spec, const SynthOptions& options = {});

}  // namespace percuss
