#include "percuss/batch.hpp"

#include <mutex>
#include <utility>

#include "acquire/open_measurement.hpp"
#include "api/handles.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"

namespace percuss {
namespace api {
namespace {

BatchResult result_of(const pipeline::RunAnalysis& test, BatchResult result) {
  const pipeline::Analysis& analysis = *test.analysis;
  result.run = test.run;
  result.hits = hits_of(analysis.hits());
  if (analysis.possible()) {
    result.modes = modes_of(analysis.modes());
    result.classifications = classifications_of(analysis.classifications());
  }
  result.warnings = warnings_of(analysis.warnings());
  return result;
}

/// The results of every run of one input. An InputError becomes a result.
template <class Open>
std::vector<BatchResult> results_of(const BatchResult& label, const pipeline::AnalysisOptions& options,
                                    const Open& open) {
  std::vector<BatchResult> out;
  try {
    for (const pipeline::RunAnalysis& test : pipeline::analyses_of_runs(open(), options))
      out.push_back(result_of(test, label));
  } catch (const InputError& error) {
    out.push_back(label);
    out.back().error = error;
  }
  return out;
}

/// Opens and analyses the inputs on several threads. open(i) opens input i, and label(i) names it.
template <class Label, class Open>
std::vector<BatchResult> batch_of(std::size_t count, const BatchOptions& options, const Label& label,
                                  const Open& open) {
  pipeline::AnalysisOptions of_each = analysis_options(options.analysis);
  of_each.threads = 1;
  std::mutex one_call;
  std::vector<std::vector<BatchResult>> all(count);
  parallel_for(count, options.threads, [&](std::size_t i) {
    const ThreadLimit limit(1);
    all[i] = results_of({.index = i, .source = label(i)}, of_each, [&] { return open(i); });
    if (!options.on_result) return;
    const std::scoped_lock lock(one_call);
    for (const BatchResult& result : all[i]) options.on_result(result);
  });
  std::vector<BatchResult> out;
  for (std::vector<BatchResult>& results : all) {
    for (BatchResult& result : results) out.push_back(std::move(result));
  }
  return out;
}

}  // namespace
}  // namespace api

std::vector<BatchResult> analyze_batch(const std::vector<std::string>& paths, const BatchOptions& options) {
  const acquire::FrfReadOptions read = api::frf_read_options(options.read);
  std::mutex one_fork;  // a sandbox is a fork of this process: one at a time
  return api::batch_of(
      paths.size(), options, [&](std::size_t i) { return paths[i]; },
      [&](std::size_t i) -> acquire::Measurement {
        std::unique_lock lock(one_fork, std::defer_lock);
        if (read.read.sandboxed && acquire::needs_sandbox(paths[i])) lock.lock();
        return acquire::open_measurement(paths[i], read);
      });
}

std::vector<BatchResult> analyze_batch(const std::vector<Record>& records, const BatchOptions& options) {
  return api::batch_of(
      records.size(), options, [&](std::size_t i) { return records[i].data().record.source(); },
      [&](std::size_t i) -> acquire::Measurement { return records[i].data().record; });
}

}  // namespace percuss
