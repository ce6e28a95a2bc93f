#pragma once
#include <memory>

#include "cli/open_files.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::tools {

/// The analysis of a survey's files. By default each file is a point. Files with names such as P1_1, P1_2, …
/// (acquire::files_of_hits) are hits of one point P1 if the stated geometry decides so (pipeline::judge_named_files).
/// If it decides nothing, they are hits if most of them agree with the others of their point. A note or the warning
/// files_as_points says how such files were taken.
/// errors  InputError: several runs; OptionError: files that are tests of their own
std::unique_ptr<pipeline::Analysis> survey_analysis(const ReadFlags& read, const pipeline::AnalysisOptions& options);

}  // namespace percuss::tools
