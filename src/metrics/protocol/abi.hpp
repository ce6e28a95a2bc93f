#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/protocol/abi_log.hpp"
#include "metrics/protocol/certify.hpp"

namespace percuss::metrics {

/// Gates of the break-in, [8] in docs/theory/sources.md, appendix E, and where a run that leads nowhere is given up.
struct AbiRules {
  double min_reduction = 0.05;   // that rolling is to reach
  double skip_reduction = 0.15;  // above it the barrel is not rolled before the next test
  double pass_drop_besr = 0.014, pass_drop_bbcor = 0.018;
  double first_depth_in = 0.10, depth_step_in = 0.0125, depth_tolerance_in = 0.00625;
  double max_depth_in = 0.5;  // no barrel is a barrel beyond
  int max_cycles = 50;
};

/// The procedure's steps by their printed numbers; 6 and 8 are decisions, not things to do.
enum class AbiStep {
  initial_compression = 1,
  first_performance = 2,
  compression_after_first = 3,
  roll = 4,
  compression_after_roll = 5,
  performance = 7,
  compression_after_performance = 9,
  done = 0
};

/// A compression as measured, and how much it fell since the state it is held against:
///   Δ = (BC_before − BC)/BC_before                                                             (P14)
struct AbiReduction {
  AbiStep step = AbiStep::initial_compression;
  int cycle = 0, roll = 0;  // i and j of BC_i,j; cycle 0 is BC_0
  double mean_lbf = 0;
  std::optional<double> reduction;
};

struct AbiCycle {
  int cycle = 0;
  double value = 0, best = 0;  // best: the highest so far
  std::optional<double> hoop_Hz;
};

enum class AbiVerdict { in_progress, pass, fail, undecided };
const char* name_of(AbiVerdict verdict);

/// How far a bat has come.
struct AbiRun {
  AbiStep next = AbiStep::initial_compression;
  int cycle = 0, roll = 0;
  std::optional<double> depth_in;  // of the last rolling
  AbiVerdict verdict = AbiVerdict::in_progress;
  std::string why;  // the verdict, in words
  std::vector<AbiReduction> compressions;
  std::vector<AbiCycle> cycles;
  std::vector<ProtocolFinding> remarks;
};

/// Follows a log from its start; every entry must be what the procedure asks for. Step 9 is followed as steps 3 and 5
/// are written, (P14): in print its sign and denominator are reversed. errors  InputError naming entry and step:
/// another thing was done than comes next, something was done after the end, the rollers were brought in less than
/// before.
AbiRun evaluate_abi(const AbiLog& log, const AbiRules& rules = {});

/// The rollers' next depth.
double next_depth_in(const AbiRun& run, const AbiRules& rules = {});

/// What comes next in words: "step 4: roll the barrel, rollers 0.1125 in in".
std::string next_step_text(const AbiRun& run, const AbiRules& rules = {});

}  // namespace percuss::metrics
