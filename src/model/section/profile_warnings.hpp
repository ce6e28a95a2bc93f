#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "model/section/section_table.hpp"

namespace percuss::model {

/// A warning about a model's frequencies.
struct ProfileWarning {
  std::string code, message;  // the message ends with the remedy
  std::string remedy;
  std::vector<OptionId> options;
  double value = 0;
};

/// The codes of profile warnings, all with the severity warn. docs/reference/warnings.md has a row for each.
inline constexpr std::array<std::string_view, 2> kProfileWarningCodes{"long_slices", "low_shear"};

/// The warning long_slices: frequencies depend on how the table was read. Its value is the largest relative difference
/// of a frequency. `freq_Hz` are the frequencies of the elastic modes with the table read as slices,
/// `other_Hz` with the table read as points. The first elastic mode has the number `first_mode`. Nothing for a table of
/// points.
std::optional<ProfileWarning> profile_warning(const SectionTable& table, const std::vector<double>& freq_Hz,
                                              const std::vector<double>& other_Hz, std::size_t first_mode);

/// The warning low_shear: a layer's Young's modulus is more than 30 times its shear modulus times shape factor, as
/// where Young's modulus of a metal is stated and the shear modulus of wood stays. Its value is that ratio.
std::optional<ProfileWarning> shear_warning(const SectionTable& table, const Material& material);

}  // namespace percuss::model
