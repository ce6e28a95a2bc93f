#pragma once
#include <optional>
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "identify/select/fitted_starts.hpp"

namespace percuss::identify {

struct IdentifyOptions {
  Effort effort = Effort::best;
  std::optional<std::size_t> modes;  // largest number of modes, see keep_clearest()
  std::vector<double> start_Hz;      // return at most one mode near each of these frequencies, and no others
};

/// The modes of a set of FRFs in ascending frequency, with one standard deviation of each value. With options.start_Hz:
/// the modes of the search that these frequencies name, and modes fitted from the frequencies that name none
/// (with_started_modes).
std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options = {});

/// Fits at most one mode from each of these frequencies, without a search.
std::vector<Mode> modes_from_frequencies(const FrfDataset& set, const std::vector<double>& freq_Hz, Effort effort);

/// The modes that a fit finds from the poles of another test. Poles that are no modes of `set` are left out.
std::vector<Mode> modes_from_poles(const FrfDataset& set, const std::vector<Pole>& poles, Effort effort);

/// The frequencies of options.start_Hz at which identify_modes() found no mode, and why. Repeats the search.
std::vector<RefusedStart> refused_starts(const FrfDataset& set, const IdentifyOptions& options);

/// Keeps the `count` modes whose damping ratios have the smallest relative standard deviations, in ascending frequency.
void keep_clearest(std::vector<Mode>& modes, std::size_t count);

}  // namespace percuss::identify
