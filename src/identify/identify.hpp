#pragma once
#include <optional>
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

struct IdentifyOptions {
  Effort effort = Effort::best;
  std::optional<std::size_t> modes;  // keep this many, the most significant ones
  std::vector<double> start_Hz;      // these and no others
};

/// The modes of a set of FRFs with one standard deviation on everything, in ascending frequency.
std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options = {});

}  // namespace percuss::identify
