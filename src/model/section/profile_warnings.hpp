#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/warning.hpp"
#include "model/section/section_table.hpp"

namespace percuss::model {

/// A warning about a model's frequencies, and a number that shows its size.
struct ProfileWarning {
  warnings::Warning warning;
  double value = 0;
};

/// The codes of profile warnings. docs/reference/warnings.md has a row for each.
inline constexpr auto kProfileWarningCodes = std::to_array<warnings::RankedCode>({
    {"long_slices", warnings::Severity::warn},
    {"low_shear", warnings::Severity::warn},
});

/// The warning long_slices: frequencies depend on how the table was read. Its value is the largest relative difference
/// of a frequency. `freq_Hz` are the frequencies of the elastic modes with the table read as slices,
/// `other_Hz` with the table read as points. The first elastic mode has the number `first_mode`. Nothing for a table of
/// points.
std::optional<ProfileWarning> profile_warning(const SectionTable& table, const std::vector<double>& freq_Hz,
                                              const std::vector<double>& other_Hz, std::size_t first_mode);

/// The warning low_shear: a layer's Young's modulus is more than 30 times its shear modulus times shape factor, for
/// example if Young's modulus of a metal is stated and the shear modulus of wood stays. Its value is that ratio.
std::optional<ProfileWarning> shear_warning(const SectionTable& table, const Material& material);

}  // namespace percuss::model
