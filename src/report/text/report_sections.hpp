#pragma once
#include <set>
#include <string>
#include <vector>

namespace percuss::report {

/// Parts of an analysis that a report can hold; naming them is the demand that computes them.
enum class ReportSection { hits, frf, coherence, modes, classes, deflection };

/// The sections named in a list such as {"hits", "modes"}; UsageError names the known ones.
std::set<ReportSection> parse_report_sections(const std::vector<std::string>& names);
/// All but the deflection, which is a question of its own.
std::set<ReportSection> default_sections();

}  // namespace percuss::report
