#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/option_units.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "commands/survey_files.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"
#include "pipeline/node_scan.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/json/analysis_json.hpp"
#include "report/nodes_report.hpp"

namespace percuss::tools {
namespace {

// The position with the smallest peak of a mode is rounded to this step. A rule of thumb takes it as the node.
constexpr double kResolution_m = 0.125 * kInch_m;

struct NodesFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::optional<std::string> positions;
};

// Limits of positions whose unit is not stated: a scan in metres extends over less than 1, and no bat is 60 in long.
constexpr double kMinExtent_in = 1, kMaxPosition_in = 60;

constexpr const char* kPositionsRemedy =
    "give START:STEP:END or a list, with a unit (in, m, mm, cm, ft), such as 3:0.25:9in or 3,3.5,5in; without a unit, "
    "inches";

double to_metres(std::string_view unit_name, const std::string& text) {
  if (unit_name.empty()) return kInch_m;
  const auto unit = parse_unit(unit_name);
  if (unit && unit->quantity == Quantity::length) return unit->to_SI;
  throw OptionError::wrong_value("positions", text, kPositionsRemedy, "its unit does not measure length");
}

// Refuses positions without a unit that are hardly inches: within one inch they are probably metres, beyond five feet
// millimetres.
void check_plausible_inches(double low, double high, const std::string& text) {
  const bool close = high - low < kMinExtent_in;
  const bool far = high > kMaxPosition_in;
  if (!close && !far) return;
  throw OptionError::wrong_value(
      "positions", text, "state the unit, such as 0.15:0.01:0.3m or 6:0.5:9in",
      fmt::format("without a unit they are inches, and {}", close ? "these lie within one inch" : "no bat is so long"));
}

// "3,3.5,5in": the last unit holds for the numbers without one.
pipeline::ScanPositions parse_list(const std::string& text) {
  std::vector<double> numbers;
  std::vector<std::string_view> units;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const NumberAndUnit piece = split_unit(std::string_view(text).substr(from, end - from));
    const ParsedNumber number = parse_number(piece.number, false);
    if (number.problem != NumberProblem::none)
      throw OptionError::wrong_value("positions", text, kPositionsRemedy,
                                     "it is neither a range nor a list of numbers");
    numbers.push_back(number.value);
    units.push_back(piece.unit);
    from = end + 1;
  }
  if (numbers.size() < 2) throw OptionError::wrong_value("positions", text, kPositionsRemedy, "it is one position");
  if (std::all_of(units.begin(), units.end(), [](std::string_view unit) { return unit.empty(); })) {
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    check_plausible_inches(*low, *high, text);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] *= to_metres(units[i].empty() ? units.back() : units[i], text);
  return pipeline::repeated_positions(numbers);
}

// "3:0.25:9", "3:0.25:9in", "80:5:250mm", "3,3.5,5in"
pipeline::ScanPositions parse_positions(const std::string& text) {
  if (text.find(':') == std::string::npos) return parse_list(text);
  const auto [range, name] = parse_range_with_unit("positions", text, kPositionsRemedy);
  if (name.empty()) check_plausible_inches(range.low, range.high(), text);
  const double to_m = to_metres(name, text);
  return {.start_m = range.low * to_m, .step_m = range.step * to_m, .count = range.count};
}

struct OpenScan {
  std::shared_ptr<const pipeline::Analysis> analysis;
  pipeline::ScanPositions positions;
  bool assumed_points = false;  // the record does not state the points of its hits
};

// Joins the files as `grouping` says. Exception: the names of the files group them into as many points as there are
// stated positions. The files of a group are then hits of one point, unless the user gave --files points.
acquire::Record joined_scan(const ReadFlags& read, std::vector<acquire::Record> records,
                            const std::optional<pipeline::ScanPositions>& stated, acquire::FileGrouping grouping) {
  if (stated && read.files != acquire::FileGrouping::points) {
    const std::vector<acquire::FilesOfHits> groups = groups_of_files(records);
    if (!groups.empty() && groups.size() == stated->stated()) return record_of_groups(std::move(records), groups);
    std::vector<std::vector<acquire::FilesOfHits>> groupings;
    if (groups.empty()) groupings = groupings_of_files(records);
    std::erase_if(groupings, [&](const auto& one) { return one.size() != stated->stated(); });
    if (groupings.size() == 1) return record_of_groups(std::move(records), groupings.front());
  }
  return acquire::join_records(std::move(records), grouping);
}

// The positions come from the record if none are stated.
OpenScan open_scan(const NodesFlags& flags, const std::optional<pipeline::ScanPositions>& stated) {
  const acquire::FileGrouping grouping =
      flags.read.files == acquire::FileGrouping::automatic ? acquire::FileGrouping::points : flags.read.files;
  if (grouping == acquire::FileGrouping::tests)
    throw OptionError::wrong_value("files", "tests", "give points, or the files of one scan", "a scan is one test");
  pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  Measurements opened = open_measurements(flags.read);
  // Several files are numbered as points in their order, whatever the geometry of the first says.
  const bool renumbered = grouping == acquire::FileGrouping::points && opened.records.size() + opened.frfs.size() > 1;
  using Places = std::vector<std::vector<double>>;
  const bool several = opened.records.size() > 1;
  if (!opened.frfs.empty()) {
    acquire::FrfRecord frfs = join_frfs_of(flags.read, std::move(opened.frfs));
    std::set<int> points;
    for (const acquire::PointFrf& frf : frfs.frfs) points.insert(frf.point);
    const auto positions =
        stated ? *stated
               : pipeline::positions_of_geometry(renumbered ? Places{} : frfs.geometry, points, frfs.source());
    pipeline::assume_angles(frfs, options.classes);
    return {.analysis = std::make_shared<pipeline::Analysis>(std::move(frfs), options), .positions = positions};
  }
  acquire::Record record = joined_scan(flags.read, std::move(opened.records), stated, grouping);
  if (stated && record.rows.size() == 1) {
    record = pipeline::with_row_per_hit(std::move(record), options.hits);
    if (record.rows.size() > 1) {  // the rows are cut to the selected time
      options.hits.from_s = 0;
      options.hits.to_s.reset();
    }
  }
  const auto positions = stated ? *stated
                                : pipeline::positions_of_geometry(renumbered ? Places{} : record.geometry,
                                                                  record.points(), record.source());
  const bool assumed = record.points().size() == 1 && positions.stated() > 1;
  const bool points_are_files = several && record.points().size() == record.files.size();
  pipeline::assume_angles(record, options.classes);
  record = pipeline::as_scan(std::move(record), positions, points_are_files);
  return {.analysis = std::make_shared<pipeline::Analysis>(std::move(record), options),
          .positions = positions,
          .assumed_points = assumed};
}

int nodes(const NodesFlags& flags) {
  std::optional<pipeline::ScanPositions> stated;
  if (flags.positions) stated = parse_positions(*flags.positions);
  check_outputs(flags.output, {".json", ".csv", ".svg", ".html"});
  Progress progress("analysing", flags.output.quiet);
  const OpenScan opened = open_scan(flags, stated);
  if (flags.output.host != nullptr) flags.output.host->outcome.analyses = {opened.analysis};
  const pipeline::Analysis& analysis = *opened.analysis;
  analysis.hits();
  if (!analysis.possible()) {
    progress.stop();
    print(flags.output, report::analysis_json(analysis, {.sections = {report::ReportSection::hits}}));
    return kImpossible;
  }
  const pipeline::NodeScan scan =
      pipeline::scan_nodes(analysis, opened.positions, kResolution_m, opened.assumed_points);
  progress.stop();
  return show_report(report::nodes_report(analysis, scan), flags.output, inputs_of(analysis));
}

}  // namespace

void add_nodes(CommandLine& line) {
  auto flags = line.values<NodesFlags>();
  Command command = line.command("nodes", "Locate the nodes of bending modes from a scan of impacts",
                                 [flags] { return nodes(*flags); });
  command.about(
      "Locates the nodes of each bending mode along the barrel, with standard deviations, from hits at several "
      "positions. Each point, or each file, is one position; files P1_1, P1_2, ... are hits of one. A node lies where "
      "the response of the mode changes sign.");
  command.example("percuss nodes scan.h5 --positions 3:0.5:9in --band 60:1500",
                  "Use hits every half inch, from 3 to 9 in from the end of the barrel");
  command.example("percuss nodes scan.h5 --positions 76.2:12.7:228.6mm --band 60:1500 -o nodes.svg",
                  "State positions in millimetres, and draw the curves");
  command.example("percuss nodes scan.h5 --band 60:1500", "Take the positions from the geometry of the record");
  command
      .value(
          "--positions", [&given = flags->positions](const std::string& text) { given = text; },
          "Set the positions of the hits from the end of the barrel, in the order of points or files: a range or a "
          "list such as 3,3.5,5in, where files of equal positions are hits of one; in inches unless a unit (in, m, mm, "
          "cm, ft) follows (default: from the record's geometry)")
      .type("START:STEP:END[UNIT]|POSITION,...");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, {".json", ".csv", ".svg", ".html"});
}

}  // namespace percuss::tools
