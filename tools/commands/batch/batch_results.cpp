#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "batch/merge.hpp"
#include "batch/status.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

struct ResultFlags {
  std::string manifest, folder;
  OutputFlags output;
  bool missing = false, json = false;
};

void add_places(Command& command, ResultFlags& flags) {
  command.word("FOLDER", flags.folder, "Folder of the results: -o of percuss batch run").type("FOLDER").required();
  command.value("--manifest", flags.manifest, "What percuss batch plan wrote").type("FILE").required();
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

int merge(const ResultFlags& flags) {
  check_outputs(flags.output, {".jsonl", ".csv", ".h5"});
  if (flags.output.paths.empty()) throw UsageError("nothing to write", "give -o FILE.jsonl, FILE.csv or FILE.h5");
  const batch::Manifest manifest(flags.manifest);
  const Progress progress("merging", flags.output.quiet);
  const batch::MergedBatch merged = batch::merge_batch(manifest, flags.folder, flags.output.paths, flags.output.force);
  progress.stop();
  if (flags.output.json) {
    const nlohmann::ordered_json json{{"schema", "percuss/batch-merge/1"},
                                      {"version", report::version()},
                                      {"records", merged.records},
                                      {"failed", merged.failed}};
    std::cout << json.dump(2) << '\n';
  } else if (!flags.output.quiet) {
    std::cout << fmt::format("{} records, {} failed\n", merged.records, merged.failed);
  }
  return merged.failed > 0 ? kPartial : kOk;
}

}  // namespace

void add_batch_status(CommandLine& line) {
  auto flags = line.values<ResultFlags>();
  Command command = line.command("batch status", "How far a batch has come, and which shards are missing",
                                 [flags] { return status(*flags); });
  command.about(
      "Tells from the files in the folder of results, not from an engine, which shards are finished, which are "
      "missing, "
      "and which records were begun more than once and never finished: such a record may be what ends the worker.");
  command.example(
      "percuss batch plan bat.h5 --shards 3 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl --shard 0 "
      "-o "
      "results; percuss batch status --manifest manifest.jsonl results --missing",
      "Prints 1,2: for sbatch --array");
  add_places(command, *flags);
  command.flag("--missing", flags->missing, "Print the numbers of the missing shards alone: 0,3,4");
  command.flag("--json", flags->json, "One JSON document on standard output");
}

void add_batch_merge(CommandLine& line) {
  auto flags = line.values<ResultFlags>();
  Command command =
      line.command("batch merge", "One file of all shards' rows, ordered by id", [flags] { return merge(*flags); });
  command.about(
      "Puts the rows of all shards into one file, a row per record and per mode, as lines of JSON or as a table that "
      "percuss study reads; FRFs into HDF5, where they were planned. The bytes do not depend on the number of shards, "
      "threads or machines of one kind. Shards that are missing, or were made with other options or versions of "
      "percuss "
      "than the rest, are refused. Exit code 6 tells that some records failed.");
  command.example(
      "percuss batch plan bat.h5 barrel.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl -o results; "
      "percuss batch merge --manifest manifest.jsonl results -o bats.jsonl -o bats.csv",
      "From records to a table");
  add_places(command, *flags);
  add_output_flags(command, flags->output, ".jsonl, .csv, .h5");
}

}  // namespace percuss::tools
