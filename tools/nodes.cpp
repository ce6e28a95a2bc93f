#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>

#include "acquire/atomic_file.hpp"
#include "analysis_flags.hpp"
#include "command.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "output.hpp"
#include "pipeline/node_scan.hpp"
#include "progress.hpp"
#include "read_flags.hpp"
#include "report/analysis_json.hpp"
#include "report/nodes_report.hpp"

namespace percuss::tools {
namespace {

constexpr double kResolution_m = 0.125 * kInch_m;  // to which the rule of thumb is read
constexpr double kMostPositions = 10000;
constexpr double kWholeSteps = 1e-6;  // of a step: how exactly END must be reached

struct NodesFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::string positions;
};

[[noreturn]] void refuse(const std::string& text, const char* problem) {
  throw UsageError("--positions " + one_line(text, 80) + ": " + problem,
                   "give START:STEP:END with a unit (in, m, mm, cm, ft), as 3:0.25:9in; inches where there is none");
}

// "3:0.25:9", "3:0.25:9in", "80:5:250mm"
ScanPositions parse_positions(const std::string& text) {
  std::array<double, 3> number{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ':')) refuse(text, "not three numbers with colons between");
    const auto [after, error] = std::from_chars(at, end, number.at(i));
    if (error != std::errc{} || !std::isfinite(number.at(i))) refuse(text, "not three numbers with colons between");
    at = after;
  }
  double to_m = kInch_m;
  if (at != end) {
    const auto unit = parse_unit({at, static_cast<std::size_t>(end - at)});
    if (!unit || unit->quantity != Quantity::length) refuse(text, "the unit is not one of length");
    to_m = unit->to_SI;
  }
  const auto [start, step, stop] = number;
  if (!(step > 0) || !(stop > start)) refuse(text, "the step must be above zero and END above START");
  const double steps = (stop - start) / step;
  if (steps >= kMostPositions) refuse(text, "more than 10000 positions");
  if (std::abs(steps - std::round(steps)) > kWholeSteps) refuse(text, "END is not a whole number of steps from START");
  return {.start_m = start * to_m, .step_m = step * to_m, .count = static_cast<std::size_t>(std::lround(steps)) + 1};
}

std::unique_ptr<Analysis> analysis_of(const NodesFlags& flags, const ScanPositions& positions) {
  const FilesMean mean = flags.read.files == FilesMean::automatic ? FilesMean::points : flags.read.files;
  if (mean == FilesMean::tests)
    throw UsageError("several tests do not make one scan", "give --files points, or the files of one scan");
  const AnalysisOptions options = analysis_options(flags.analysis);
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty())
    return std::make_unique<Analysis>(join_frfs_of(flags.read, std::move(opened.frfs)), options);
  return std::make_unique<Analysis>(as_scan(join_records(std::move(opened.records), mean), positions), options);
}

int nodes(const NodesFlags& flags) {
  const ScanPositions positions = parse_positions(flags.positions);
  check_outputs(flags.output, {".json"});
  const Progress progress("analysing", flags.output.quiet);
  const auto opened = analysis_of(flags, positions);
  const Analysis& analysis = *opened;
  analysis.hits();
  if (!analysis.possible()) {
    progress.stop();
    std::cout << analysis_json(analysis, {.sections = {Section::hits}});
    return kImpossible;
  }
  const NodeScan scan = scan_nodes(analysis, positions, kResolution_m);
  progress.stop();
  const std::string document = nodes_json(analysis, scan);
  for (const std::string& path : flags.output.paths) write_file(path, document, flags.output.force);
  std::cout << (flags.output.json ? document : nodes_text(analysis, scan, terminal_width()));
  return kOk;
}

}  // namespace

void add_nodes(CommandLine& line) {
  auto flags = std::make_shared<NodesFlags>();
  Command command = line.command("nodes", "Where bending modes have their nodes, from a scan of impacts",
                                 [flags] { return nodes(*flags); });
  command.example("percuss nodes scan.h5 --positions 3:0.25:9in");
  command
      .value("--positions", flags->positions,
             "Where the hits of the scan were, from the barrel's end, in the order of points or files; inches "
             "unless a unit (in, m, mm) follows")
      .required()
      .type("START:STEP:END[UNIT]");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output);
}

}  // namespace percuss::tools
