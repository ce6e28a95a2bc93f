#pragma once
#include <optional>
#include <string_view>

#include "acquire/record/frf.hpp"

namespace percuss::acquire {

/// The unit of an FRF as files state it.
struct FrfUnit {
  FrfKind kind = FrfKind::accelerance;
  double response_to_SI = 1;  // m/s², m/s or m per unit of the numerator
  double force_to_SI = 1;     // N per unit of the denominator
};

/// Response over force: "(m/s^2)/N", "m/s²/N", "g/N", "g/lbf", "(mm/s)/N", "m/N", "um/N"; also without the slash
/// between brackets, as some analysers write it: "(m/s²)(N)". Superscripts are UTF-8 or Latin-1. Empty for other
/// texts.
std::optional<FrfUnit> parse_frf_unit(std::string_view text);

/// The kind that a word in a header names: accelerance, inertance; mobility; receptance, compliance (letter case
/// aside).
std::optional<FrfKind> parse_frf_kind(std::string_view word);

}  // namespace percuss::acquire
