#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/warning.hpp"
#include "model/trampoline/exponent_family.hpp"

namespace percuss::model {

/// All codes of trampoline_warnings(), most serious first. docs/reference/warnings.md has a row for each.
std::span<const warnings::RankedCode> ranked_trampoline_codes();

/// What limits the result: a maximum at an end of the sweep, exponents that the CCOR does not determine, a bad fit.
/// Most serious first, each with the severity of its code.
std::vector<warnings::Warning> trampoline_warnings(const Trampoline& model, const HoopPeak& peak,
                                                   const std::optional<FittedExponents>& fitted);

}  // namespace percuss::model
