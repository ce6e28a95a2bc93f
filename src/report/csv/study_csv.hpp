#pragma once
#include <string>

#include "core/io/csv_cell.hpp"
#include "metrics/study/study.hpp"

namespace percuss::report {

/// The statistics of each figure of the study, a row for each length of bats (StudyClass).
std::string study_csv(const metrics::Study& study, CsvFormulas formulas = CsvFormulas::neutralise);

/// The descriptive numbers of the groups, a row for each quantity.
std::string study_groups_csv(const metrics::Study& study, CsvFormulas formulas = CsvFormulas::neutralise);

}  // namespace percuss::report
