#include "batch/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include "batch/status.hpp"
#include "core/error.hpp"

namespace percuss::batch {
namespace {

// A line end in a path would begin another directive, and a hidden character would make the script look different.
void require_printable(const std::string& path) {
  if (is_printable(path)) return;
  throw InputError("the path holds a line end, another character that cannot be seen, or a byte that is not UTF-8",
                   path, "rename the folder or the file");
}

// Slurm replaces %A and other letters in names of logs.
std::string log_name(const std::string& folder) {
  std::string name;
  for (const char c : folder) name += c == '%' ? std::string("%%") : std::string(1, c);
  return name + "/slurm-%A-%a.log";
}

}  // namespace

bool is_printable(const std::string& text) { return one_line(text, std::string::npos) == text; }

std::string shell_quoted(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./:,=+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string slurm_script(const SlurmJob& job) {
  for (const std::string* path : {&job.program, &job.manifest, &job.folder}) require_printable(*path);
  std::string text =
      "#!/bin/sh\n"
      "#SBATCH --job-name=percuss-batch\n";
  text += fmt::format("#SBATCH --array={}\n", array_list(job.tasks));
  text += fmt::format("#SBATCH --cpus-per-task={}\n", job.threads);
  text += fmt::format("#SBATCH --output={}\n", shell_quoted(log_name(job.folder)));
  for (const std::string& directive : job.directives) text += "#SBATCH " + directive + "\n";
  text += fmt::format("exec {} batch run --manifest {} --shard \"$SLURM_ARRAY_TASK_ID/{}\" --threads {} -o {}\n",
                      shell_quoted(job.program), shell_quoted(job.manifest), job.shards, job.threads,
                      shell_quoted(job.folder));
  return text;
}

std::size_t largest_array_index(const std::string& config) {
  constexpr std::size_t kUsual = 1000;
  constexpr std::string_view kKey = "MaxArraySize";
  const std::size_t at = config.find(kKey);
  const std::size_t digits = at == std::string::npos ? at : config.find_first_of("0123456789", at);
  std::size_t size = 0;
  if (digits == std::string::npos) return kUsual;
  const auto [end, error] = std::from_chars(config.data() + digits, config.data() + config.size(), size);
  return error == std::errc{} && size > 0 ? size - 1 : kUsual;
}

}  // namespace percuss::batch
