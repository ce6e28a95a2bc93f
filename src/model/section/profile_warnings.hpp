#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "model/section/section_table.hpp"

namespace percuss::model {

/// A warning that a model's frequencies depend on how its table of sections was read.
struct ProfileWarning {
  std::string code, message;  // the message ends with the remedy
  std::string remedy;
  std::vector<OptionId> options;
  double value = 0;  // largest relative difference of a frequency
};

/// The codes of profile warnings, all with the severity warn. docs/reference/warnings.md has a row for each.
inline constexpr std::string_view kProfileWarningCodes[] = {"long_slices"};

/// The warning long_slices. `freq_Hz` are the frequencies of the elastic modes with the table read as slices,
/// `other_Hz` with the table read as points. The first elastic mode has the number `first_mode`. Nothing for a table of
/// points.
std::optional<ProfileWarning> profile_warning(const SectionTable& table, const std::vector<double>& freq_Hz,
                                              const std::vector<double>& other_Hz, std::size_t first_mode);

}  // namespace percuss::model
