#pragma once
/// Many records in one process, on several threads. A record that cannot be analysed gives a result with an error.
/// For batches that survive a kill, or that run on a cluster, see `percuss batch`.
///
/// @code
/// #include <iostream>
/// #include <percuss/batch.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   std::vector<percuss::Record> records;  // or paths: std::vector<std::string>
///   for (const unsigned seed : {1U, 2U, 3U})
///     records.push_back(percuss::synthesise_preset("wood-bat", {.seed = seed}).record);
///   const auto results = percuss::analyze_batch(
///       records, {.analysis = {.band_Hz = percuss::Band{60, 3200}, .effort = percuss::Effort::quick}});
///   for (const percuss::BatchResult& result : results) {
///     if (result.error) std::cout << result.index << ": " << result.error->what() << '\n';
///     if (!result.error) std::cout << result.index << ": " << result.modes.size() << " modes\n";
///   }
/// }
/// @endcode
#include <percuss/analysis.hpp>
#include <percuss/error.hpp>
#include <percuss/record.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace percuss {

/// The results of one test.
struct BatchResult {
  std::size_t index = 0;  // of the path or record
  int run = 0;            // the number of the repeated test in that record
  std::string source;     // the path, or the record's format
  std::vector<Hit> hits{};
  std::vector<Mode> modes{};
  std::vector<ModeClassification> classifications{};  // one per mode
  std::vector<Warning> warnings{};
  std::optional<InputError> error{};  // why results are missing; other exceptions are passed on
};

struct BatchOptions {
  ReadOptions read{};          // of every path
  AnalysisOptions analysis{};  // of every record; its `threads` is not used
  std::size_t threads = 0;     // 0: all. One thread analyses each record; the results do not depend on the number
  std::function<void(const BatchResult&)> on_result{};  // one call at a time, on any thread, in the order of completion
};

/// Results in the order of the input; several runs of one record follow each other. A path may be a record or a file of
/// FRFs. errors  InputError: options that contradict each other, a channel set-up that cannot be read.
std::vector<BatchResult> analyze_batch(const std::vector<std::string>& paths, const BatchOptions& options = {});
std::vector<BatchResult> analyze_batch(const std::vector<Record>& records, const BatchOptions& options = {});

}  // namespace percuss
