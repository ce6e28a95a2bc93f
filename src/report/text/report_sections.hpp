#pragma once
#include <set>
#include <string>
#include <vector>

namespace percuss::report {

/// Sections of a report on an analysis. Only the stages that the chosen sections need are computed.
enum class ReportSection { hits, frf, coherence, modes, classes, deflection };

/// The sections named in a list such as {"hits", "modes"}. errors  UsageError: an unknown name.
std::set<ReportSection> parse_report_sections(const std::vector<std::string>& names);
/// All except the deflection, which must be chosen explicitly.
std::set<ReportSection> default_sections();

}  // namespace percuss::report
