#include <memory>

#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/compare_report.hpp"
#include "report/json/read_document.hpp"

namespace percuss::tools {
namespace {

constexpr double kPercent = 100;

struct CompareFlags {
  std::vector<std::string> paths;
  double furthest_percent = kPercent * metrics::PairOptions{}.furthest;
  double min_mac = metrics::PairOptions{}.min_mac;
  OutputFlags output;
};

int compare(const CompareFlags& flags) {
  check_report_outputs(flags.output);
  std::vector<metrics::ComparedDocument> documents;
  for (const std::string& path : flags.paths) {
    for (metrics::ComparedDocument& document : report::read_documents(path)) {
      document.name = with_display_names(flags.output.host, document.name);
      documents.push_back(std::move(document));
    }
  }
  if (documents.size() < 2) throw UsageError("one document cannot be compared", "name two or more");
  return show_report(
      report::compare_report(documents, {.furthest = flags.furthest_percent / kPercent, .min_mac = flags.min_mac}),
      flags.output, flags.paths);
}

}  // namespace

void add_compare(CommandLine& line) {
  auto flags = line.values<CompareFlags>();
  Command command = line.command("compare", "Modes or deflections of tests and models, side by side",
                                 [flags] { return compare(*flags); });
  command.about(
      "Pairs the modes of documents by frequency and shape, the first against each other, and shows the differences; "
      "or the deflections of two. The documents are what analyze, survey, deflect and model write with --json or -o "
      "FILE.json.");
  command.example("percuss compare test.json model.json", "A test beside a model");
  command.example("percuss compare test.json model.json --furthest 40 -o compared.csv",
                  "Pairs up to 40 % apart, as a table");
  command.words("FILE", flags->paths, "Documents that analyze, survey, deflect and model wrote with --json").required();
  command.value("--furthest", flags->furthest_percent, "Frequencies further apart than this are not of the same mode")
      .above_zero()
      .type("PERCENT")
      .show_default();
  command.value("--least-mac", flags->min_mac, "Shapes that agree less are not of the same mode")
      .within(0, 1)
      .type("MAC")
      .show_default();
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
