#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/protocol/abi_log.hpp"
#include "metrics/protocol/certify.hpp"

namespace percuss::metrics {

/// Limits of the accelerated break-in (ABI), [8] in docs/theory/sources.md, appendix E, and the limits that end a run.
struct AbiRules {
  double min_reduction = 0.05;   // least reduction of the compression by rolling
  double skip_reduction = 0.15;  // above this reduction, the next test follows without rolling
  double pass_drop_besr = 0.014, pass_drop_bbcor = 0.018;
  double first_depth_in = 0.10, depth_step_in = 0.0125, depth_tolerance_in = 0.00625;
  double max_depth_in = 0.5;  // deeper rolling would deform any barrel for good
  int max_cycles = 50;
  double displacement_in = 0.03;  // of a compression
};

/// The steps of the procedure by their printed numbers; 6 and 8 are decisions, not actions.
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

/// A measured compression, and its reduction from the state to which it is compared:
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
  std::optional<double> hoop_Hz, z_in;
  std::string id;  // of the bat's state; the bat's id for the first test
};

enum class AbiVerdict { in_progress, pass, fail, undecided };
const char* name_of(AbiVerdict verdict);

/// The progress of a bat in the procedure.
struct AbiRun {
  AbiStep next = AbiStep::initial_compression;
  int cycle = 0, roll = 0;
  std::optional<double> depth_in;  // depth of the last rolling
  double displacement_in = 0;      // of every compression
  AbiVerdict verdict = AbiVerdict::in_progress;
  std::string why;  // the reason of the verdict
  std::vector<AbiReduction> compressions;
  std::vector<AbiCycle> cycles;
  std::vector<ProtocolFinding> remarks;
};

/// Evaluates a log from its start. Every entry must be the next step of the procedure. Step 9 uses (P14) like steps 3
/// and 5: its sign and denominator are reversed in print.
/// errors  InputError with entry and step: an entry out of order, an entry after the end, rollers less deep than
/// before, a compression by another displacement than before.
AbiRun evaluate_abi(const AbiLog& log, const AbiRules& rules = {});

/// The next depth of the rollers.
double next_depth_in(const AbiRun& run, const AbiRules& rules = {});

/// The next step as text: "step 4: roll the barrel, rollers about 0.1125 in deep, …".
std::string next_step_text(const AbiRun& run, const AbiRules& rules = {});

}  // namespace percuss::metrics
