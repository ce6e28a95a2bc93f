#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "identify/select/fitted_starts.hpp"

namespace percuss::identify {

/// A start for which one mode was fitted in the place of two close modes of the search.
struct JoinedModes {
  double asked_Hz = 0;
  std::pair<double, double> found_Hz;  // of the two modes, ascending
};

/// The modes of a search and of stated frequencies.
struct StartedModes {
  std::vector<Mode> modes;            // ascending; also the modes of the search that no start names
  std::vector<RefusedStart> refused;  // starts without a mode
  std::vector<JoinedModes> joined;    // starts whose mode stands for two
};

/// Adds the modes of the starts that name no mode of `found`, the modes of a search. A start names the nearest mode
/// within a bandwidth (match_starts_to_poles). Only the other starts are fitted, to the FRFs without the modes found;
/// then all modes are fitted together. A mode found near such a start may be two modes fitted as one: it is fitted
/// again with the start. A start well between two modes found stands for one mode in their place. If every start names
/// a mode, `found` does not change.
StartedModes with_started_modes(const FrfDataset& set, std::vector<Mode> found, std::vector<double> start_Hz,
                                Effort effort);

/// [start_Hz] the index of the mode that each start names; nothing for a start without one.
std::vector<std::optional<std::size_t>> modes_of_starts(const acquire::LineRange& lines, const std::vector<Mode>& modes,
                                                        const std::vector<double>& start_Hz);

/// The modes that the starts name, ascending.
std::vector<Mode> modes_at_starts(const acquire::LineRange& lines, const std::vector<Mode>& modes,
                                  const std::vector<double>& start_Hz);

}  // namespace percuss::identify
