#pragma once
#include <memory>
#include <vector>

#include "acquire/record/files_of_hits.hpp"
#include "acquire/record/record.hpp"
#include "cli/open_files.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::tools {

/// The groups of files whose names call them hits of one point, in the order of the files. Empty if a file states
/// points of its own.
std::vector<acquire::FilesOfHits> groups_of_files(const std::vector<acquire::Record>& records);

/// As above, for names with two numbers: the ways to read them (acquire::groupings_by_two_numbers).
std::vector<std::vector<acquire::FilesOfHits>> groupings_of_files(const std::vector<acquire::Record>& records);

/// The files of each group as hits of one point, with a note that says so. The points are 0, 1, … in the order of the
/// groups.
/// errors  InputError: as acquire::join_records()
acquire::Record record_of_groups(std::vector<acquire::Record> records, const std::vector<acquire::FilesOfHits>& groups);

/// The analysis of a survey's files. By default each file is a point. Files with names such as P1_1, P1_2, …
/// (acquire::files_of_hits) are hits of one point P1 if the stated geometry decides so (pipeline::judge_named_files).
/// If it decides nothing, they are hits if most of them agree with the others of their point. A note or the warning
/// files_as_points says how such files were taken. Files with two numbers in their names (Punkt1_Schlag1,
/// acquire::groupings_by_two_numbers) are taken likewise, as points without a warning.
/// errors  InputError: several runs; OptionError: files that are tests of their own
std::unique_ptr<pipeline::Analysis> survey_analysis(const ReadFlags& read, const pipeline::AnalysisOptions& options);

}  // namespace percuss::tools
