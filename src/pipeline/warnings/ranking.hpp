#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

using warnings::RankedCode;

/// All codes of an analysis's warnings and findings, most serious first within each severity.
/// docs/reference/warnings.md has a row for each.
std::span<const RankedCode> ranked_codes();

/// The severity of a warning's code; `warn` for a code that the ranking does not know.
warnings::Severity severity_of(std::string_view code);

/// The warnings with their severities, most serious first: by severity, then by the consequence of their codes.
/// Warnings of one code keep their order.
std::vector<Warning> ranked(std::vector<Warning> warnings);

/// Warnings and the hits' findings together, ranked: each code of a finding once, with the numbers of its hits and the
/// message of its first hit. A finding of hits that are not used counts as `info`, because these hits have no part in
/// the results. A finding is left out where a warning summarises it. Equal messages count once.
std::vector<Warning> trust_statements(const std::vector<Warning>& warnings, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
