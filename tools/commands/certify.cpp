#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "metrics/protocol/performance.hpp"
#include "report/certify_report.hpp"

namespace percuss::tools {
namespace {

struct CertifyFlags {
  std::string session, metric;
  std::optional<double> limit;
  bool example = false, example_table = false, accept_plateau = false;
  OutputFlags output;
};

// A limit belongs to its metric: BESR, NCAA BESR and BBCOR have different scales.
void judge_by(const CertifyFlags& flags, metrics::Session& session) {
  const auto metric = metrics::performance_metric_named(flags.metric);
  if (metric && *metric != session.metric && session.limit && !flags.limit) {
    throw OptionError::wrong_value(
        "metric", flags.metric, fmt::format("state the limit of {}", flags.metric),
        fmt::format("the session's limit, {}, is a limit of {}", *session.limit, metrics::name_of(session.metric)),
        {"limit"});
  }
  if (metric) session.metric = *metric;
  if (flags.limit) session.limit = flags.limit;
}

int certify_session(const CertifyFlags& flags) {
  if (flags.example || flags.example_table) {
    print(flags.output, flags.example_table ? metrics::session_table_example() : metrics::session_example());
    return kOk;
  }
  if (flags.session.empty()) throw OptionError({}, "no session is given", "name its file, or - for standard input");
  check_report_outputs(flags.output);
  metrics::Session session = metrics::read_session(flags.session);
  judge_by(flags, session);
  const metrics::Certification certification = metrics::certify(session, {.accept_plateau = flags.accept_plateau});
  show_report(report::certify_report(session, certification), flags.output, {flags.session});
  return certification.verdict == metrics::CertifyVerdict::fail ? kQualityGate : kOk;
}

}  // namespace

void add_certify(CommandLine& line) {
  auto flags = line.values<CertifyFlags>();
  Command command = line.command("certify", "Check a bat's test session: valid shots, next impact position, verdict",
                                 [flags] { return certify_session(*flags); });
  command.about(
      "Checks a test session against its protocol: validates each shot, names the next impact position, finds the "
      "sweet spot and compares BESR or BBCOR with the limit. The exit code is 5 if the bat fails.");
  command.example("percuss certify --example > session.json; percuss certify session.json",
                  "Print an example session and check it");
  command.example(
      "percuss certify --example-table > session.csv; percuss certify session.csv --metric bbcor --limit 0.5",
      "Use a table as the session, and judge by BBCOR");
  command.argument("SESSION", flags->session, "Session so far: JSON or a table of shots; - is standard input");
  command.value("--metric", flags->metric, "Judge by this metric in place of the session's")
      .one_of({"besr", "ncaa_besr", "bbcor"});
  command.value("--limit", flags->limit, "Use this limit in place of the session's").within(0, metrics::kMaxLimit);
  command.flag("--accept-plateau", flags->accept_plateau,
               "Accept the best location within the margin as the sweet spot if no location stands out");
  command.flag("--example", flags->example, "Print an example session with comments");
  command.flag("--example-table", flags->example_table, "Print an example session as a table");
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
