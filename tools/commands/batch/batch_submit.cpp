#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "batch/part.hpp"
#include "batch/slurm.hpp"
#include "batch/status.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "commands/batch/batch_commands.hpp"
#include "core/error.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

struct SubmitFlags {
  std::string engine, manifest, folder;
  std::vector<std::string> directives;
  std::size_t threads = 1;
  bool go = false;
};

using Pipe = std::unique_ptr<FILE, int (*)(FILE*)>;

// The output of a shell command; "" if it cannot run.
std::string output_of_command(const char* command) {
  const Pipe pipe(::popen(command, "r"), ::pclose);
  std::string text;
  std::array<char, 4096> block{};
  for (std::size_t got = 0; pipe && (got = std::fread(block.data(), 1, block.size(), pipe.get())) > 0;)
    text.append(block.data(), got);
  return text;
}

void require_size(const batch::SlurmJob& job) {
  const std::size_t largest = batch::largest_array_index(output_of_command("scontrol show config 2>/dev/null"));
  if (job.tasks.back() <= largest) return;
  throw InputError(fmt::format("shard {} is beyond Slurm's largest array index, {}", job.tasks.back(), largest),
                   "MaxArraySize", fmt::format("plan at most {} shards", largest + 1));
}

int submit_to_slurm(const batch::SlurmJob& job) {
  require_size(job);
  fs::create_directories(job.folder);  // Slurm creates the logs, but not their folder
  std::cout << std::flush;             // before the output of sbatch
  Pipe pipe(::popen("sbatch", "w"), ::pclose);
  const std::string script = batch::slurm_script(job);
  const bool taken = pipe && std::fwrite(script.data(), 1, script.size(), pipe.get()) == script.size();
  const int status = pipe ? ::pclose(pipe.release()) : -1;
  if (taken && status == 0) return kOk;
  throw InputError("sbatch did not accept the job", "Slurm", "see its message, or omit --go to print the script");
}

int submit(const SubmitFlags& flags) {
  for (const std::string& directive : flags.directives) {
    if (!directive.starts_with("--") || !batch::is_printable(directive))
      throw OptionError::wrong_value("sbatch", directive, "give an option of sbatch, such as --time=60");
  }
  const batch::BatchStatus found = batch::batch_status(batch::Manifest(flags.manifest), flags.folder);
  if (found.missing.empty()) {
    std::cerr << "percuss: all shards are finished; there is nothing to submit\n";
    return kOk;
  }
  const batch::SlurmJob job{.program = fs::read_symlink("/proc/self/exe").string(),
                            .manifest = fs::canonical(flags.manifest).string(),
                            .folder = fs::weakly_canonical(fs::absolute(flags.folder)).string(),
                            .shards = found.shards,
                            .tasks = found.missing,
                            .threads = flags.threads,
                            .directives = flags.directives};
  if (flags.go) return submit_to_slurm(job);
  std::cout << batch::slurm_script(job);
  return kOk;
}

}  // namespace

void add_batch_submit(CommandLine& line) {
  auto flags = line.values<SubmitFlags>();
  Command command = line.command("batch submit", "Submit the missing shards to Slurm as a job array",
                                 [flags] { return submit(*flags); });
  command.about(
      "Prints a script for sbatch that runs the missing shards, one task each. --go passes the script to sbatch. "
      "Repeat the command after killed tasks to submit their shards again.");
  command.example(
      "percuss batch plan bat.h5 barrel.h5 --shards 2 -o manifest.jsonl; percuss batch submit slurm --manifest "
      "manifest.jsonl -o results --sbatch=--time=60",
      "Print the script for inspection");
  command.argument("ENGINE", flags->engine, "Scheduler that runs the shards").one_of({"slurm"}).required();
  command.value("--manifest", flags->manifest, "Read the manifest of percuss batch plan --shards")
      .type("FILE")
      .required();
  command
      .value("-o,--folder", flags->folder, "Write the results to this folder, which all nodes must reach by this name")
      .type("FOLDER")
      .required();
  command.value("--threads", flags->threads, "Use this many threads, and processors, per task")
      .within(1, 1024)
      .show_default();
  command.repeatable("--sbatch", flags->directives, "Add an option of sbatch, such as --partition=long (repeatable)")
      .type("OPTION");
  command.flag("--go", flags->go, "Submit the script to sbatch");
}

}  // namespace percuss::tools
