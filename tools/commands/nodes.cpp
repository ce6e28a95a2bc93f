#include <fmt/format.h>

#include <memory>

#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/units.hpp"
#include "pipeline/node_scan.hpp"
#include "report/json/analysis_json.hpp"
#include "report/nodes_report.hpp"

namespace percuss::tools {
namespace {

// Resolution of the position of the smallest peak, which the rule of thumb takes as the node.
constexpr double kResolution_m = 0.125 * kInch_m;

struct NodesFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::string positions;
};

// "3:0.25:9", "3:0.25:9in", "80:5:250mm"
pipeline::ScanPositions parse_positions(const std::string& text) {
  const char* const remedy =
      "give START:STEP:END with a unit (in, m, mm, cm, ft), such as 3:0.25:9in; without a unit, inches";
  const auto [range, name] = parse_range_with_unit("positions", text, remedy);
  double to_m = kInch_m;
  if (!name.empty()) {
    const auto unit = parse_unit(name);
    if (!unit || unit->quantity != Quantity::length)
      throw OptionError::wrong_value("positions", text, remedy, "its unit does not measure length");
    to_m = unit->to_SI;
  }
  return {.start_m = range.low * to_m, .step_m = range.step * to_m, .count = range.count};
}

// `assumed`: the record does not state the points of its hits.
std::unique_ptr<pipeline::Analysis> analysis_of(const NodesFlags& flags, const pipeline::ScanPositions& positions,
                                                bool& assumed) {
  const acquire::FileGrouping grouping =
      flags.read.files == acquire::FileGrouping::automatic ? acquire::FileGrouping::points : flags.read.files;
  if (grouping == acquire::FileGrouping::tests)
    throw OptionError::wrong_value("files", "tests", "give points, or the files of one scan", "a scan is one test");
  const pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty())
    return std::make_unique<pipeline::Analysis>(join_frfs_of(flags.read, std::move(opened.frfs)), options);
  acquire::Record record = acquire::join_records(std::move(opened.records), grouping);
  assumed = record.points().size() != positions.count;
  return std::make_unique<pipeline::Analysis>(pipeline::as_scan(std::move(record), positions), options);
}

int nodes(const NodesFlags& flags) {
  const pipeline::ScanPositions positions = parse_positions(flags.positions);
  check_outputs(flags.output, {".json", ".svg", ".html"});
  const Progress progress("analysing", flags.output.quiet);
  bool assumed = false;
  const std::shared_ptr<const pipeline::Analysis> opened = analysis_of(flags, positions, assumed);
  if (flags.output.host != nullptr) flags.output.host->outcome.analyses = {opened};
  const pipeline::Analysis& analysis = *opened;
  analysis.hits();
  if (!analysis.possible()) {
    progress.stop();
    print(flags.output, report::analysis_json(analysis, {.sections = {report::ReportSection::hits}}));
    return kImpossible;
  }
  const pipeline::NodeScan scan = pipeline::scan_nodes(analysis, positions, kResolution_m, assumed);
  progress.stop();
  return show_report(report::nodes_report(analysis, scan), flags.output, inputs_of(analysis));
}

}  // namespace

void add_nodes(CommandLine& line) {
  auto flags = line.values<NodesFlags>();
  Command command = line.command("nodes", "Locate the nodes of bending modes from a scan of impacts",
                                 [flags] { return nodes(*flags); });
  command.about(
      "Locates the nodes of each bending mode along the barrel, with standard deviations, from hits at evenly "
      "spaced positions. Each point, or each file, is one position. A node lies where the response of the mode changes "
      "sign.");
  command.example("percuss nodes scan.h5 --positions 3:0.25:9in --band 60:1500",
                  "Use hits every quarter of an inch, from 3 to 9 in from the end of the barrel");
  command.example("percuss nodes scan.h5 --positions 76.2:6.35:228.6mm --band 60:1500 -o nodes.svg",
                  "State positions in millimetres, and draw the curves");
  command
      .value("--positions", flags->positions,
             "Set the positions of the hits from the end of the barrel, in the order of points or files; in inches "
             "unless a unit (in, m, mm, cm, ft) follows")
      .required()
      .type("START:STEP:END[UNIT]");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, ".json, .svg, .html");
}

}  // namespace percuss::tools
