#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/analysis_options.hpp"
#include "pipeline/response/response_test.hpp"

namespace percuss::pipeline {

/// A test that differs from other tests in most of its modes.
struct DifferingTest {
  std::size_t test = 0;  // index
  double shared = 0;     // share of its modes that another test has, median over the other tests
};

/// The test that shares the fewest modes with the others, if it shares less than half; nothing if all agree. Two tests
/// share a mode if its frequencies differ by at most `bandwidths` half-power bandwidths or five standard deviations.
/// The share is taken of the test with fewer modes, of its eight most energetic modes. Tests without modes are left
/// out.
std::optional<DifferingTest> differing_test(const std::vector<ResponseTest>& tests, double bandwidths);

/// The tests of records without a force, in their order: one per record and run.
/// errors  as analyse_responses
std::vector<ResponseTest> tests_of_records(const std::vector<acquire::Record>& records, const AnalysisOptions& options,
                                           ResponseWork work = ResponseWork::modes);

/// The tests of several files, if the user does not state how the files belong together. Each file is analysed alone
/// first. If the files differ in most modes by more than a fifth of the bandwidth, each is a test of its own (warning
/// files_disagree in each test); otherwise all files are one test. Smaller differences, from a twentieth on, raise the
/// warning hits_differ. Files that hold several runs are joined without a comparison.
/// errors  InputError: as analyse_responses and acquire::join_records; files that differ where the options name hits,
/// which are hits of the test of all files
std::vector<ResponseTest> tests_of_files(const std::vector<acquire::Record>& records, const AnalysisOptions& options);

}  // namespace percuss::pipeline
