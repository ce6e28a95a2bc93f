#include <algorithm>
#include <chrono>

#include "bindings.hpp"
#include "report/json/analysis_json.hpp"

// Timing of the library alone, for the overhead of the module (bench_overhead.py).
namespace percuss::python {

// The shortest of some runs of the work of `percuss.analyze(record, only="hits", threads=1)`.
Object library_seconds(PyObject* /*module*/, const Arguments& arguments) {
  const std::shared_ptr<const RecordHandle> held = RecordClass::of(arguments[0].get());
  const std::int64_t repeats = arguments[1].whole();
  double shortest = 1e9;
  {
    const ReleasedLock released;
    for (std::int64_t i = 0; i < repeats; ++i) {
      const auto start = std::chrono::steady_clock::now();
      const pipeline::Analysis analysis(held->record, {.threads = 1});
      const std::string document = report::analysis_json(analysis, {.sections = {report::ReportSection::hits}});
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (!document.empty()) shortest = std::min(shortest, seconds);
    }
  }
  return object_of(shortest);
}

}  // namespace percuss::python
