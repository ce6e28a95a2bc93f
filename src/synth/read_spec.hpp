#pragma once
#include <span>
#include <string>
#include <string_view>

#include "synth/spec.hpp"

namespace percuss::synth {

/// A spec from JSON (docs/guides/synth.md; comments are allowed), checked. `where` names the text in messages.
/// errors  InputError for anything but a valid spec: not JSON, too deep or too long, a key unknown, doubled, missing or
/// of the wrong kind, a value out of range.
SynthSpec parse_synth_spec(std::string_view text, std::string_view where);

struct SynthPreset {
  std::string_view name, text;
};

/// The specs in fixtures/, built into the program, in order of their names.
std::span<const SynthPreset> synth_presets();

/// A preset by name. InputError lists the names there are.
SynthSpec synth_preset(std::string_view name);

/// A spec with every key in use and a comment on each.
std::string_view synth_example();

}  // namespace percuss::synth
