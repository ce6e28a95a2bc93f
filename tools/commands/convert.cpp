#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "acquire/write_record.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertFlags {
  ReadFlags read;
  OutputFlags output;
};

void print_losses(const ConvertFlags& flags, const std::vector<std::string>& losses) {
  for (const std::string& loss : losses) print_note(flags.output, {"not kept: " + loss, {}});
}

// The output is the file that -o names, otherwise the last argument, as for cp.
std::string take_output(ConvertFlags& flags) {
  if (flags.output.paths.empty() && flags.read.paths.size() > 1) {
    flags.output.paths.push_back(flags.read.paths.back());
    flags.read.paths.pop_back();
  }
  if (flags.output.paths.size() != 1)
    throw OptionError({}, "convert writes exactly one file", "give input and output: percuss convert IN OUT");
  check_outputs(flags.output, acquire::record_extensions());
  return flags.output.paths.front();
}

// Prints the document of --json. `content` are its keys for a record or for FRFs.
void print_document(const ConvertFlags& flags, const std::string& to, const std::vector<acquire::InputFile>& inputs,
                    const Json& content, const std::vector<Message>& notes, const std::vector<std::string>& losses) {
  Json json{{"schema", "percuss/convert/1"}, {"version", report::version()}, {"inputs", Json::array()}};
  for (const acquire::InputFile& file : inputs) json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  json["output"] = {{"path", to}, {"bytes", std::filesystem::file_size(to)}};
  json.update(content);
  json["not_kept"] = losses;
  json["notes"] = Json::array();
  for (const Message& note : notes) json["notes"].push_back(note.text);
  print(flags.output, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void convert_frfs(const ConvertFlags& flags, const std::string& to, std::vector<acquire::FrfRecord> frfs) {
  const acquire::FrfRecord record = join_frfs_of(flags.read, std::move(frfs));
  for (const Message& note : record.notes) print_note(flags.output, note);
  const auto& known = acquire::frf_extensions();
  if (std::find(known.begin(), known.end(), extension_of(to)) == known.end()) {
    throw OptionError({}, "'" + one_line(to, 80) + "' cannot hold FRFs",
                      fmt::format("use a name that ends in {}", fmt::join(known, ", ")));
  }
  const std::vector<std::string> losses = acquire::losses_of(to, record);
  print_losses(flags, losses);
  const acquire::FrfKind kind = flags.read.frf_kind.value_or(record.kind);
  acquire::write_frfs(to, record, kind, flags.output.force);
  if (!flags.output.json) return;
  const Json content{{"content", "frfs"},
                     {"frf_kind", acquire::name_of(kind)},
                     {"lines", record.lines.count},
                     {"points", record.frfs.size() / record.accel.size()},
                     {"responses", record.accel.size()}};
  print_document(flags, to, record.files, content, record.notes, losses);
}

int convert(ConvertFlags flags) {
  const std::string to = take_output(flags);
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty()) {
    convert_frfs(flags, to, std::move(opened.frfs));
    return kOk;
  }
  const acquire::Record record = acquire::join_records(std::move(opened.records), flags.read.files);
  for (const Message& note : record.notes) print_note(flags.output, note);
  const std::vector<std::string> losses = acquire::losses_of(to, record);
  print_losses(flags, losses);
  acquire::write_record(to, record, flags.output.force);
  if (!flags.output.json) return kOk;
  const Json content{{"content", "record"},        {"fs_hz", record.fs_Hz},
                     {"rows", record.rows.size()}, {"points", record.points().size()},
                     {"force", record.has_force},  {"responses", record.accel.size()}};
  print_document(flags, to, record.files, content, record.notes, losses);
  return kOk;
}

}  // namespace

void add_convert(CommandLine& line) {
  auto flags = line.values<ConvertFlags>();
  flags->read.options.force_optional = true;
  Command command =
      line.command("convert", "Convert records or FRFs between formats", [flags] { return convert(*flags); });
  command.about(
      "Writes the last FILE, as cp does, or the file that -o names; its extension sets the format. Lists on standard "
      "error the information that the format cannot store; with --json also in a document on standard output.");
  command.example("percuss convert bat.mat bat.uff", "Convert a record from MATLAB to a universal file");
  command.example("percuss convert frfs.h5 -o frfs.csv", "Write FRFs as a table");
  command.example("percuss convert hits.csv hits.h5 --force-channel CH8 --force-unit lbf --quiet",
                  "Convert a table with forces in pounds to HDF5 in SI units, without notes on lost column names");
  add_read_flags(command, flags->read);
  add_output_flags(command, flags->output, acquire::record_extensions());
}

}  // namespace percuss::tools
