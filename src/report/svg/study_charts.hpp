#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/study/study.hpp"
#include "metrics/study/study_files.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// A file with a figure: its name ("besr-moi-wood-all.svg") and its contents.
struct StudyFile {
  std::string name, text;
};

/// Each figure and the history of each bat with several states, as a chart and as a table of its points; then
/// "figures.csv", which lists the figures with their numbers in the source.
std::vector<StudyFile> study_files(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {},
                                   CsvFormulas formulas = CsvFormulas::neutralise);

/// The charts alone.
std::vector<LineChart> study_charts(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {});

}  // namespace percuss::report
