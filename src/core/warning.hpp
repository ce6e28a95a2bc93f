#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

/// Warnings of all layers. (The public Warning and Severity of include/percuss are types of their own.)
namespace percuss::warnings {

/// reject: the results that the warning names are wrong until the remedy is applied; warn: they may be off by more than
/// their ±; info: nothing is wrong.
enum class Severity { info, warn, reject };
/// "info", "warn" or "reject".
const char* name_of(Severity severity);

/// A warning about a result: its code for programs, a sentence for people, and the options that the sentence is about.
struct Warning {
  std::string code;
  std::string message;
  std::vector<OptionId> options{};
  std::string remedy{};                // what to do; the end of `message`, see with_remedy()
  std::optional<Severity> severity{};  // without a value the code decides, see ranked()
};

/// The warning with a remedy, which ends its message: "MESSAGE; REMEDY".
Warning with_remedy(Warning warning, std::string remedy);

/// A code in a ranking, which lists codes in the order of their consequences.
struct RankedCode {
  std::string_view code;
  Severity severity;
};

/// The severity of a warning's code; `warn` for a code that the ranking does not know.
Severity severity_of(std::string_view code, std::span<const RankedCode> ranking);

/// The warnings with their severities, most serious first: by severity, then by the order of their codes in the
/// ranking. Unknown codes come last within their severity. Warnings of one code keep their order.
std::vector<Warning> ranked(std::vector<Warning> warnings, std::span<const RankedCode> ranking);

}  // namespace percuss::warnings
