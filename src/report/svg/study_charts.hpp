#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/study/study.hpp"
#include "metrics/study/study_join.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// A file of the figures: its name ("besr-moi-wood-all.svg") and its text.
struct StudyFile {
  std::string name, text;
};

/// Every figure and every bat's trail, as a picture and as the table of its points.
std::vector<StudyFile> study_files(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {});

/// The same pictures alone.
std::vector<LineChart> study_charts(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {});

}  // namespace percuss::report
