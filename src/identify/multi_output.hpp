#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/identify.hpp"

namespace percuss::identify {

inline constexpr std::size_t kMaxPrincipalFrfs = 16;

/// The modes of a survey with many FRFs: poles from a few principal-component FRFs, then the residues of all FRFs.
/// Nothing where no mode is found or this method does not apply: strongly truncated records, an exponential window, or
/// FRFs that common poles do not explain (frequency scatter between points).
std::optional<std::vector<Mode>> identify_multi_output(const FrfDataset& set, const IdentifyOptions& options);

}  // namespace percuss::identify
