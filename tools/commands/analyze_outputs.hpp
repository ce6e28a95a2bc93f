#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "commands/analyze_tests.hpp"
#include "report/html/command_report.hpp"

namespace percuss::tools {

/// What was found, also for who runs the command in his own process and asks for the rest later.
struct AnalyzeResults {
  AnalyzeFlags flags;
  std::vector<Test> tests;
  std::set<report::ReportSection> sections;
  std::string document;
  std::optional<report::CommandReport> comparison;
};

/// UsageError for files that analyze does not write.
void check_analyze_outputs(const OutputFlags& output);

/// Before anything is computed: UsageError for what is asked of several tests and can be had of one only.
void require_one_test(const AnalyzeFlags& flags, const std::set<report::ReportSection>& sections, std::size_t tests);

/// What a terminal shows; with a sketch of the FRFs where it can draw one.
std::string text_of(const AnalyzeResults& kept, std::size_t width, bool sketch);

/// Every -o of the flags.
void write_outputs(const AnalyzeFlags& flags, const AnalyzeResults& kept);

/// All of it to the program in whose process the command runs.
void give_to_host(const OutputFlags& output, const std::shared_ptr<const AnalyzeResults>& kept);

}  // namespace percuss::tools
