#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "batch/merge.hpp"
#include "batch/status.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "commands/batch/batch_commands.hpp"
#include "commands/batch/problem_list.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

struct ResultFlags {
  std::string manifest, folder;
  OutputFlags output;
  bool missing = false, json = false, keep_formulas = false;
};

void add_folder_and_manifest(Command& command, ResultFlags& flags) {
  command.argument("FOLDER", flags.folder, "Folder of the results: -o of percuss batch run").type("FOLDER").required();
  command.value("--manifest", flags.manifest, "Read the manifest of percuss batch plan").type("FILE").required();
}

int status(const ResultFlags& flags) {
  const batch::BatchStatus found = batch::batch_status(batch::Manifest(flags.manifest), flags.folder);
  if (flags.json) {
    std::cout << batch::status_json(found);
  } else if (!flags.missing) {
    std::cout << batch::status_text(found);
  } else if (!found.missing.empty()) {
    std::cout << batch::array_list(found.missing) << '\n';
  }
  return kOk;
}

// The output that holds the rows of records, else the files of the parts: HDF5 holds only FRFs.
std::string file_of_rows(const ResultFlags& flags) {
  const auto holds_rows = [](const std::string& path) { return path.ends_with(".jsonl") || path.ends_with(".csv"); };
  const auto& paths = flags.output.paths;
  const auto found = std::find_if(paths.begin(), paths.end(), holds_rows);
  return found == paths.end() ? part_files(flags.folder) : *found;
}

const std::vector<std::string>& merge_extensions() {
  static const std::vector<std::string> kExtensions{".jsonl", ".csv", ".h5", ".hdf5"};
  return kExtensions;
}

int merge(const ResultFlags& flags) {
  check_outputs(flags.output, merge_extensions());
  if (flags.output.paths.empty())
    throw OptionError({}, "no output is given", "name a file that ends in .jsonl, .csv, .h5 or .hdf5", {"output"});
  const batch::Manifest manifest(flags.manifest);
  Progress progress("merging", flags.output.quiet);
  OutputGroup outputs;
  const batch::MergedBatch merged =
      batch::merge_batch(manifest, flags.folder, flags.output.paths,
                         {.force = flags.output.force, .formulas = csv_formulas(flags.keep_formulas)});
  outputs.commit();
  progress.stop();
  if (flags.output.json) {
    const nlohmann::ordered_json json{{"schema", "percuss/batch-merge/1"},
                                      {"version", report::version()},
                                      {"records", merged.records},
                                      {"failed", merged.failed}};
    std::cout << json.dump(2) << '\n';
  } else {
    std::cout << fmt::format("{} records, {} failed\n", merged.records, merged.failed);
  }
  if (!flags.output.quiet) {
    ProblemList failed("failed");
    for (const batch::FailedRecord& record : merged.first_failed) failed.add(record.id, record.reason);
    failed.finish(merged.failed, place_of_failed(file_of_rows(flags)));
  }
  return merged.failed > 0 ? kPartial : kOk;
}

}  // namespace

void add_batch_status(CommandLine& line) {
  auto flags = line.values<ResultFlags>();
  Command command = line.command("batch status", "Show the progress of a batch and its missing shards",
                                 [flags] { return status(*flags); });
  command.about(
      "Lists finished and missing shards from the files in the folder of results, without asking a scheduler. Also "
      "lists records that were begun more than once and never finished: such a record may crash the worker.");
  command.example(
      "percuss batch plan bat.h5 --shards 3 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl --shard 0 "
      "-o results; percuss batch status --manifest manifest.jsonl results --missing",
      "Print the missing shards as 1,2 for sbatch --array");
  add_folder_and_manifest(command, *flags);
  command.flag("--missing", flags->missing, "Print only the numbers of the missing shards: 0,3,4");
  command.flag("--json", flags->json, "Print one JSON document on standard output");
}

void add_batch_merge(CommandLine& line) {
  auto flags = line.values<ResultFlags>();
  Command command = line.command("batch merge", "Merge the rows of all shards into one file, ordered by id",
                                 [flags] { return merge(*flags); });
  command.about(
      "Writes the rows of all shards to one file, a row per record and mode, as lines of JSON or as a table for "
      "percuss study. Writes FRFs to HDF5 if the plan keeps them. The bytes do not depend on the number of shards "
      "or threads, and are the same on all machines of one kind. Missing shards, and shards with other options or "
      "another version of percuss, are an error. The exit code is 6 if some records failed.");
  command.example(
      "percuss batch plan bat.h5 barrel.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl -o results; "
      "percuss batch merge --manifest manifest.jsonl results -o bats.jsonl -o bats.csv",
      "Turn records into a table");
  add_folder_and_manifest(command, *flags);
  add_output_flags(command, flags->output, merge_extensions());
  add_formula_flag(command, flags->keep_formulas);
}

}  // namespace percuss::tools
