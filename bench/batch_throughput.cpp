// percuss_batch_throughput [RECORDS]
// Compares a batch with the bare library, in records/s:
//   - a loop that opens and analyses each record and keeps nothing
//   - run_shard on one thread, which also writes rows and journal
//   - run_shard on two threads
// The three alternate in one run, and the best of five times of each counts. "arithmetic" is the speed-up of two tasks
// without memory access, the limit for two threads. Also prints the peak memory of two processes, with 100 and with
// RECORDS (default 10 000) records. All records are hard links to fifty different files with hits of 512 samples.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "batch/plan.hpp"
#include "batch/run_shard.hpp"
#include "core/io/temporary_folder.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/text/version.hpp"
#include "synth/synthesise.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 5;
constexpr std::size_t kDifferent = 50;
constexpr std::size_t kRecordsCompared = 500;  // of each format

synth::SynthSpec small_test(std::size_t seed) {
  synth::SynthSpec spec;
  spec.fs_Hz = 4096;
  spec.samples = 512;
  spec.band_high_Hz = 1500;
  spec.hits = 2;
  spec.seed = seed;
  spec.pulse.width_s = 0.0008;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  spec.modes = {{.freq_Hz = 200, .damping_ratio = 0.03},
                {.freq_Hz = 700, .damping_ratio = 0.02, .type = synth::SynthModeType::hoop}};
  return spec;
}

std::string subfolder_of(const TemporaryFolder& folder, const std::string& name) {
  fs::create_directories(folder.file(name));
  return folder.file(name);
}

// Writes records of one format and their manifest. Returns the path of the manifest.
std::string write_manifest_of(const TemporaryFolder& folder, const std::string& kind, std::size_t records) {
  const std::string seeds = subfolder_of(folder, "seeds"),
                    place = subfolder_of(folder, fmt::format("{}-{}", kind, records));
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < records; ++i) {
    const std::string seed = fmt::format("{}/{}.{}", seeds, i % kDifferent, kind);
    if (!fs::exists(seed)) acquire::write_record(seed, synth::synthesise(small_test(i % kDifferent)).record, false);
    paths.push_back(fmt::format("{}/{}.{}", place, i, kind));
    if (!fs::exists(paths.back())) fs::create_hard_link(seed, paths.back());
  }
  std::string manifest = place + ".jsonl";
  batch::write_manifest(manifest, {.version = report::version(), .options = {}, .setup = {}},
                        batch::records_of_files(paths, ".", false), true);
  return manifest;
}

batch::RowOptions options() {
  batch::RowOptions out;
  out.read.read.sandboxed = true;
  out.analysis.threads = 1;
  return out;
}

void analyse_in_loop(const batch::Manifest& manifest) {
  const batch::RowOptions how = options();
  for (std::size_t i = 0; i < manifest.size(); ++i) {
    for (const pipeline::RunAnalysis& test :
         pipeline::analyses_of_runs(acquire::open_measurement(manifest.record(i).path, how.read), how.analysis)) {
      test.analysis->hits();
      test.analysis->classifications();
      test.analysis->warnings();
    }
  }
}

void run_batch(const batch::Manifest& manifest, std::size_t threads, const std::string& results) {
  fs::remove_all(results);
  fs::create_directories(results);
  batch::RowOptions how = options();
  how.fork_server = acquire::measurement_fork_server(how.read);
  batch::run_shard({.manifest = &manifest, .folder = results, .options = how, .threads = threads});
}

// The best wall-clock and processor times; processor time includes child processes.
struct ElapsedTime {
  double clock_s = 1e9, processor_s = 1e9;

  template <class Work>
  void measure(Work work) {
    const auto start = std::chrono::steady_clock::now();
    const double before_s = processor_now_s();
    work();
    clock_s = std::min(clock_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    processor_s = std::min(processor_s, processor_now_s() - before_s);
  }

 private:
  static double processor_now_s() {
    double sum_s = 0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage used{};
      ::getrusage(who, &used);
      for (const timeval& part : {used.ru_utime, used.ru_stime})
        sum_s += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
    return sum_s;
  }
};

// Runs two equal tasks without memory access, in sequence or in parallel.
void run_arithmetic(std::size_t threads) {
  static std::array<volatile double, 2> sums{};  // prevents removal by the optimiser
  parallel_for(2, threads, [](std::size_t i) {
    double x = 0.5;
    for (int n = 0; n < 50'000'000; ++n) x = 3.9 * x * (1 - x);
    sums.at(i) = x;
  });
}

void compare(const TemporaryFolder& folder, const std::string& kind) {
  const batch::Manifest manifest(write_manifest_of(folder, kind, kRecordsCompared));
  const std::string results = folder.file("results");
  ElapsedTime in_loop, on_one, on_two, sequential, parallel;
  for (int round = 0; round < kRounds; ++round) {
    in_loop.measure([&] { analyse_in_loop(manifest); });
    on_one.measure([&] { run_batch(manifest, 1, results); });
    on_two.measure([&] { run_batch(manifest, 2, results); });
    sequential.measure([] { run_arithmetic(1); });
    parallel.measure([] { run_arithmetic(2); });
  }
  const auto rate = [&](double seconds) { return static_cast<double>(manifest.size()) / seconds; };
  fmt::print(
      "{:4} bare loop {:5.0f}/s; batch {:5.0f}/s, {:.2f} x; on two threads {:5.0f}/s, {:.2f} x (arithmetic {:.2f} x)",
      kind, rate(in_loop.clock_s), rate(on_one.clock_s), in_loop.clock_s / on_one.clock_s, rate(on_two.clock_s),
      on_one.clock_s / on_two.clock_s, sequential.clock_s / parallel.clock_s);
  fmt::print("; records per processor second {:.0f}, {:.0f} ({:.2f} x), {:.0f} ({:.2f} x)\n", rate(in_loop.processor_s),
             rate(on_one.processor_s), in_loop.processor_s / on_one.processor_s, rate(on_two.processor_s),
             on_one.processor_s / on_two.processor_s);
}

// The peak memory of a child process that runs the batch on two threads.
// errors  std::runtime_error: the batch failed.
double largest_memory_MB(const TemporaryFolder& folder, const std::string& manifest) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      run_batch(batch::Manifest(manifest), 2, folder.file("results"));
      ::_exit(0);
    } catch (const std::exception& error) {  // the parent owns the folder: no destructor may run here
      fmt::print(stderr, "{}\n", error.what());
      ::_exit(1);
    }
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  if (status != 0) throw std::runtime_error("the batch failed in the child process");
  return static_cast<double>(used.ru_maxrss) * 1024 / 1e6;  // ru_maxrss is in KiB
}

void compare_memory(const TemporaryFolder& folder, std::size_t records) {
  const std::string few = write_manifest_of(folder, "csv", 100), many = write_manifest_of(folder, "csv", records);
  const double few_MB = largest_memory_MB(folder, few), many_MB = largest_memory_MB(folder, many);
  fmt::print("largest memory on two threads: {:.1f} MB for 100 records, {:.1f} MB for {}, {:.2f} x\n", few_MB, many_MB,
             records, many_MB / few_MB);
}

}  // namespace
}  // namespace percuss

int main(int count, char** arguments) {
  using namespace percuss;
  try {
    const TemporaryFolder folder("percuss-batch");
    // Memory first: it forks, and a process with threads must not fork.
    compare_memory(folder, count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 10000);
    for (const char* kind : {"csv", "uff", "h5"}) compare(folder, kind);
    return EXIT_SUCCESS;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "percuss_batch_throughput: {}\n", problem.what());
    return EXIT_FAILURE;
  }
}
