#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "acquire/format_registry.hpp"
#include "acquire/record/file_format.hpp"
#include "batch/plan.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "commands/batch/batch_commands.hpp"
#include "commands/batch/batch_options.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxShownPath = 120;  // characters
constexpr std::uint64_t kMaxList_bytes = std::uint64_t{4} << 30U;

struct PlanFlags {
  std::vector<std::string> inputs;
  BatchOptions options;
  std::optional<Command> command;  // knows which options are given
  OutputFlags output;
  std::size_t shards = 1;
  bool frf = false, hash = false;
};

// Leaves out texts without numbers, such as a README, that were found in folders and by patterns. A CSV file without
// numbers is a record whose export failed: it is planned, and fails by name.
void leave_out_texts(batch::RecordFiles& files, const std::vector<std::string>& named) {
  const std::set<std::string> typed(named.begin(), named.end());
  const auto texts = std::stable_partition(files.paths.begin(), files.paths.end(), [&](const std::string& path) {
    return typed.contains(path) || acquire::file_extension(path) == ".csv" || !acquire::is_text_without_numbers(path);
  });
  files.left_out.insert(files.left_out.end(), texts, files.paths.end());
  files.paths.erase(texts, files.paths.end());
}

batch::RecordFiles files_of(const PlanFlags& flags) {
  if (flags.inputs.empty()) {
    throw OptionError({}, "no record is given",
                      "name files, folders or patterns in quotes, or - for a list on standard input");
  }
  std::vector<std::string> names;
  for (const std::string& input : flags.inputs) {
    const auto listed =
        input == "-" ? batch::parse_path_list(read_input("-", kMaxList_bytes).view()) : std::vector<std::string>{input};
    names.insert(names.end(), listed.begin(), listed.end());
  }
  batch::RecordFiles files = batch::record_files(names);
  leave_out_texts(files, names);
  if (files.paths.empty()) {
    throw InputError("no record found", names.empty() ? "standard input" : names.front(),
                     "name the files, or a folder that holds some");
  }
  return files;
}

std::string folder_of(const std::string& path) {
  const auto parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

using Parts = std::vector<batch::HitsOfOnePart>;

// Proposes to join files whose names call them hits of one part. The plan keeps them separate, because each file could
// also be another part with one hit.
void note_hits(const OutputFlags& output, const Parts& parts) {
  if (parts.empty()) return;
  const batch::HitsOfOnePart& first = parts.front();
  const std::string of = first.part.empty() ? "one part" : "one part, " + first.part;
  const std::string more = parts.size() == 1 ? ""
                           : parts.size() == 2
                               ? ", as is each file of another such part"
                               : fmt::format(", as is each file of {} other such parts", parts.size() - 1);
  Message note = information(fmt::format(
      "{} to {} are {} hits of {}, by their names, but each file is a test of its own{}; if they are hits, join the "
      "files of each part to one record, as hits, and plan these records",
      one_line(first.paths.front(), kMaxShownPath), one_line(first.paths.back(), kMaxShownPath), first.paths.size(),
      one_line(of, kMaxShownPath), more));
  note.options = {"convert.files"};
  print_note(output, note);
}

std::string summary_json(const batch::BatchHeader& head, std::size_t records, std::uint64_t bytes, std::size_t left_out,
                         const Parts& parts) {
  nlohmann::ordered_json json{{"schema", "percuss/batch-plan/1"},
                              {"version", head.version},
                              {"records", records},
                              {"bytes", bytes},
                              {"shards", head.shards},
                              {"left_out", left_out},
                              {"options", head.options},
                              {"options_sha256", batch::options_sha256(head)}};
  for (const batch::HitsOfOnePart& part : parts)
    json["hits_of_one_part"].push_back({{"part", part.part}, {"paths", part.paths}});
  return json.dump(2) + "\n";
}

int plan(PlanFlags& flags) {
  check_outputs(flags.output, {".jsonl"});
  if (flags.output.paths.size() != 1)
    throw OptionError({}, "batch plan writes one manifest", "name one file that ends in .jsonl", {"output"});
  const std::string& path = flags.output.paths.front();
  Progress progress("planning", flags.output.quiet);
  batch::RecordFiles files = files_of(flags);
  flags.options.read.paths = files.paths;
  batch::BatchHeader head{
      .version = report::version(), .options = {}, .setup = {}, .frf = flags.frf, .shards = flags.shards};
  store_batch_options(*flags.command, flags.options, head);
  const auto records = batch::records_of_files(files.paths, folder_of(path), flags.hash);
  batch::write_manifest(path, head, records, flags.output.force);
  progress.stop();
  std::uint64_t bytes = 0;
  for (const batch::BatchRecord& record : records) bytes += record.bytes;
  if (!files.left_out.empty() && !flags.output.quiet) {
    const std::string skipped = files.left_out.size() == 1 ? "1 file" : fmt::format("{} files", files.left_out.size());
    std::cerr << "percuss: skipped " << skipped << " of other kinds\n";
  }
  const Parts parts = batch::hits_of_one_part(files.paths);
  note_hits(flags.output, parts);
  if (flags.output.json) {
    std::cout << summary_json(head, records.size(), bytes, files.left_out.size(), parts);
  } else {
    std::cout << fmt::format("{}: {} {}, {:.4g} MB, in {} {}\n", one_line(path), records.size(),
                             records.size() == 1 ? "record" : "records", static_cast<double>(bytes) / 1e6, flags.shards,
                             flags.shards == 1 ? "shard" : "shards");
  }
  return kOk;
}

}  // namespace

void add_batch_plan(CommandLine& line) {
  auto flags = line.values<PlanFlags>();
  Command command = line.command("batch plan", "Plan a batch: write the records and the analysis options to a manifest",
                                 [flags] { return plan(*flags); });
  flags->command = command;
  command.about(
      "Writes a manifest: a line of JSON for the options of percuss analyze, and a line per record with its id, path "
      "and size. The id is the name of the file without extension, or its path if several files share the name. "
      "Relative paths start from the folder of the manifest, so manifest and records can be moved together, for "
      "example to a cluster. A record whose size (with --hash: whose contents) has changed since the plan is "
      "reported and not analysed. Each file is a test of its own; the plan proposes to join files whose names call "
      "them hits of one part (hit1, hit2, ...).");
  command.example("percuss batch plan bat.h5 barrel.h5 --band 60:3200 -o manifest.jsonl", "Plan two records");
  command.example("percuss batch plan '*.h5' --effort quick --shards 4 -o manifest.jsonl",
                  "Plan all files that match the pattern, for four workers");
  command.example("ls bat.h5 bat.mat | percuss batch plan - --frf --hash -o manifest.jsonl",
                  "Plan a list of files, keep FRFs, and detect changed contents");
  command.arguments("INPUT", flags->inputs,
                    "Records or FRFs: files; folders, searched recursively; patterns in quotes; - is a list on "
                    "standard input, one path per line");
  command.value("--shards", flags->shards, "Divide the work into this many shards of about equal bytes")
      .within(1, static_cast<double>(batch::kMaxShards))
      .show_default();
  command.flag("--frf", flags->frf, "Keep the FRFs, for percuss batch merge -o FILE.h5");
  command.flag("--hash", flags->hash,
               "Store the SHA-256 of every record in addition to its size; the plan then reads every record "
               "once, and percuss batch run reads it twice");
  add_batch_options(command, flags->options);
  add_setup_option(command, flags->options.read);
  add_output_flags(command, flags->output, {".jsonl"});
}

}  // namespace percuss::tools
