#pragma once
#include <string>
#include <vector>

namespace percuss::batch {

/// A job array of Slurm that runs shards of a batch. Paths are absolute.
struct SlurmJob {
  std::string program;                  // path of percuss
  std::string manifest, folder;         // folder of the results and of the logs of the tasks
  std::size_t shards = 1;               // number of shards of the batch
  std::vector<std::size_t> tasks;       // shards to run
  std::size_t threads = 1;              // per task
  std::vector<std::string> directives;  // further directives: "--partition=ci"
};

/// The script for sbatch.
/// errors  InputError: a path that is not printable
std::string slurm_script(const SlurmJob& job);

/// Whether each character of the text can be seen in a line: no line end, nothing that take_visible() escapes.
bool is_printable(const std::string& text);

/// `text` quoted as one word of a shell.
std::string shell_quoted(const std::string& text);

/// The largest index of a job array: one less than MaxArraySize in the output of `scontrol show config`; 1000 if it
/// is absent.
std::size_t largest_array_index(const std::string& config);

}  // namespace percuss::batch
