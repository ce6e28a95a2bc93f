#pragma once
#include "cli/command_line.hpp"

namespace percuss::tools {

// The commands of the group `model`, declared as in commands.hpp.
void add_model_beam(CommandLine& line);
void add_model_impact(CommandLine& line);
void add_model_rigid(CommandLine& line);
void add_model_trampoline(CommandLine& line);
void add_model_bat(CommandLine& line);
void add_model_shell(CommandLine& line);

}  // namespace percuss::tools
