#pragma once
#include <CLI/CLI.hpp>
#include <functional>

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

/// What to run once the command line is understood; returns an ExitCode. A command's `add_…` declares its options on
/// `app` and, when the user chose it, sets `run`. Commands write data to stdout, progress and warnings to stderr, and
/// throw InputError or UsageError, which main turns into one line and its exit code.
using Run = std::function<int()>;

void add_info(CLI::App& app, Run& run);
void add_analyze(CLI::App& app, Run& run);
void add_frf(CLI::App& app, Run& run);
void add_nodes(CLI::App& app, Run& run);
void add_calibrate(CLI::App& app, Run& run);
void add_survey(CLI::App& app, Run& run);
void add_synth(CLI::App& app, Run& run);

}  // namespace percuss::tools
