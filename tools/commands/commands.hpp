#pragma once
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/exit_code.hpp"

namespace percuss::tools {

// Each function declares a command: its options and the function that runs it. Commands write results and their
// warnings to standard output, progress and notes on the input to standard error. main() prints an InputError or
// UsageError as one line.
void add_info(CommandLine& line);
void add_analyze(CommandLine& line);
void add_frf(CommandLine& line);
void add_nodes(CommandLine& line);
void add_convert(CommandLine& line);
void add_calibrate(CommandLine& line);
void add_survey(CommandLine& line);
void add_compare(CommandLine& line);
void add_deflect(CommandLine& line);
void add_synth(CommandLine& line);
void add_model(CommandLine& line);  // a group: model_commands.hpp
void add_metrics(CommandLine& line);
void add_certify(CommandLine& line);
void add_abi(CommandLine& line);
void add_study(CommandLine& line);
void add_record(CommandLine& line);
void add_devices(CommandLine& line);
void add_batch(CommandLine& line);  // a group: batch_commands.hpp
void add_completion(CommandLine& line);
void add_man(CommandLine& line);  // last: it lists the pages of all other commands

/// Declares the program itself and its exit codes.
void add_program(CommandLine& line);

/// Declares the command that `first_word` names. If it names none, declares all commands; for --version, none.
void add_commands(CommandLine& line, std::string_view first_word);

}  // namespace percuss::tools
