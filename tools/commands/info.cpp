#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "acquire/channels/channel_setup.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/info_frfs.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"
#include "core/units.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

struct InfoFlags {
  ReadFlags read;
  OutputFlags output;
  bool example = false;
};

/// Totals over the rows of a record.
struct Extent {
  std::size_t samples = 0, shortest = 0, longest = 0, points = 0, runs = 0;
};

Extent extent_of(const acquire::Record& record) {
  Extent extent;
  std::set<int> runs;
  for (const auto& row : record.rows) {
    extent.samples += row.samples;
    extent.shortest = extent.shortest == 0 ? row.samples : std::min(extent.shortest, row.samples);
    extent.longest = std::max(extent.longest, row.samples);
    runs.insert(row.run);
  }
  extent.points = record.points().size();
  extent.runs = runs.size();
  return extent;
}

Json channel_json(const acquire::SignalInfo& signal, const char* role, const char* si_unit) {
  return {{"role", role},
          {"name", signal.name},
          {"unit", signal.unit.empty() ? si_unit : signal.unit},
          {"si_unit", si_unit},
          {"to_si", signal.to_SI},
          {"angle_deg", optional_json(signal.angle_rad, kRadian_deg)},
          {"position_m", optional_json(signal.position_m, 1)}};
}

Json record_json(const acquire::Record& record) {
  const Extent extent = extent_of(record);
  Json channels = Json::array();
  channels.push_back(channel_json(record.force, "force", "N"));
  for (const auto& signal : record.accel) channels.push_back(channel_json(signal, "acceleration", "m/s^2"));
  return {{"path", record.files.front().path},
          {"bytes", record.files.front().bytes},
          {"kind", record.format},
          {"fs_hz", record.fs_Hz},
          {"rows", record.rows.size()},
          {"samples", extent.samples},
          {"shortest_row", extent.shortest},
          {"longest_row", extent.longest},
          {"duration_s", static_cast<double>(extent.samples) / record.fs_Hz},
          {"points", extent.points},
          {"runs", extent.runs},
          {"continuous", record.continuous || record.rows.size() == 1},
          {"channels", channels},
          {"geometry_points", record.geometry.size()},
          {"trace_lines", record.trace_lines.size()},
          {"notes", note_texts(record.notes)}};
}

std::string plural(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string record_text(const acquire::Record& record, std::size_t width) {
  const Extent extent = extent_of(record);
  std::string rows = plural(record.rows.size(), "row") + " of " + plural(extent.longest, "sample");
  if (extent.shortest != extent.longest)
    rows = fmt::format("{} of {} to {} samples", plural(record.rows.size(), "row"), extent.shortest, extent.longest);
  std::string text =
      fmt::format("{}: {}, {}, {:.10g} Hz, {:.4g} s", one_line(input_name(record.files.front().path), 400),
                  record.format, rows, record.fs_Hz, static_cast<double>(extent.samples) / record.fs_Hz);
  if (extent.points > 1) text += fmt::format(", {}", plural(extent.points, "point"));
  if (extent.runs > 1) text += fmt::format(", {}", plural(extent.runs, "run"));
  text += '\n';
  using Align = report::TextTable::Align;
  report::TextTable table({{"  role"},
                           {"name"},
                           {"unit"},
                           {"SI per unit", Align::right},
                           {"angle/°", Align::right},
                           {"position/m", Align::right},
                           {""}});
  const auto add = [&](const acquire::SignalInfo& signal, const char* role, const char* si_unit) {
    table.add({std::string("  ") + role, one_line(signal.name, 40),
               signal.unit.empty() ? si_unit : one_line(signal.unit, 20), fmt::format("{:.6g}", signal.to_SI),
               optional_text(signal.angle_rad, kRadian_deg), optional_text(signal.position_m, 1), ""});
  };
  add(record.force, "force", "N");
  for (const auto& signal : record.accel) add(signal, "acceleration", "m/s^2");
  text += table.text(width);
  return text + notes_paragraphs(record.notes, width);
}

// A text file whose channels only the user can identify.
Json columns_json(const std::string& path, const acquire::AmbiguousColumns& seen) {
  Json columns = Json::array();
  for (const auto& column : seen.columns) {
    columns.push_back({{"number", column.index + 1},
                       {"name", column.name},
                       {"unit", column.unit.empty() ? Json(nullptr) : Json(column.unit)},
                       {"numbers", column.has_numbers}});
  }
  return {{"path", path},
          {"kind", seen.format},
          {"fs_hz", optional_json(seen.fs_Hz, 1)},
          {"columns", columns},
          {"needs", seen.what()}};
}

std::string columns_text(const std::string& path, const acquire::AmbiguousColumns& seen, std::size_t width) {
  std::string text = one_line(input_name(path), 400) + ": " + seen.format + ", " +
                     plural(seen.columns.size(), seen.format == "CSV" ? "column" : "signal");
  if (seen.fs_Hz) text += fmt::format(", {:.10g} Hz", *seen.fs_Hz);
  report::TextTable table({{"  number", report::TextTable::Align::right}, {"name"}, {"unit"}, {""}});
  for (const auto& column : seen.columns) {
    table.add({fmt::format("{}", column.index + 1), one_line(column.name, 40),
               column.unit.empty() ? "-" : one_line(column.unit, 20), column.has_numbers ? "" : "no numbers"});
  }
  return text + '\n' + table.text(width) + "  " + report::wrapped("needed: " + seen.written(flag_of), width, 2) + '\n';
}

void write_outputs(const OutputFlags& output, const std::string& document) {
  OutputGroup outputs;
  for (const auto& path : output.paths) write_file(path, document, output.force);
  outputs.commit();
}

int run_info(const InfoFlags& flags) {
  if (flags.example) {
    print(flags.output, acquire::channel_setup_example());
    return kOk;
  }
  if (flags.read.paths.empty()) throw OptionError({}, "no file is given", "name at least one, or - for standard input");
  check_outputs(flags.output, {".json"});
  const acquire::ReadOptions options = resolved_read_options(flags.read);
  Json files = Json::array();
  int code = kOk;
  bool any = false;
  for (std::size_t i = 0; i < flags.read.paths.size(); ++i) {
    try {
      const auto opened = open_measurement_at(flags.read, options, i);
      const auto* const frfs = std::get_if<acquire::FrfRecord>(&opened);
      files.push_back(frfs != nullptr ? frfs_json(*frfs) : record_json(std::get<acquire::Record>(opened)));
      any = true;
      if (flags.output.json) continue;
      std::cout << (frfs != nullptr ? frfs_text(*frfs, terminal_width())
                                    : record_text(std::get<acquire::Record>(opened), terminal_width()));
    } catch (const acquire::AmbiguousColumns& seen) {
      files.push_back(columns_json(flags.read.paths[i], seen));
      any = true;
      if (!flags.output.json) std::cout << columns_text(flags.read.paths[i], seen, terminal_width());
    } catch (const InputError& error) {
      // One bad file must not hide the descriptions of the others.
      if (flags.output.host == nullptr) std::cerr << "percuss: " << error.written(flag_of) << '\n';
      files.push_back({{"path", flags.read.paths[i]}, {"error", error.what()}});
      code = kBadInput;
    }
  }
  const std::string document =
      Json{{"schema", "percuss/info/1"}, {"files", files}}.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (flags.output.json) print(flags.output, document);
  if (any) write_outputs(flags.output, document);
  return code;
}

}  // namespace

void add_info(CommandLine& line) {
  auto flags = line.values<InfoFlags>();
  Command command =
      line.command("info", "Describe files: kind, channels, units, rate, rows, and parts that cannot be read",
                   [flags] { return run_info(*flags); });
  command.about(
      "Reads only the description of a file, and reports parts that cannot be understood. Start here with a new file: "
      "analyze makes the same assumptions, and the options under Reading change them.");
  command.example("percuss info bat.h5", "Show channels, units, rate and rows");
  command.example("percuss info hits.csv --force-channel CH8 --json", "Print a document; the force is in column CH8");
  command.example("percuss info --example > channels.json",
                  "Write an example of a channel set-up, to be changed and passed to --setup");
  add_read_flags(command, flags->read);
  add_output_flags(command, flags->output, ".json");
  command.flag("--example", flags->example, "Print an example of a channel set-up for --setup");
}

}  // namespace percuss::tools
