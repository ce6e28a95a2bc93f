#include "pipeline/response/response_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/warnings/ranking.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMinShared = 0.5;
// In half-power bandwidths. From the first distance on, one fit of all files begins to list a mode several times. Below
// the second, a change of temperature and unequal hits are likelier than another structure.
constexpr double kSeparate = 0.2, kNoticed = 0.05;
constexpr double kMinDeviates = 5;       // standard deviations: a smaller difference is not significant
constexpr std::size_t kMaxCompared = 8;  // modes: the weak ones of a long list may be artefacts
constexpr std::size_t kPathBytes = 80;   // of a path in a message

bool is_shared(const identify::Mode& mode, const std::vector<identify::DecayMode>& others, double bandwidths) {
  return std::any_of(others.begin(), others.end(), [&](const identify::DecayMode& one) {
    const identify::Mode& other = one.mode;
    // The mean of the two half-power bandwidths, 2ζf.
    const double bandwidth_Hz =
        mode.pole.damping_ratio * mode.pole.freq_Hz + other.pole.damping_ratio * other.pole.freq_Hz;
    const double std_Hz = std::hypot(mode.freq_std_Hz, other.freq_std_Hz);
    return std::abs(mode.pole.freq_Hz - other.pole.freq_Hz) <=
           std::max(bandwidths * bandwidth_Hz, kMinDeviates * std_Hz);
  });
}

// The share of the modes of the test with fewer modes that the other test has.
double shared_modes(const ResponseTest& a, const ResponseTest& b, double bandwidths) {
  const bool first = a.found.modes.size() <= b.found.modes.size();
  std::vector<const identify::DecayMode*> fewer;
  for (const identify::DecayMode& one : (first ? a : b).found.modes) fewer.push_back(&one);
  const std::vector<identify::DecayMode>& more = (first ? b : a).found.modes;
  std::stable_sort(fewer.begin(), fewer.end(), [](const auto* x, const auto* y) { return x->energy > y->energy; });
  fewer.resize(std::min(fewer.size(), kMaxCompared));
  const auto shared = std::count_if(fewer.begin(), fewer.end(),
                                    [&](const auto* one) { return is_shared(one->mode, more, bandwidths); });
  return static_cast<double>(shared) / static_cast<double>(fewer.size());
}

std::string path_of(const ResponseTest& test) { return one_line(test.record.source(), kPathBytes); }

// "of the modes in a.wav, only 17 % are modes of the other files to within a fifth of their bandwidth".
std::string statement(const std::vector<ResponseTest>& files, const DifferingTest& found, const char* distance) {
  return fmt::format("of the modes in {}, only {:.0f} % are modes of the other files to within {} of their bandwidth",
                     path_of(files[found.test]), 100 * found.shared, distance);
}

std::string disagreement(const std::vector<ResponseTest>& files, const DifferingTest& found) {
  return statement(files, found, "a fifth") + ": the files measured different structures";
}

Warning files_disagree(const std::vector<ResponseTest>& files, const DifferingTest& found) {
  return with_remedy({"files_disagree", disagreement(files, found) + ". Each file is a test of its own", {"files"}},
                     "state how the files belong together, if they are hits of one structure");
}

Warning files_differ(const std::vector<ResponseTest>& files, const DifferingTest& found) {
  return with_remedy({"hits_differ",
                      statement(files, found, "a twentieth") + ": the frequencies listed are means over the files",
                      {"files"}},
                     "strike alike at an even temperature; or state that each file is a test of its own, if they are "
                     "of different structures");
}

void add_warning(ResponseTest& test, Warning warning) {
  test.warnings.push_back(std::move(warning));
  test.warnings = ranked(std::move(test.warnings));
}

bool names_a_hit(const AnalysisOptions& options) {
  const auto names = [](const std::vector<std::size_t>& hits) {
    return std::any_of(hits.begin(), hits.end(), [](std::size_t hit) { return hit != kEveryHit; });
  };
  return names(options.accept_hits) || names(options.reject_hits);
}

}  // namespace

std::optional<DifferingTest> differing_test(const std::vector<ResponseTest>& tests, double bandwidths) {
  std::optional<DifferingTest> worst;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    std::vector<double> shared;
    for (std::size_t other = 0; other < tests.size(); ++other) {
      if (other == t || tests[t].found.modes.empty() || tests[other].found.modes.empty()) continue;
      shared.push_back(shared_modes(tests[t], tests[other], bandwidths));
    }
    if (shared.empty()) continue;
    const double median_shared = median(shared);
    if (median_shared < (worst ? worst->shared : kMinShared)) worst = {.test = t, .shared = median_shared};
  }
  return worst;
}

std::vector<ResponseTest> tests_of_records(const std::vector<acquire::Record>& records, const AnalysisOptions& options,
                                           ResponseWork work) {
  std::vector<ResponseTest> tests;
  for (const acquire::Record& record : records) {
    for (auto& [run, part] : split_runs(record)) tests.push_back(analyse_responses(std::move(part), options, work));
  }
  return tests;
}

std::vector<ResponseTest> tests_of_files(const std::vector<acquire::Record>& records, const AnalysisOptions& options) {
  std::vector<acquire::Record> joined;
  joined.push_back(acquire::join_records(records, acquire::FileGrouping::automatic));
  const bool one_run = split_runs(joined.front()).size() == 1;
  if (records.size() < 2 || !one_run) return tests_of_records(joined, options);
  AnalysisOptions alone = options;
  if (names_a_hit(options)) alone.accept_hits = alone.reject_hits = {};  // these are hits of the joined record
  std::vector<ResponseTest> files = tests_of_records(records, alone);
  if (const auto found = differing_test(files, kSeparate)) {
    if (names_a_hit(options)) {
      throw InputError(disagreement(files, *found), joined.front().source(),
                       "analyse each file alone to choose its hits, or state how the files belong together", {"files"});
    }
    const Warning warning = files_disagree(files, *found);
    for (ResponseTest& file : files) add_warning(file, warning);
    return files;
  }
  std::vector<ResponseTest> tests = tests_of_records(joined, options);
  if (const auto found = differing_test(files, kNoticed)) add_warning(tests.front(), files_differ(files, *found));
  return tests;
}

}  // namespace percuss::pipeline
