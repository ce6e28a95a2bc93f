#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>

#include "acquire/channels/channel_setup.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/info/info_columns.hpp"
#include "commands/info/info_frfs.hpp"
#include "commands/info/info_samples.hpp"
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

/// Samples, points and runs of a record, over all rows.
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

Json channel_json(const Channel& channel) {
  const acquire::SignalInfo& signal = *channel.signal;
  Json json{{"role", channel.role},
            {"name", signal.name},
            {"unit", signal.unit.empty() ? channel.si_unit : signal.unit},
            {"si_unit", channel.si_unit},
            {"to_si", signal.to_SI},
            {"angle_deg", optional_json(signal.angle_rad, kRadian_deg)},
            {"position_m", optional_json(signal.position_m, 1)}};
  if (!channel.samples) return json;
  json["rms"] = channel.samples->rms;
  json["peak"] = channel.samples->peak;
  json["hammer"] = channel.samples->hammer;
  return json;
}

Json record_json(const acquire::Record& record, const RecordSamples& samples) {
  const Extent extent = extent_of(record);
  Json notes = note_texts(notes_of(record, samples));
  if (samples.problem) notes.push_back(std::string("the samples cannot all be read: ") + samples.problem->what());
  Json channels = Json::array();
  for (const Channel& channel : samples.channels) channels.push_back(channel_json(channel));
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
          {"hits", samples.hits ? Json(*samples.hits) : Json(nullptr)},
          {"channels", channels},
          {"geometry_points", record.geometry.size()},
          {"trace_lines", record.trace_lines.size()},
          {"notes", notes}};
}

// Format, rows and rate of a record, in one line.
std::string heading_of(const acquire::Record& record, const RecordSamples& samples) {
  const Extent extent = extent_of(record);
  std::string rows = report::counted(record.rows.size(), "row") + " of " + report::counted(extent.longest, "sample");
  if (extent.shortest != extent.longest)
    rows = fmt::format("{} of {} to {} samples", report::counted(record.rows.size(), "row"), extent.shortest,
                       extent.longest);
  std::string text =
      fmt::format("{}: {}, {}, {:.10g} Hz, {:.4g} s", one_line(input_name(record.files.front().path), 400),
                  record.format, rows, record.fs_Hz, static_cast<double>(extent.samples) / record.fs_Hz);
  if (samples.hits) text += fmt::format(", {}", report::counted(*samples.hits, "hit"));
  if (extent.points > 1) text += fmt::format(", {}", report::counted(extent.points, "point"));
  if (extent.runs > 1) text += fmt::format(", {}", report::counted(extent.runs, "run"));
  return text + '\n';
}

std::string channel_table(const RecordSamples& samples, std::size_t width) {
  using Align = report::TextTable::Align;
  report::TextTable table({{"  role"},
                           {"name"},
                           {"unit"},
                           {"SI per unit", Align::right},
                           {"angle/°", Align::right},
                           {"position/m", Align::right},
                           {"rms", Align::right},
                           {"peak", Align::right},
                           {"looks like"}});
  for (const Channel& channel : samples.channels) {
    const acquire::SignalInfo& signal = *channel.signal;
    const std::optional<ChannelSamples>& shown = channel.samples;
    const auto value = [&](double x) { return fmt::format("{:.3g} {}", x, channel.si_unit); };
    table.add({std::string("  ") + channel.role, one_line(signal.name, 40),
               signal.unit.empty() ? channel.si_unit : one_line(signal.unit, 20), fmt::format("{:.6g}", signal.to_SI),
               optional_text(signal.angle_rad, kRadian_deg), optional_text(signal.position_m, 1),
               shown ? value(shown->rms) : "-", shown ? value(shown->peak) : "-",
               !shown || samples.problem ? "-"
               : shown->hammer           ? "hammer"
                                         : "response"});
  }
  return table.text(width);
}

std::string record_text(const acquire::Record& record, const RecordSamples& samples, std::size_t width, bool pictures) {
  std::string text = heading_of(record, samples) + channel_table(samples, width);
  for (const Channel& channel : samples.channels) {
    if (pictures && channel.samples)
      text += fmt::format("  {:<14}{}\n", channel.role, picture_of(channel.samples->envelope));
  }
  return text + notes_paragraphs(notes_of(record, samples), width);
}

void write_outputs(const OutputFlags& output, const std::string& document) {
  OutputGroup outputs;
  for (const auto& path : output.paths) write_file(path, document, output.force);
  outputs.commit();
}

// Whether the record uses all columns that hold signals, so that no other column can be the force.
bool uses_all_signals(const acquire::Record& record, const acquire::RoleGuess& guess) {
  return record.accel.size() >= guess.accel.size() + (guess.force.empty() ? 0 : 1);
}

// Opens a file as analyze does, which accepts records without a force. If another column may be the force, it throws
// AmbiguousColumns: the list of columns tells the user more.
std::variant<acquire::Record, acquire::FrfRecord> opened_at(const ReadFlags& read, const acquire::ReadOptions& options,
                                                            std::size_t index) {
  try {
    return open_measurement_at(read, options, index);
  } catch (const InputError& seen) {
    if (read.paths[index] == "-" || options.force_optional) throw;
    acquire::ReadOptions without_force = options;
    without_force.force_optional = true;
    const auto* const ambiguous = dynamic_cast<const acquire::AmbiguousColumns*>(&seen);
    try {
      auto opened = open_measurement_at(read, without_force, index);
      const auto* const record = std::get_if<acquire::Record>(&opened);
      if (record == nullptr || ambiguous == nullptr || uses_all_signals(*record, ambiguous->guess)) return opened;
    } catch (const InputError&) {  // the first error says more
    }
    throw;
  }
}

// Prints why a file, or its samples, cannot be read. Returns the exit code.
int print_refusal(const OutputFlags& output, const InputError& error) {
  if (output.host == nullptr) std::cerr << "percuss: " << error.written(flag_of) << '\n';
  return kBadInput;
}

int run_info(InfoFlags flags) {
  if (flags.example) {
    print(flags.output, acquire::channel_setup_example());
    return kOk;
  }
  if (flags.read.paths.empty()) throw OptionError({}, "no file is given", "name at least one, or - for standard input");
  check_outputs(flags.output, {".json"});
  flags.read = with_found_files(flags.read);
  const acquire::ReadOptions options = resolved_read_options(flags.read);
  Json files = Json::array();
  int code = kOk;
  bool any = false;
  for (std::size_t i = 0; i < flags.read.paths.size(); ++i) {
    try {
      const auto opened = opened_at(flags.read, options, i);
      const auto* const frfs = std::get_if<acquire::FrfRecord>(&opened);
      any = true;
      if (frfs != nullptr) {
        files.push_back(frfs_json(*frfs));
        if (!flags.output.json) std::cout << frfs_text(*frfs, terminal_width());
        continue;
      }
      const auto& record = std::get<acquire::Record>(opened);
      const RecordSamples samples = samples_of(record);
      files.push_back(record_json(record, samples));
      if (!flags.output.json) std::cout << record_text(record, samples, terminal_width(), can_plot_in_terminal());
      if (samples.problem) code = print_refusal(flags.output, *samples.problem);
    } catch (const acquire::AmbiguousColumns& seen) {
      files.push_back(columns_json(flags.read.paths[i], seen));
      any = true;
      if (!flags.output.json) std::cout << columns_text(flags.read.paths[i], seen, terminal_width());
    } catch (const InputError& error) {
      // One bad file must not hide the descriptions of the others.
      files.push_back({{"path", flags.read.paths[i]}, {"error", error.what()}});
      code = print_refusal(flags.output, error);
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
      "Describes each file and its samples: rate, rows and hits; rms and peak of each channel, and whether it looks "
      "like a hammer; on a terminal also a picture over time. Reports parts that cannot be understood. Start here with "
      "a new file: analyze makes the same assumptions, and the options under Reading change them.");
  command.example("percuss info bat.h5", "Show channels, units, rate and rows");
  command.example("percuss info hits.csv --force-channel CH8 --json", "Print a document; the force is in column CH8");
  command.example("percuss info --example > channels.json",
                  "Write an example of a channel set-up, to be changed and passed to --setup");
  add_read_flags(command, flags->read, Reads::described);
  add_output_flags(command, flags->output, {".json"});
  command.flag("--example", flags->example, "Print an example of a channel set-up for --setup");
}

}  // namespace percuss::tools
