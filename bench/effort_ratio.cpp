// percuss_effort_ratio [LO:HI FILE]...: what each effort costs as a multiple of bare FFTW transforms of the same
// records (one per channel and hit, planned with FFTW_MEASURE, one thread, same run), and where the time goes. Without
// files: the bundled bat with a hoop doublet. Every time is the best of several, so that a disturbed run does not
// flatter.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "bare_fftw.hpp"
#include "pipeline/analysis.hpp"
#include "synth/read_spec.hpp"
#include "synth/record.hpp"

namespace percuss {
namespace {

constexpr double kLeast_s = 0.5;  // each figure is the best of as many repeats as fit in here, three at the least

template <class Work>
double best_s(Work work) {
  double best = 1e9;
  double all = 0;
  for (int n = 0; n < 3 || all < kLeast_s; ++n) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = std::min(best, took);
    all += took;
  }
  return best;
}

Record in_memory(const Record& record) {
  std::vector<std::vector<double>> force;
  std::vector<std::vector<std::vector<double>>> accel;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const std::size_t samples = record.rows[row].samples;
    record.read_force_N(row, 0, force.emplace_back(samples));
    accel.emplace_back();
    for (std::size_t c = 0; c < record.accel.size(); ++c)
      record.read_accel_mps2(row, c, 0, accel.back().emplace_back(samples));
  }
  Record copy = record_in_memory(record.fs_Hz, std::move(force), std::move(accel));
  copy.rows = record.rows;
  copy.accel = record.accel;
  for (SignalInfo& signal : copy.accel) signal.to_SI = 1;
  copy.continuous = record.continuous;
  return copy;
}

double bare_s(const Record& record) {
  const std::size_t samples = record.rows.front().samples;
  BareFftw fftw(samples, FFTW_MEASURE);
  std::vector<double> x(samples);
  record.read_force_N(0, 0, x);
  fftw.fill(x);
  const std::size_t transforms = record.rows.size() * (1 + record.accel.size());
  return best_s([&] {
    for (std::size_t n = 0; n < transforms; ++n) fftw.transform();
  });
}

void compare(const std::string& name, const Record& record, AnalysisOptions options) {
  options.threads = 1;
  const double bare = bare_s(record);
  fmt::print("{}: {} rows of {} samples, {} channels; bare transforms {:.2f} ms\n", name, record.rows.size(),
             record.rows.front().samples, 1 + record.accel.size(), bare * 1e3);
  for (const Effort effort : {Effort::quick, Effort::standard, Effort::best}) {
    options.modes.effort = effort;
    std::size_t modes = 0;
    std::string stages;
    const double took = best_s([&] {
      const Analysis analysis(record, options);
      modes = analysis.verdicts().size();
      stages.clear();
      for (const auto& stage : analysis.trace().stages())
        stages += fmt::format(" {} {:.2f}", stage.name, stage.seconds * 1e3);
    });
    fmt::print("  {:8} {:9.2f} ms  {:6.2f} x  {} modes; ms in{}\n", name_of(effort), took * 1e3, took / bare, modes,
               stages);
  }
}

std::pair<double, double> band_of(const std::string& text) {
  const auto colon = text.find(':');
  return {std::strtod(text.c_str(), nullptr), std::strtod(text.c_str() + colon + 1, nullptr)};
}

}  // namespace
}  // namespace percuss

int main(int count, char** arguments) {
  using namespace percuss;
  try {
    if (count < 3) compare("composite-bat", synthesise(synth_preset("composite-bat")).record, {});
    for (int i = 1; i + 1 < count; i += 2)
      compare(arguments[i + 1], in_memory(open_record(arguments[i + 1])), {.band_Hz = band_of(arguments[i])});
  } catch (const std::exception& problem) {
    fmt::print(stderr, "percuss_effort_ratio: {}\n", problem.what());
    return 1;
  }
  return 0;
}
