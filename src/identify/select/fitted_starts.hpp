#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/model/modal_model.hpp"
#include "identify/select/fitted_mode.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// A start whose fit is no mode, with the values of this fit.
struct RefusedStart {
  enum class Reason {
    moved,         // by more than its bandwidth
    undamped,      // the damping ratio is consistent with zero
    no_resonance,  // no peak above the residual around it
  };
  double asked_Hz = 0;
  Pole pole;
  double damping_std = 0;
  double peak_to_residual = 0;
  Reason reason = Reason::moved;
};

/// The modes fitted from the accepted starts, and the refused starts.
struct FittedStarts {
  std::vector<FittedMode> modes;
  std::vector<RefusedStart> refused;
};

/// At most one mode from each start. A start is refused where its fit moves away, does not decay or shows no resonance.
/// The other modes are then fitted without it.
FittedStarts fit_starts(const FrfDataset& set, std::vector<double> start_Hz, Effort effort);

/// How far a pole is from a stated frequency, beyond the range that the frequency stands for, in bandwidths.
double bandwidths_from_start(const acquire::LineRange& lines, double asked_Hz, const Pole& pole);

/// The greatest such distance of a start's mode, and a distance beyond every other.
inline constexpr double kMaxBandwidthsFromStart = 1, kAnyDistance = 1e9;

/// The pole of each start, by one assignment of least total distance; each pole belongs to one start at most. Nothing
/// for a start with no free pole within `max_bandwidths`.
std::vector<std::optional<std::size_t>> poles_of_starts(const acquire::LineRange& lines,
                                                        const std::vector<double>& start_Hz,
                                                        const std::vector<Pole>& poles, double max_bandwidths);

/// Why the mode fitted from a stated frequency is none; nothing for a mode.
std::optional<RefusedStart> refusal_of(const acquire::LineRange& lines, double asked_Hz, const FittedMode& found);

}  // namespace percuss::identify
