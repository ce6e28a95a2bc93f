#include "pipeline/run_analyses.hpp"

#include <algorithm>
#include <numbers>

namespace percuss::pipeline {
namespace {

template <class AnyRecord>
void assume_two_angles(AnyRecord& record, identify::ClassifyOptions& options) {
  options.angles_assumed = false;
  if (record.accel.size() != 2 || record.accel[0].angle_rad || record.accel[1].angle_rad) return;
  if (is_pressure(record.accel[0]) || is_pressure(record.accel[1])) return;
  if (options.object == identify::ObjectKind::other) return;
  if (options.object == identify::ObjectKind::automatic && !record.geometry.empty()) return;
  record.accel[0].angle_rad = 0;
  record.accel[1].angle_rad = std::numbers::pi / 2;
  options.angles_assumed = true;
}

}  // namespace

std::vector<std::pair<int, acquire::Record>> split_runs(const acquire::Record& record) {
  std::set<int> runs;
  for (const acquire::RowInfo& row : record.rows) runs.insert(row.run);
  std::vector<std::pair<int, acquire::Record>> out;
  if (runs.size() == 1) {
    out.emplace_back(*runs.begin(), record);
    return out;
  }
  out.reserve(runs.size());
  for (const int run : runs) {
    out.emplace_back(run, acquire::select_rows(record, [run](const acquire::RowInfo& row) { return row.run == run; }));
  }
  return out;
}

void assume_angles(acquire::Record& record, identify::ClassifyOptions& options) { assume_two_angles(record, options); }
void assume_angles(acquire::FrfRecord& frfs, identify::ClassifyOptions& options) { assume_two_angles(frfs, options); }

std::vector<RunAnalysis> analyses_of_runs(std::vector<acquire::Record> records, const AnalysisOptions& options) {
  std::vector<RunAnalysis> analyses;
  for (acquire::Record& record : records) {
    AnalysisOptions with_angles = options;
    assume_angles(record, with_angles.classes);
    for (auto& [run, part] : split_runs(record)) {
      const int number = records.size() > 1 ? static_cast<int>(analyses.size()) : run;
      analyses.push_back({.run = number, .analysis = std::make_unique<Analysis>(std::move(part), with_angles)});
    }
  }
  return analyses;
}

std::vector<RunAnalysis> analyses_of_runs(std::vector<acquire::FrfRecord> sets, const AnalysisOptions& options) {
  std::vector<RunAnalysis> analyses;
  for (acquire::FrfRecord& frfs : sets) {
    AnalysisOptions with_angles = options;
    assume_angles(frfs, with_angles.classes);
    const int number = static_cast<int>(analyses.size());
    analyses.push_back({.run = number, .analysis = std::make_unique<Analysis>(std::move(frfs), with_angles)});
  }
  return analyses;
}

std::vector<RunAnalysis> analyses_of_runs(std::variant<acquire::Record, acquire::FrfRecord> opened,
                                          const AnalysisOptions& options) {
  return std::visit(
      [&](auto& record) {
        std::vector<std::decay_t<decltype(record)>> all;
        all.push_back(std::move(record));
        return analyses_of_runs(std::move(all), options);
      },
      opened);
}

}  // namespace percuss::pipeline
