#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/identify.hpp"

namespace percuss::identify {

inline constexpr std::size_t kMaxPrincipalFrfs = 16;

/// The modes of a survey with many channels: poles from few principal channels, then the residues of all. Nothing where
/// this would not do: records that end far too early, exponential windows, or lines that common poles do not explain (a
/// structure that moves from point to point).
std::optional<std::vector<Mode>> identify_multi_output(const FrfDataset& set, const IdentifyOptions& options);

}  // namespace percuss::identify
