#include <memory>
#include <optional>

#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
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
  std::optional<double> furthest_percent;
  double min_mac = metrics::PairOptions{}.min_mac;
  OutputFlags output;
};

int compare(const CompareFlags& flags) {
  check_report_outputs(flags.output);
  std::vector<metrics::ComparedDocument> documents;
  const std::vector<std::string> paths = matched_files(flags.paths);
  for (const std::string& path : paths) {
    for (metrics::ComparedDocument& document : report::read_documents(path)) {
      document.name = with_display_names(flags.output.host, document.name);
      documents.push_back(std::move(document));
    }
  }
  if (documents.size() < 2) throw OptionError({}, "one document cannot be compared", "name two or more");
  metrics::PairOptions options{.min_mac = flags.min_mac};
  if (flags.furthest_percent) options.furthest = options.furthest_of_orders = *flags.furthest_percent / kPercent;
  return show_report(report::compare_report(documents, options), flags.output, paths);
}

}  // namespace

void add_compare(CommandLine& line) {
  auto flags = line.values<CompareFlags>();
  Command command = line.command("compare", "Compare modes or deflections of tests and models side by side",
                                 [flags] { return compare(*flags); });
  command.about(
      "Pairs the modes of the first document with the modes of each other document, and shows the differences. Modes "
      "with three common places are paired by shape. The MAC compares the shapes at the common points, or the "
      "channels if there are fewer than three points. Points are matched by their coordinates, else by their numbers. "
      "Other modes are paired by family and order if both documents state them with 90 % confidence and the "
      "frequencies do not contradict. The remaining modes are paired by frequency, so that modes that crossed are "
      "exchanged. The output says which rule applied. Letters name the peaks of one order, as bending 3a and bending "
      "3b, the lowest first; they pair from below. Compares the deflections of two documents likewise. analyze, "
      "survey, deflect and model write such documents with --json.");
  command.example("percuss compare test.json model.json", "Compare a test with a model");
  command.example("percuss compare test.json model.json --furthest 40 -o compared.csv",
                  "Pair modes up to 40 % apart, and write a table");
  command.arguments("FILE", flags->paths, "Documents that analyze, survey, deflect and model wrote with --json")
      .required();
  command
      .value("--furthest", flags->furthest_percent,
             "Pair modes only if their frequencies differ by at most this much (default: 25, or 50 for modes of equal "
             "order)")
      .above_zero()
      .type("PERCENT");
  command.value("--least-mac", flags->min_mac, "Pair modes only if their MAC is at least this")
      .within(0, 1)
      .type("MAC")
      .show_default();
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
