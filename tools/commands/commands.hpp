#pragma once
#include <string_view>

#include "cli/command_line.hpp"

namespace percuss::tools {

/// Exit codes of the tool, a contract with users' scripts.
enum ExitCode {
  kOk = 0,
  kInternalError = 1,
  kUsage = 2,
  kBadInput = 3,
  kImpossible = 4,
  kQualityGate = 5,
  kPartial = 6
};

// Each declares a command: its options, and what to run. Commands write data to stdout, progress and warnings to
// stderr, and throw InputError or UsageError, which main turns into one line and its exit code.
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
void add_model_beam(CommandLine& line);
void add_model_impact(CommandLine& line);
void add_model_rigid(CommandLine& line);
void add_model_trampoline(CommandLine& line);
void add_model_bat(CommandLine& line);
void add_model_shell(CommandLine& line);
void add_metrics(CommandLine& line);
void add_certify(CommandLine& line);
void add_abi(CommandLine& line);
void add_study(CommandLine& line);
void add_batch(CommandLine& line);  // a group: declares those that follow
void add_batch_plan(CommandLine& line);
void add_batch_run(CommandLine& line);
void add_batch_status(CommandLine& line);
void add_batch_merge(CommandLine& line);
void add_batch_submit(CommandLine& line);
void add_completion(CommandLine& line);
void add_man(CommandLine& line);  // last: it offers the pages of all

/// What the program itself is, and its exit codes.
void add_program(CommandLine& line);

/// Those of the above that `first_word` may be about.
void add_commands(CommandLine& line, std::string_view first_word);

}  // namespace percuss::tools
