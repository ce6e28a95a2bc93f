#pragma once
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "pipeline/analysis.hpp"
#include "report/html/command_report.hpp"

namespace percuss::tools {

/// The extensions of the files that show_report() can write, for add_output_flags().
const std::vector<std::string>& report_extensions();

/// Checks the output paths for these kinds. Throws as check_outputs.
void check_report_outputs(const OutputFlags& flags);

/// Writes the output files, then prints the document or the text; returns kOk. The page names the files that were read,
/// `inputs`.
int show_report(const report::CommandReport& report, const OutputFlags& flags,
                const std::vector<std::string>& inputs = {});

/// The two steps of show_report, for commands with further kinds of file.
void write_report(const std::string& path, const report::CommandReport& report, const std::vector<std::string>& inputs,
                  const OutputFlags& flags);
void print_report(const report::CommandReport& report, const OutputFlags& flags);

/// Prints the stages of an analysis on standard error: name, calls and seconds.
void print_trace(const pipeline::Analysis& analysis);

/// Paths of the files that an analysis read.
std::vector<std::string> inputs_of(const pipeline::Analysis& analysis);

}  // namespace percuss::tools
