#include <optional>

#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "metrics/protocol/performance.hpp"
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
  if (flags.log.empty()) throw OptionError({}, "no log is given", "name its file, or - for standard input");
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
  Command command = line.command("abi", "Follow the break-in of a composite bat from its log: next step and verdict",
                                 [flags] { return follow_log(*flags); });
  command.about(
      "Evaluates the accelerated break-in of a composite bat by rolling. The log lists compressions, rollings and "
      "tests in order; the report names the next step. The bat passes when the result of a test falls clearly below "
      "the best one. It fails when a result exceeds the limit, or when the first test damages the bat (exit code 5).");
  command.example("percuss abi --example > log.json; percuss abi log.json", "Print an example log and evaluate it");
  command.example("percuss abi --example > log.json; percuss abi log.json -o break-in.svg",
                  "Plot performance and hoop frequency over the performance tests");
  command.argument("LOG", flags->log, "Log of the steps so far; - is standard input");
  command.value("--limit", flags->limit, "Use this limit in place of the log's").within(0, metrics::kMaxLimit);
  command.flag("--example", flags->example, "Print an example log with comments");
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
