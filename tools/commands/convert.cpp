#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "acquire/write_record.hpp"
#include "cli/open_files.hpp"
#include "cli/option_names.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"

namespace percuss::tools {
namespace {

struct ConvertFlags {
  ReadFlags read;
  OutputFlags output;
};

void tell(const ConvertFlags& flags, const std::string& what) { print_note(flags.output, one_line(what, 2000)); }

// The last word is the file to write, as cp has it, unless -o names it.
std::string take_output(ConvertFlags& flags) {
  if (flags.output.paths.empty() && flags.read.paths.size() > 1) {
    flags.output.paths.push_back(flags.read.paths.back());
    flags.read.paths.pop_back();
  }
  if (flags.output.paths.size() != 1) throw UsageError("not one output", "give IN and OUT: percuss convert IN OUT");
  check_outputs(flags.output, acquire::record_extensions());
  return flags.output.paths.front();
}

void convert_frfs(const ConvertFlags& flags, const std::string& to, std::vector<frf::FrfRecord> frfs) {
  const frf::FrfRecord record = join_frfs_of(flags.read, std::move(frfs));
  for (const Message& note : record.notes) tell(flags, note.written(flag_of));
  const auto& known = acquire::frf_extensions();
  if (std::find(known.begin(), known.end(), extension_of(to)) == known.end()) {
    throw UsageError("'" + one_line(to, 80) + "' cannot hold FRFs",
                     fmt::format("use a name that ends in {}", fmt::join(known, ", ")));
  }
  for (const std::string& loss : acquire::losses_of(to, record)) tell(flags, "not kept: " + loss);
  acquire::write_frfs(to, record, flags.read.frf_kind.value_or(record.kind), flags.output.force);
}

int convert(ConvertFlags flags) {
  const std::string to = take_output(flags);
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty()) {
    convert_frfs(flags, to, std::move(opened.frfs));
    return kOk;
  }
  const acquire::Record record = acquire::join_records(std::move(opened.records), flags.read.files);
  for (const Message& note : record.notes) tell(flags, note.written(flag_of));
  for (const std::string& loss : acquire::losses_of(to, record)) tell(flags, "not kept: " + loss);
  acquire::write_record(to, record, flags.output.force);
  return kOk;
}

}  // namespace

void add_convert(CommandLine& line) {
  auto flags = line.values<ConvertFlags>();
  Command command =
      line.command("convert", "Records or FRFs from one format into another", [flags] { return convert(*flags); });
  command.about(
      "The last FILE is the one to write, as with cp, unless -o names it; its extension says the format. What a format "
      "cannot keep is told on standard error.");
  command.example("percuss convert bat.mat bat.uff", "A record from MATLAB as a universal file");
  command.example("percuss convert frfs.h5 -o frfs.csv", "Frequency responses as a table");
  command.example(
      "percuss convert hits.csv hits.h5 --force-channel CH8 --force-unit lbf --quiet",
      "A table whose force is in pounds, as HDF5 in SI units; the columns' own names are lost without a word");
  add_read_flags(command, flags->read);
  add_output_flags(command, flags->output, fmt::format("{}", fmt::join(acquire::record_extensions(), ", ")).c_str());
}

}  // namespace percuss::tools
