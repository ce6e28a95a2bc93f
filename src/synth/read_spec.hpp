#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "synth/spec.hpp"

namespace percuss::synth {

/// The longest text of a spec. Readers of spec files read one byte more, so that parse_synth_spec reports a longer
/// file.
inline constexpr std::size_t kMaxSpec_bytes = std::size_t{4} << 20U;

/// Reads and checks a spec from JSON (docs/guides/synth.md; comments are allowed). `where` names the text in messages.
/// errors  InputError for an invalid spec: not JSON, too deep or too long, a key that is unknown, repeated, missing or
/// of the wrong kind, a value out of range.
SynthSpec parse_synth_spec(std::string_view text, std::string_view where);

struct SynthPreset {
  std::string_view name, text;
};

/// The specs in fixtures/, compiled into the library, ordered by name.
std::span<const SynthPreset> synth_presets();

/// Reads a preset by name.
/// errors  InputError with the list of names.
SynthSpec synth_preset(std::string_view name);

/// A spec with comments and every key. Keys that exclude another key stand in the comments.
std::string_view synth_example();

}  // namespace percuss::synth
