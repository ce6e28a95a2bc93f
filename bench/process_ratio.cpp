// percuss_process_ratio TOOL LO:HI FILE  (LO:HI: the band of the analysis in Hz)
// Prints wall-clock times of whole processes of the tool on a record in the page cache: start, hits, FRFs and modes,
// with one thread and with all. Also prints each time as a multiple of two others: bare FFTW transforms, and reading
// the force's bytes. There is one transform for each row and signal, in memory, on one thread, planned with
// FFTW_MEASURE (rows of 2^22 samples and more: FFTW_ESTIMATE). All alternate in one run, and the best time of each
// counts.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "acquire/open_measurement.hpp"
#include "acquire/record/record.hpp"
#include "fftw_baseline.hpp"
#include "wall_time.hpp"

namespace percuss {
namespace {

constexpr int kRounds = 12;
constexpr std::size_t kBlock_bytes = std::size_t{1} << 18U;

// Runs a command without its output. Throws unless it succeeds.
void run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int status = -1;
  const int error = ::posix_spawn(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0 || ::waitpid(child, &status, 0) != child || status != 0) throw std::runtime_error("the tool failed");
}

// Reads the given number of bytes of the file.
void read_bytes(const std::string& path, std::size_t bytes) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  std::vector<char> block(kBlock_bytes);
  while (bytes > 0) {
    const auto got = ::read(descriptor, block.data(), std::min(bytes, block.size()));
    if (got <= 0) break;
    bytes -= static_cast<std::size_t>(got);
  }
  ::close(descriptor);
}

std::vector<FftwSamples> force_of(const acquire::Record& record) {
  std::vector<FftwSamples> rows;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const std::size_t samples = record.rows[row].samples;
    record.read_force_N(row, 0, {rows.emplace_back(fftw_samples(samples)).get(), samples});
  }
  return rows;
}

struct Work {
  std::string name;
  std::function<void()> run;
  double best_s = 1e9;
};

void measure(const std::string& tool, const std::string& band, const std::string& path) {
  const acquire::Record record = acquire::open_record(path);
  const std::size_t samples = record.rows.front().samples, signals = 1 + record.accel.size();
  const std::size_t force_bytes = record.rows.size() * samples * sizeof(double);
  const auto force = force_of(record);
  FftwBaseline fftw(samples, samples < (std::size_t{1} << 22U) ? FFTW_MEASURE : FFTW_ESTIMATE);
  std::vector<Work> works{{"bare transforms",
                           [&] {
                             for (std::size_t n = 0; n < force.size() * signals; ++n)
                               fftw.transform(force[n % force.size()].get());
                           }},
                          {"reading the force's bytes", [&] { read_bytes(path, force_bytes); }},
                          {"reading all bytes", [&] { read_bytes(path, force_bytes * signals); }},
                          {"--version", [&] {
                             run({tool, "--version"});
                           }}};
  for (const char* only : {"hits", "frf", "modes"}) {
    for (const char* threads : {"1", "0"}) {
      works.push_back({fmt::format("--only {}{}", only, *threads == '1' ? " --threads 1" : ""), [=, &tool] {
                         run({tool, "analyze", path, "--band", band, "--json", "--only", only, "--threads", threads});
                       }});
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Work& work : works) work.best_s = std::min(work.best_s, seconds_of(work.run));
  }
  fmt::print("{}: {} rows of {} samples, {} signals, {:.1f} MB, of which the force {:.1f} MB\n", path,
             record.rows.size(), samples, signals, 1e-6 * static_cast<double>(force_bytes * signals),
             1e-6 * static_cast<double>(force_bytes));
  for (const Work& work : works) {
    fmt::print("  {:28} {:8.2f} ms  {:6.2f} x bare transforms  {:6.2f} x reading the force\n", work.name,
               work.best_s * 1e3, work.best_s / works[0].best_s, work.best_s / works[1].best_s);
  }
}

}  // namespace
}  // namespace percuss

int main(int count, char** arguments) {
  try {
    if (count != 4) throw std::runtime_error("usage: percuss_process_ratio TOOL LO:HI FILE");
    percuss::measure(arguments[1], arguments[2], arguments[3]);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "percuss_process_ratio: {}\n", problem.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
