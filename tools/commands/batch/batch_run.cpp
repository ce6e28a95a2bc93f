#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "acquire/open_measurement.hpp"
#include "batch/part.hpp"
#include "batch/part_file.hpp"
#include "batch/run_shard.hpp"
#include "cli/exit_code.hpp"
#include "cli/hit_list.hpp"
#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "commands/batch/batch_commands.hpp"
#include "commands/batch/batch_options.hpp"
#include "commands/batch/problem_list.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

struct RunFlags {
  std::string manifest, folder, shard;
  std::size_t threads = 0;
  bool trust_input = false, force = false, json = false, quiet = false;
  std::vector<double> budget;
};

// The shards to run, and the number of shards.
struct ShardSelection {
  std::optional<std::size_t> shard;   // none: all
  std::optional<std::size_t> shards;  // none: from the folder or the manifest
};

ShardSelection parse_shard_selection(const std::string& text) {
  if (text == "all") return {};
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto shard = whole_number(std::string_view(text).substr(0, slash));
  const auto shards = slash < text.size() ? whole_number(std::string_view(text).substr(slash + 1)) : std::nullopt;
  if (!shard || (slash < text.size() && (!shards || *shards < 1 || *shards > batch::kMaxShards))) {
    throw OptionError::wrong_value("shard", text,
                                   "give I/N, such as 0/7 to 6/7; or I, for the planned number of shards; or all");
  }
  return {.shard = shard, .shards = shards};
}

// The shard number that a scheduler passes to its workers. GNU parallel counts from 1.
ShardSelection shard_selection_of_scheduler() {
  for (const auto& [name, first] :
       {std::pair{"SLURM_ARRAY_TASK_ID", 0U}, {"JOB_COMPLETION_INDEX", 0U}, {"PARALLEL_SEQ", 1U}}) {
    const char* const text = std::getenv(name);
    if (text == nullptr) continue;
    const auto number = whole_number(text);
    if (number && *number >= first) return {.shard = *number - first, .shards = std::nullopt};
    throw OptionError({}, fmt::format("{} is '{}', which is not the number of a shard", name, one_line(text, 40)),
                      "give I/N, or all", {"shard"});
  }
  return {};
}

std::vector<std::size_t> shards_to_run(const ShardSelection& selection, std::size_t shards) {
  if (selection.shard && *selection.shard >= shards) {
    throw OptionError({}, fmt::format("there is no shard {} of {}", *selection.shard, shards),
                      "count from 0; the plan sets the number of shards", {"batch.plan.shards"});
  }
  if (selection.shard) return {*selection.shard};
  std::vector<std::size_t> all(shards);
  for (std::size_t i = 0; i < shards; ++i) all[i] = i;
  return all;
}

std::string progress_text(std::size_t done, std::size_t total, double seconds) {
  const double rate = static_cast<double>(done) / seconds;
  std::string text = fmt::format("analysing … {} of {}", done, total);
  if (done == 0) return text;
  return text + fmt::format(", {:.3g}/s, {:.0f} s left", rate, static_cast<double>(total - done) / rate);
}

void print(const RunFlags& flags, const std::vector<batch::ShardOutcome>& outcomes) {
  std::size_t records = 0, failed = 0, analysed = 0, open = 0;
  auto shards = nlohmann::ordered_json::array();
  for (const batch::ShardOutcome& outcome : outcomes) {
    records += outcome.part.records;
    failed += outcome.part.failed;
    analysed += outcome.analysed;
    open += outcome.open.size();
    shards.push_back({{"shard", outcome.part.label.shard},
                      {"records", outcome.part.records},
                      {"failed", outcome.part.failed},
                      {"analysed", outcome.analysed},
                      {"open", outcome.open.size()}});
  }
  const std::size_t of = outcomes.front().part.label.shards;
  if (flags.json) {
    const nlohmann::ordered_json json{
        {"schema", "percuss/batch-run/1"}, {"version", report::version()}, {"of", of}, {"shards", shards}};
    std::cout << json.dump(2) << '\n';
    return;
  }
  const std::string which = of == 1 ? "finished"
                            : outcomes.size() > 1
                                ? fmt::format("finished in {} shards", of)
                                : fmt::format("finished in shard {} of {}", outcomes.front().part.label.shard, of);
  std::cout << fmt::format("{} records {}, {} of them now; {} failed{}\n", records, which, analysed, failed,
                           open > 0 ? fmt::format("; {} left open", open) : "");
}

void print_failed_records(const RunFlags& flags, const batch::Manifest& manifest,
                          const std::vector<batch::ShardOutcome>& outcomes) {
  ProblemList failed("failed");
  for (const batch::ShardOutcome& outcome : outcomes) {
    for (const batch::RecordProblem& record : outcome.failed)
      failed.add(manifest.record(record.index).id, record.reason);
  }
  failed.finish(failed.size(), place_of_failed(part_files(flags.folder)));
}

void print_open_records(const batch::Manifest& manifest, const std::vector<batch::ShardOutcome>& outcomes) {
  ProblemList list("is left open");
  for (const batch::ShardOutcome& outcome : outcomes) {
    for (const batch::RecordProblem& record : outcome.open) list.add(manifest.record(record.index).id, record.reason);
  }
  const std::size_t open = list.size();
  list.finish(open);
  if (open > 0) {
    std::cerr << fmt::format("percuss: the machine failed at {} {}; run the batch again\n", open,
                             open == 1 ? "record" : "records");
  }
}

// Absolute, since run_shards() changes the working folder.
std::string results_folder(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem)
    throw InputError("cannot create the folder: " + problem.message(), folder, "name a folder that can be written");
  return fs::canonical(folder).string();
}

// All results in a folder must come from the same number of shards, so that they can be merged.
std::size_t number_of_shards(const RunFlags& flags, const ShardSelection& selection, const batch::Manifest& manifest,
                             const std::string& folder) {
  const auto found = batch::shard_count_in(folder);
  const std::size_t wanted = selection.shards.value_or(found.value_or(manifest.head().shards));
  if (!found || *found == wanted) return wanted;
  throw InputError(fmt::format("the number of shards in this folder is {}, not {}", *found, wanted), flags.folder,
                   "run with the number of shards in the folder, or name another folder");
}

int run_shards(const RunFlags& flags) {
  const ShardSelection selection =
      flags.shard.empty() ? shard_selection_of_scheduler() : parse_shard_selection(flags.shard);
  const batch::Manifest manifest(flags.manifest);
  batch::RowOptions options = row_options(manifest, flags.trust_input);
  options.analysis.budget = budget_of(flags.budget);
  const std::string folder = results_folder(flags.folder);
  batch::remove_abandoned_parts(folder);
  const std::size_t shards = number_of_shards(flags, selection, manifest, folder);
  const auto wanted = shards_to_run(selection, shards);
  // Paths of records, also in messages, are relative to the folder of the manifest.
  if (const fs::path parent = fs::path(flags.manifest).parent_path(); !parent.empty()) fs::current_path(parent);
  // Started before any thread, and in the folder of the records.
  if (options.read.read.sandboxed) options.fork_server = acquire::measurement_fork_server(options.read);
  std::atomic<std::size_t> done{0};
  std::size_t total = 0;
  for (const std::size_t i : wanted) total += manifest.shard(i, shards).size();
  Progress progress([&done, total](double seconds) { return progress_text(done, total, seconds); }, flags.quiet);
  std::vector<batch::ShardOutcome> outcomes;
  std::size_t failed = 0, open = 0;
  for (const std::size_t i : wanted) {
    outcomes.push_back(batch::run_shard({.manifest = &manifest,
                                         .shard = i,
                                         .shards = shards,
                                         .folder = folder,
                                         .options = options,
                                         .threads = flags.threads,
                                         .force = flags.force,
                                         .advance = [&done] { ++done; }}));
    failed += outcomes.back().part.failed;
    open += outcomes.back().open.size();
  }
  progress.stop();
  print(flags, outcomes);
  if (!flags.quiet) print_failed_records(flags, manifest, outcomes);
  print_open_records(manifest, outcomes);
  return open > 0 || failed > 0 ? kPartial : kOk;
}

int run(const RunFlags& flags) {
  try {
    return run_shards(flags);
  } catch (const MachineFault& fault) {
    std::cerr << "percuss: " << fault.written(flag_of) << '\n';
    return kPartial;
  }
}

}  // namespace

void add_batch_run(CommandLine& line) {
  auto flags = line.values<RunFlags>();
  Command command = line.command("batch run", "Analyse the records of a manifest, or one shard of them",
                                 [flags] { return run(*flags); });
  command.about(
      "Analyses the records of a manifest, each in one thread, and writes their rows to a folder. Without --shard, "
      "Slurm (SLURM_ARRAY_TASK_ID), Kubernetes (JOB_COMPLETION_INDEX) or GNU parallel (PARALLEL_SEQ minus one) sets "
      "the shard; without a scheduler all shards run. Finished records are stored at once: a run that was killed "
      "continues where it stopped. A record that cannot be analysed becomes a row with the reason, and the exit code "
      "is 6. If its file was missing, or not as planned, and is back, the next run analyses it. A fault of the machine "
      "(no process, memory or descriptor, a full disk) is no result: the record is tried again, then left open for the "
      "next run, and the exit code is 6.");
  command.example("percuss batch plan bat.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl -o results",
                  "Analyse all records on all processors of this machine");
  command.example(
      "percuss batch plan bat.h5 barrel.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl --shard 1/2 "
      "-o results",
      "Analyse the second of two shards");
  command.value("--manifest", flags->manifest, "Read the manifest of percuss batch plan").type("FILE").required();
  command.value("-o,--folder", flags->folder, "Write the results to this folder; it is created if necessary")
      .type("FOLDER")
      .required();
  command
      .value("--shard", flags->shard,
             "Run shard I of N, counted from 0. I alone: of the planned number of shards; all: run every shard")
      .type("I/N");
  command.value("--threads", flags->threads, "Use this many threads (default: all; the result is the same)")
      .within(0, 1024);
  add_budget_option(command, flags->budget);
  command.flag("--trust-input", flags->trust_input,
               "Read MAT, HDF5 and sound files in this process, without a sandbox");
  command.flag("--json", flags->json, "Print one JSON document on standard output");
  command.flag("--force", flags->force,
               "Discard existing results, even of another plan, and analyse all records again");
  command.flag("--quiet", flags->quiet, "Print no progress, and do not name failed records");
}

}  // namespace percuss::tools
