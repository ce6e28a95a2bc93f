#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "core/error.hpp"
#include "model/beam/beam.hpp"

namespace percuss::tools {

/// The beam's options, which `model beam` and `model impact` share.
struct BeamFlags {
  std::string support = "torsion";
  std::optional<double> stiffness_Nm2, mass_per_length_kgpm, torsion_Nmprad;
  double length_m = model::UniformBeam().length_m;
  std::vector<std::string> layers;
};

void add_beam_flags(Command& command, BeamFlags& flags);

/// The beam that they describe, the composite bat where they say nothing. UsageError where they contradict each other.
model::UniformBeam beam_of(const BeamFlags& flags);

/// "1200:0.5:3e-3": least to most finite numbers above zero, with colons between. UsageError names option and text, and
/// ends in `remedy`.
std::vector<double> parse_colon_list(const OptionId& option, const std::string& text, std::size_t least,
                                     std::size_t most, const char* remedy);

}  // namespace percuss::tools
