#pragma once
#include <string>
#include <vector>

namespace percuss::batch {

/// A job array of Slurm that runs shards of a batch. Paths are absolute.
struct SlurmJob {
  std::string program;                  // percuss itself
  std::string manifest, folder;         // … and of the results, in which the tasks' logs are kept as well
  std::size_t shards = 1;               // into how many the batch is divided
  std::vector<std::size_t> tasks;       // those to run
  std::size_t threads = 1;              // processors of a task
  std::vector<std::string> directives;  // further ones: "--partition=ci"
};

/// The script for sbatch.
std::string slurm_script(const SlurmJob& job);

/// `text` as one word of a shell.
std::string shell_quoted(const std::string& text);

/// The largest index that `scontrol show config` allows a job array, less one; 1000 where it does not tell.
std::size_t largest_array_index(const std::string& config);

}  // namespace percuss::batch
