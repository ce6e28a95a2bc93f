#pragma once
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "pipeline/analysis.hpp"
#include "report/html/command_report.hpp"

namespace percuss::tools {

constexpr const char* kReportKinds = ".json, .csv, .svg, .html";

/// The kinds of file that reports are written to: .json, .csv, .svg and .html. UsageError or InputError as
/// check_outputs.
void check_report_outputs(const OutputFlags& flags);

/// Writes the files asked for, then the document or the text to standard output; returns kOk. The page names the files
/// that were read, `inputs`.
int show_report(const report::CommandReport& report, const OutputFlags& flags,
                const std::vector<std::string>& inputs = {});

/// The same in two steps, for commands that have kinds of file of their own.
void write_report(const std::string& path, const report::CommandReport& report, const std::vector<std::string>& inputs,
                  const OutputFlags& flags);
void print_report(const report::CommandReport& report, const OutputFlags& flags);

/// The files that an analysis read.
std::vector<std::string> inputs_of(const pipeline::Analysis& analysis);

}  // namespace percuss::tools
