#pragma once
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

/// Two channels without angles are taken as 0° and 90°, as the two-accelerometer test places them, with a note.
void assume_angles(acquire::Record& record);
void assume_angles(frf::FrfRecord& frfs);

/// A test and the number of its run.
struct RunAnalysis {
  int run = 0;
  std::unique_ptr<Analysis> analysis;
};

/// The tests in one file that was opened: its runs, each with its angles assumed where they are not stated.
std::vector<RunAnalysis> analyses_of_runs(std::variant<acquire::Record, frf::FrfRecord> opened,
                                          const AnalysisOptions& options);

}  // namespace percuss::pipeline
