#pragma once
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

/// The runs of a record (repeated tests in one file) as records of their own, ascending by run.
std::vector<std::pair<int, acquire::Record>> split_runs(const acquire::Record& record);

/// Sets the angles of two accelerations that state none to 0° and 90°, as in the two-accelerometer test of a tube. Not
/// for pressures, not for an `other` object, and for an `automatic` one only where the file holds no geometry. Notes it
/// in the options.
void assume_angles(acquire::Record& record, identify::ClassifyOptions& options);
void assume_angles(acquire::FrfRecord& frfs, identify::ClassifyOptions& options);

/// The analysis of one test, and the number of its run.
struct RunAnalysis {
  int run = 0;
  std::unique_ptr<Analysis> analysis;
};

/// One analysis per run of each record, with assumed angles where none are stated. Several records: the runs are
/// numbered from 0 in their order.
std::vector<RunAnalysis> analyses_of_runs(std::vector<acquire::Record> records, const AnalysisOptions& options);
/// One analysis per set of FRFs, numbered from 0.
std::vector<RunAnalysis> analyses_of_runs(std::vector<acquire::FrfRecord> sets, const AnalysisOptions& options);
std::vector<RunAnalysis> analyses_of_runs(std::variant<acquire::Record, acquire::FrfRecord> opened,
                                          const AnalysisOptions& options);

}  // namespace percuss::pipeline
