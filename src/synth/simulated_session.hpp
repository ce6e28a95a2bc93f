#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/live/device.hpp"
#include "synth/spec.hpp"

namespace percuss::synth {

enum class BlowKind { good, weak, double_hit, clipped, late };

struct SimulatedBlow {
  double onset_s = 0;
  std::size_t point = 0;  // of the spec
  BlowKind kind = BlowKind::good;
};

struct SimulatedPeriod {
  double from_s = 0, for_s = 0;
};

/// A session of hammer blows on the structure of a spec, with faults at stated times: the text after "sim:",
///   SPEC[,OPTION[=VALUE]]…           docs/guides/recording-devices.md lists the options
/// Blows come one after another, spec.hits (or hits=N) good or late ones at each point; a weak, double or clipped blow
/// is an extra one. Blows count from 1.
struct SimulatedSession {
  SynthSpec spec;
  std::vector<SimulatedBlow> blows;  // ascending onsets, except for late blows
  std::vector<SimulatedPeriod> gaps, overruns, overloads, no_numbers, dropouts;
  std::optional<double> rate_change_s, unplug_s;
  double end_s = 0;                          // the device finishes
  std::vector<std::size_t> silent_channels;  // from 0
  std::size_t accels = 0;                    // acceleration channels; sensors of the spec repeat
  bool numbered = false;                     // a last channel counts the frames, modulo 2^24
  double speed = 1;                          // times real time
  bool fast = false;                         // as fast as the reader
};

/// errors  InputError: an unknown preset or option, a value out of range; as parse_synth_spec
SimulatedSession parse_simulated_session(std::string_view text, const acquire::DeviceOptions& options = {});

}  // namespace percuss::synth
