#pragma once
#include <optional>
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

struct IdentifyOptions {
  Effort effort = Effort::best;
  std::optional<std::size_t> modes;  // largest number of modes; the most significant ones are kept
  std::vector<double> start_Hz;      // fit exactly one mode from each of these frequencies
};

/// The modes of a set of FRFs in ascending frequency, with one standard deviation of each value.
std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options = {});

}  // namespace percuss::identify
