#include "model/section/profile_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace percuss::model {
namespace {

ProfileWarning profile_warning_of(warnings::Warning warning, const char* remedy, double value) {
  warning.severity = warnings::severity_of(warning.code, kProfileWarningCodes);
  return {.warning = with_remedy(std::move(warning), remedy), .value = value};
}

}  // namespace

std::optional<ProfileWarning> profile_warning(const SectionTable& table, const std::vector<double>& freq_Hz,
                                              const std::vector<double>& other_Hz, std::size_t first_mode) {
  if (freq_Hz.empty() || table.kind != ProfileKind::slices) return {};
  double largest = 0;
  std::size_t mode = 0;
  for (std::size_t i = 0; i < std::min(freq_Hz.size(), other_Hz.size()); ++i) {
    const double relative = other_Hz[i] / freq_Hz[i] - 1;
    if (std::abs(relative) <= std::abs(largest)) continue;
    largest = relative;
    mode = i;
  }
  const std::string message = fmt::format(
      "slices are up to {:.1f} % of the length long; with linear dimensions between the positions mode {} "
      "would be {:.1f} Hz, not {:.1f} Hz ({:+.1f} %)",
      100 * table.longest_fraction(), first_mode + mode, other_Hz[mode], freq_Hz[mode], 100 * largest);
  return profile_warning_of({.code = "long_slices", .message = message, .options = {"profile_kind"}},
                            "if the table holds measured points, say so", largest);
}

std::optional<ProfileWarning> shear_warning(const SectionTable& table, const Material& material) {
  // Wood has about 17 along the grain, metals 3, unidirectional composites up to 30.
  constexpr double kMaxRatio = 30;
  double largest = 0, shear_Pa = 0;
  for (const SectionStation& station : table.stations) {
    for (const SectionLayer& layer : station.layers) {
      const double shear = layer.shear_Pa.value_or(material.shear_Pa);
      const double ratio = layer.young_Pa.value_or(material.young_Pa) / shear;
      if (ratio > largest) shear_Pa = shear;
      largest = std::max(largest, ratio);
    }
  }
  if (!(largest > kMaxRatio)) return {};
  const std::string message = fmt::format(
      "the ratio of Young's modulus to the shear modulus times shape factor ({:.3g} Pa) is {:.3g}; wood has about 17, "
      "metals 3. If the shear modulus belongs to another material, higher modes come out too low",
      shear_Pa, largest);
  return profile_warning_of({.code = "low_shear", .message = message, .options = {"shear"}},
                            "give the shear modulus times shape factor of this material", largest);
}

}  // namespace percuss::model
