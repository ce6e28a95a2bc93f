#include <iostream>
#include <memory>

#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/certify_report.hpp"

namespace percuss::tools {
namespace {

struct CertifyFlags {
  std::string session, metric;
  std::optional<double> limit;
  bool example = false, example_table = false, accept_plateau = false;
  OutputFlags output;
};

int certify_session(const CertifyFlags& flags) {
  if (flags.example || flags.example_table) {
    print(flags.output, flags.example_table ? metrics::session_table_example() : metrics::session_example());
    return kOk;
  }
  if (flags.session.empty()) throw UsageError("no session", "name its file, or - for standard input");
  check_report_outputs(flags.output);
  metrics::Session session = metrics::read_session(flags.session);
  if (!flags.metric.empty()) session.metric = *metrics::performance_metric_named(flags.metric);
  if (flags.limit) session.limit = flags.limit;
  const metrics::Certification certification = metrics::certify(session, {.accept_plateau = flags.accept_plateau});
  show_report(report::certify_report(session, certification), flags.output, {flags.session});
  return certification.verdict == metrics::CertifyVerdict::fail ? kQualityGate : kOk;
}

}  // namespace

void add_certify(CommandLine& line) {
  auto flags = line.values<CertifyFlags>();
  Command command = line.command("certify", "A bat's test session: which shots count, where to shoot next, the verdict",
                                 [flags] { return certify_session(*flags); });
  command.about(
      "Follows a test session against its protocol: checks each shot, says where to shoot next, finds the sweet spot "
      "and gives the verdict: BESR or BBCOR against the limit. Exit status 5: the bat exceeds it.");
  command.example("percuss certify --example > session.json; percuss certify session.json",
                  "A session to start from, explained, and what it says");
  command.example(
      "percuss certify --example-table > session.csv; percuss certify session.csv --metric bbcor --limit 0.5",
      "The same as a table, judged by BBCOR");
  command.word("SESSION", flags->session, "The session so far: JSON or a table of shots; - for standard input");
  command.value("--metric", flags->metric, "Judge by this in place of the session's")
      .one_of({"besr", "ncaa_besr", "bbcor"});
  command.value("--limit", flags->limit, "What it must not exceed, in place of the session's").above_zero();
  command.flag("--accept-plateau", flags->accept_plateau,
               "Where no location stands out, take the best of those within the margin for the sweet spot");
  command.flag("--example", flags->example, "Print a session, explained");
  command.flag("--example-table", flags->example_table, "Print a session as a table");
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
