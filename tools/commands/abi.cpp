#include <iostream>
#include <memory>

#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/abi_report.hpp"

namespace percuss::tools {
namespace {

struct AbiFlags {
  std::string log;
  std::optional<double> limit;
  bool example = false;
  OutputFlags output;
};

int follow_log(const AbiFlags& flags) {
  if (flags.example) {
    print(flags.output, metrics::abi_log_example());
    return kOk;
  }
  if (flags.log.empty()) throw UsageError("no log", "name its file, or - for standard input");
  check_report_outputs(flags.output);
  metrics::AbiLog log = metrics::read_abi_log(flags.log);
  if (flags.limit) log.limit = flags.limit;
  const metrics::AbiRun run = metrics::evaluate_abi(log);
  show_report(report::abi_report(log, run), flags.output, {flags.log});
  return run.verdict == metrics::AbiVerdict::fail ? kQualityGate : kOk;
}

}  // namespace

void add_abi(CommandLine& line) {
  auto flags = line.values<AbiFlags>();
  Command command = line.command("abi", "The break-in of a composite bat, from its log: what comes next, the verdict",
                                 [flags] { return follow_log(*flags); });
  command.about(
      "Follows the accelerated break-in of a composite bat by rolling. The log holds compressions, rollings and tests "
      "in their order; after each, it says what comes next. The bat passes once a test falls clearly below the best "
      "one, and fails when one exceeds the limit (exit status 5).");
  command.example("percuss abi --example > log.json; percuss abi log.json",
                  "A log to start from, explained, and what it says");
  command.example("percuss abi --example > log.json; percuss abi log.json -o break-in.svg",
                  "Performance and hoop frequency over the steps");
  command.word("LOG", flags->log, "What was done so far; - for standard input");
  command.value("--limit", flags->limit, "What the bat must not exceed, in place of the log's").above_zero();
  command.flag("--example", flags->example, "Print a log, explained");
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
