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

/// The distance of a pole from a stated frequency, beyond the range that the frequency stands for, in bandwidths.
double bandwidths_from_start(const acquire::LineRange& lines, double asked_Hz, const Pole& pole);

/// The largest distance at which a start names a pole, and a limit that excludes no pole.
inline constexpr double kMaxBandwidthsFromStart = 1, kAnyDistance = 1e9;

/// [start_Hz] the index of each start's pole, by one assignment of least total distance; each pole belongs to one start
/// at most. Nothing for a start without a free pole within `max_bandwidths`.
std::vector<std::optional<std::size_t>> match_starts_to_poles(const acquire::LineRange& lines,
                                                              const std::vector<double>& start_Hz,
                                                              const std::vector<Pole>& poles, double max_bandwidths);

/// The reason to refuse the mode that was fitted from a stated frequency; nothing if it is accepted.
std::optional<RefusedStart> refusal_of(const acquire::LineRange& lines, double asked_Hz, const FittedMode& found);

}  // namespace percuss::identify
