// percuss_accuracy [--quick] FOLDER
// Measures the errors of percuss against exact truth and their cost in time. Writes accuracy.md and its charts
// (accuracy-*.svg) to FOLDER, over existing files, and the table for README.md to standard output. It takes five
// minutes. --quick runs a minimum of cases in seconds.
#include <fftw3.h>
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "build_description.hpp"
#include "charts.hpp"
#include "core/io/atomic_file.hpp"
#include "deflection_study.hpp"
#include "impact_study.hpp"
#include "page.hpp"
#include "skipped_work_study.hpp"

namespace percuss::accuracy {
namespace {

constexpr TimingOptions kTiming, kQuickTiming{.min_rounds = 1, .min_total_s = 0, .min_work_s = 0};
constexpr double kScalingBudget_s = 125;

// The last section of the existing page, which bench/real_structures.py writes; empty without one.
std::string section_of_real_structures(const std::string& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t at = text.find("\n## On real structures\n");
  return at == std::string::npos ? "" : text.substr(at);
}

void measure_all(Extent extent, const std::string& folder) {
  if (extent == Extent::quick) fftw_set_timelimit(0);  // no planning by measurement
  const TimingOptions timing = extent == Extent::quick ? kQuickTiming : kTiming;
  Measured all;
  all.scalings = study_scaling(extent, timing, kScalingBudget_s);
  all.savings = study_skips(extent, timing);
  all.impact = study_impact(extent, timing);
  all.deflection = study_deflection(extent, timing);
  all.records = study_records(extent, timing);
  for (const TaskFigures* task : {&all.impact, &all.deflection, &all.records.frfs, &all.records.modes})
    write_file(fmt::format("{}/accuracy-{}.svg", folder, task->name), task_svg(*task), true);
  write_file(folder + "/accuracy-scaling.svg", scaling_svg(all.scalings), true);
  const std::string page = folder + "/accuracy.md";
  write_file(page, page_of(all, build_description()) + section_of_real_structures(page), true);
  fmt::print("{}", short_table(all));
}

}  // namespace
}  // namespace percuss::accuracy

int main(int argc, char** argv) {
  using percuss::accuracy::Extent;
  const bool quick = argc == 3 && std::string_view(argv[1]) == "--quick";
  if (argc != 2 && !quick) {
    fmt::print(stderr, "usage: percuss_accuracy [--quick] FOLDER\n");
    return EXIT_FAILURE;
  }
  try {
    percuss::accuracy::measure_all(quick ? Extent::quick : Extent::full, argv[argc - 1]);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    fmt::print(stderr, "percuss_accuracy: {}\n", e.what());
    return EXIT_FAILURE;
  }
}
