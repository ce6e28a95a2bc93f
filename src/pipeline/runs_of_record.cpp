#include "pipeline/runs_of_record.hpp"

#include <algorithm>
#include <numbers>

namespace percuss::pipeline {
namespace {

template <class AnyRecord>
void assume_two_angles(AnyRecord& record) {
  const bool none = !record.accel.empty() && std::none_of(record.accel.begin(), record.accel.end(),
                                                          [](const acquire::SignalInfo& s) { return s.angle_rad; });
  if (!none || record.accel.size() != 2) return;
  record.accel[0].angle_rad = 0;
  record.accel[1].angle_rad = std::numbers::pi / 2;
  record.notes.emplace_back(
      "the accelerometers' angles are not stated: taken as 0° and 90° around the barrel (--angle 0,90 confirms it)");
}

}  // namespace

void assume_angles(acquire::Record& record) { assume_two_angles(record); }
void assume_angles(frf::FrfRecord& frfs) { assume_two_angles(frfs); }

std::vector<RunAnalysis> analyses_of_runs(std::variant<acquire::Record, frf::FrfRecord> opened,
                                          const AnalysisOptions& options) {
  std::vector<RunAnalysis> tests;
  if (auto* frfs = std::get_if<frf::FrfRecord>(&opened)) {
    assume_angles(*frfs);
    tests.push_back({.run = 0, .analysis = std::make_unique<Analysis>(std::move(*frfs), options)});
    return tests;
  }
  auto& record = std::get<acquire::Record>(opened);
  assume_angles(record);
  for (auto& [run, part] : split_runs(record))
    tests.push_back({.run = run, .analysis = std::make_unique<Analysis>(std::move(part), options)});
  return tests;
}

}  // namespace percuss::pipeline
