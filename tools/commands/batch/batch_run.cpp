#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "acquire/open_measurement.hpp"
#include "batch/part.hpp"
#include "batch/run_shard.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "commands/batch/batch_options.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

struct RunFlags {
  std::string manifest, folder, shard;
  std::size_t threads = 0;
  bool trust_input = false, force = false, json = false, quiet = false;
};

// Which shards are to be run, of how many.
struct ShardSelection {
  std::optional<std::size_t> shard;   // none: all
  std::optional<std::size_t> shards;  // none: as the folder or the manifest says
};

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

ShardSelection parse_shard_selection(const std::string& text) {
  if (text == "all") return {};
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto shard = whole_number(std::string_view(text).substr(0, slash));
  const auto shards = slash < text.size() ? whole_number(std::string_view(text).substr(slash + 1)) : std::nullopt;
  if (!shard || (slash < text.size() && (!shards || *shards < 1 || *shards > batch::kMaxShards))) {
    throw UsageError("--shard cannot be '" + one_line(text, 40) + "'",
                     "give I/N, as 0/7 to 6/7; or I alone, of as many as were planned; or all");
  }
  return {.shard = shard, .shards = shards};
}

// What an engine tells its workers. GNU parallel counts from 1.
ShardSelection shard_selection_of_scheduler() {
  for (const auto& [name, first] :
       {std::pair{"SLURM_ARRAY_TASK_ID", 0U}, {"JOB_COMPLETION_INDEX", 0U}, {"PARALLEL_SEQ", 1U}}) {
    const char* const text = std::getenv(name);
    if (text == nullptr) continue;
    const auto number = whole_number(text);
    if (number && *number >= first) return {.shard = *number - first, .shards = std::nullopt};
    throw UsageError(fmt::format("{} is '{}', which is no shard", name, one_line(text, 40)),
                     "give --shard I/N, or all");
  }
  return {};
}

std::vector<std::size_t> shards_to_run(const ShardSelection& share, std::size_t shards) {
  if (share.shard && *share.shard >= shards) {
    throw UsageError(fmt::format("there is no shard {} of {}", *share.shard, shards),
                     "they count from 0; percuss batch plan --shards N says how many there are");
  }
  if (share.shard) return {*share.shard};
  std::vector<std::size_t> all(shards);
  for (std::size_t i = 0; i < shards; ++i) all[i] = i;
  return all;
}

std::string remaining(std::size_t done, std::size_t total, double seconds) {
  const double rate = static_cast<double>(done) / seconds;
  std::string text = fmt::format("analysing … {} of {}", done, total);
  if (done == 0) return text;
  return text + fmt::format(", {:.3g}/s, {:.0f} s left", rate, static_cast<double>(total - done) / rate);
}

void print(const RunFlags& flags, const std::vector<batch::ShardOutcome>& outcomes) {
  std::size_t records = 0, failed = 0, analysed = 0;
  auto shards = nlohmann::ordered_json::array();
  for (const batch::ShardOutcome& outcome : outcomes) {
    records += outcome.part.records;
    failed += outcome.part.failed;
    analysed += outcome.analysed;
    shards.push_back({{"shard", outcome.part.label.shard},
                      {"records", outcome.part.records},
                      {"failed", outcome.part.failed},
                      {"analysed", outcome.analysed}});
  }
  const std::size_t of = outcomes.front().part.label.shards;
  if (flags.json) {
    const nlohmann::ordered_json json{
        {"schema", "percuss/batch-run/1"}, {"version", report::version()}, {"of", of}, {"shards", shards}};
    std::cout << json.dump(2) << '\n';
    return;
  }
  if (flags.quiet) return;
  const std::string which = of == 1 ? "finished"
                            : outcomes.size() > 1
                                ? fmt::format("finished in {} shards", of)
                                : fmt::format("finished in shard {} of {}", outcomes.front().part.label.shard, of);
  std::cout << fmt::format("{} records {}, {} of them now; {} failed\n", records, which, analysed, failed);
}

// Results stay where they were meant to be when the working folder changes.
std::string results_folder(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw InputError("cannot make the folder: " + problem.message(), folder, "name one that can be written");
  return fs::canonical(folder).string();
}

// Of the shards in the folder there is one division, so that all of them fit together.
std::size_t division(const RunFlags& flags, const ShardSelection& share, const batch::Manifest& manifest,
                     const std::string& folder) {
  const auto found = batch::shard_count_in(folder);
  const std::size_t wanted = share.shards.value_or(found.value_or(manifest.head().shards));
  if (!found || *found == wanted) return wanted;
  throw InputError(fmt::format("holds shards of a division into {}, not into {}", *found, wanted), flags.folder,
                   "keep to that, or name another folder");
}

int run(const RunFlags& flags) {
  const ShardSelection share =
      flags.shard.empty() ? shard_selection_of_scheduler() : parse_shard_selection(flags.shard);
  const batch::Manifest manifest(flags.manifest);
  batch::RowOptions options = row_options(manifest, flags.trust_input);
  const std::string folder = results_folder(flags.folder);
  const std::size_t shards = division(flags, share, manifest, folder);
  const auto wanted = shards_to_run(share, shards);
  // Records are named, in messages too, as they are from the manifest's folder.
  if (const fs::path parent = fs::path(flags.manifest).parent_path(); !parent.empty()) fs::current_path(parent);
  // Before there are threads, and from the folder that the records are read from.
  if (options.read.read.sandboxed) options.fork_server = frf::measurement_fork_server(options.read);
  std::atomic<std::size_t> done{0};
  std::size_t total = 0;
  for (const std::size_t i : wanted) total += manifest.shard(i, shards).size();
  const Progress progress([&done, total](double seconds) { return remaining(done, total, seconds); }, flags.quiet);
  std::vector<batch::ShardOutcome> outcomes;
  std::size_t failed = 0;
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
  }
  progress.stop();
  print(flags, outcomes);
  return failed > 0 ? kPartial : kOk;
}

}  // namespace

void add_batch_run(CommandLine& line) {
  auto flags = line.values<RunFlags>();
  Command command =
      line.command("batch run", "Analyses a manifest's records, or one shard of them", [flags] { return run(*flags); });
  command.about(
      "Analyses the records of a manifest, each in one thread, and writes their rows to a folder. Without --shard it "
      "is "
      "told its shard by Slurm (SLURM_ARRAY_TASK_ID), Kubernetes (JOB_COMPLETION_INDEX) or GNU parallel (PARALLEL_SEQ, "
      "less one), and runs all shards where none of them speaks. What is finished is kept at once: run again after a "
      "kill at any moment, it goes on where it was. A record that cannot be analysed is a row with the reason, and the "
      "exit code is 6 then.");
  command.example("percuss batch plan bat.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl -o results",
                  "All records, on all processors of this machine");
  command.example(
      "percuss batch plan bat.h5 barrel.h5 -o manifest.jsonl; percuss batch run --manifest manifest.jsonl --shard 1/2 "
      "-o "
      "results",
      "The second of two shards");
  command.value("--manifest", flags->manifest, "What percuss batch plan wrote").type("FILE").required();
  command.value("-o,--folder", flags->folder, "Folder of the results; made where there is none")
      .type("FOLDER")
      .required();
  command.value("--shard", flags->shard, "Run shard I of N, counted from 0; or I of as many as were planned; or all")
      .type("I/N");
  command.value("--threads", flags->threads, "Threads to use (default: all; the result is the same)").within(0, 1024);
  command.flag("--trust-input", flags->trust_input,
               "Read MAT and HDF5 files in this process, not in a confined one of their own");
  command.flag("--json", flags->json, "One JSON document on standard output");
  command.flag("--force", flags->force, "Analyse anew what was finished, whatever plan it was of");
  command.flag("--quiet", flags->quiet, "No progress and no summary");
}

}  // namespace percuss::tools
