#pragma once
#include "cli/command_line.hpp"

namespace percuss::tools {

// The commands of the group `batch`, declared as in commands.hpp.
void add_batch_plan(CommandLine& line);
void add_batch_run(CommandLine& line);
void add_batch_status(CommandLine& line);
void add_batch_merge(CommandLine& line);
void add_batch_submit(CommandLine& line);

}  // namespace percuss::tools
