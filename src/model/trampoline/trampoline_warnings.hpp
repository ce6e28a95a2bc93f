#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "model/trampoline/exponent_family.hpp"

namespace percuss::model {

enum class TrampolineSeverity { warn, info };
const char* name_of(TrampolineSeverity severity);

/// A limit of a model's result.
struct TrampolineWarning {
  std::string code, message;
  std::string remedy;  // what to do
  std::vector<OptionId> options;
  TrampolineSeverity severity = TrampolineSeverity::warn;
};

struct RankedTrampolineCode {
  std::string_view code;
  TrampolineSeverity severity;
};

/// All codes of trampoline_warnings(), most serious first. docs/reference/warnings.md has a row for each.
std::span<const RankedTrampolineCode> ranked_trampoline_codes();

/// What limits the result: a maximum at an end of the sweep, exponents that the CCOR does not determine, a bad fit.
/// Most serious first, each with the severity of its code.
std::vector<TrampolineWarning> trampoline_warnings(const Trampoline& model, const HoopPeak& peak,
                                                   const std::optional<FittedExponents>& fitted);

}  // namespace percuss::model
