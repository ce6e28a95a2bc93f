#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// What the results contain beyond hits and FRFs.
struct MethodScope {
  bool modes = true;           // the fit of modes
  bool shapes_decide = false;  // bending or hoop follows from the shapes of a survey, not from two sensors
  const pipeline::ImpactTest* deflection = nullptr;
};

/// How the results were made, in sentences: record, hits used and why others were not, gate, window, FRFs, modes, their
/// ±, and the user's choices. Numbers in parentheses are equations of docs/theory/theory.md. Names only what ran.
std::vector<std::string> method_sentences(const pipeline::Analysis& analysis, const MethodScope& scope);

/// The channels of a record: name, stored unit and factor, angle, position.
TextTable channels_table(const pipeline::Analysis& analysis);

}  // namespace percuss::report
