#include <algorithm>
#include <chrono>

#include "bindings.hpp"
#include "report/json/analysis_json.hpp"

// Timing of the library alone, for the overhead of the module (bench_overhead.py).
namespace percuss::python {
namespace {

namespace py = pybind11;

/// The shortest of `repeats` runs of the work of `percuss.analyze(record, only="hits", threads=1)`.
double library_seconds(const RecordHandle& held, std::size_t repeats) {
  const py::gil_scoped_release release;
  double shortest = 1e9;
  for (std::size_t i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const pipeline::Analysis analysis(held.record, {.threads = 1});
    const std::string document = report::analysis_json(analysis, {.sections = {report::ReportSection::hits}});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!document.empty()) shortest = std::min(shortest, seconds);
  }
  return shortest;
}

}  // namespace

void bind_overhead(py::module_& module) { module.def("library_seconds", &library_seconds); }

}  // namespace percuss::python
