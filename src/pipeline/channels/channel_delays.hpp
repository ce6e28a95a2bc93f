#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// The time by which a channel's responses come after the force; negative: before it.
struct ChannelDelay {
  std::size_t channel = 0;
  double delay_s = 0, std_s = 0;
  std::size_t modes = 0;     // whose phases show it
  double highest_Hz = 0;     // highest frequency of these modes
  double phase_rms = 0;      // rad, of these phases about the line of the delay
  double undelayed_rms = 0;  // rad, about zero
  double log_chance = 0;     // ln of the probability that phases without a delay fit a line as well
  /// The phase that the delay causes at highest_Hz, rad.
  double largest_phase() const;
  /// Whether the phases clearly follow a delay.
  bool established() const;
};

/// The phase of a mode's residues in one channel, up to a half turn.
struct ModePhase {
  double freq_Hz = 0;
  double phase_rad = 0, std_rad = 0;
  // Errors by the noise of the force, which std_rad does not include: the phase for each of independent standard normal
  // variables, which are common to all modes. Empty: none.
  std::vector<double> force_rad{};
};

/// The delay τ for which the phases follow −2πfτ best, |τ| ≤ 20 ms. A half turn more or less is the same phase, so
/// several delays fit the phases of a few modes. Of these, the result is the delay whose fit is least probable by
/// chance (log_chance). Nothing for fewer than three modes.
std::optional<ChannelDelay> delay_of_phases(std::span<const ModePhase> phases);

/// The delay of each channel from the residues of the modes, at all points together; a channel with too few clear modes
/// has none. Modes with complex shapes scatter about the line and enter the standard deviation. The noise of the force
/// shifts its pulse in time, and with it the delays of all channels: it enters the standard deviation as well.
/// set    the FRFs of these modes
/// modes  with the indices of the points in `set` in their residues, not with the points' numbers
std::vector<ChannelDelay> delays_of_residues(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                             std::size_t channels);

/// As delays_of_residues, also for delays of several periods, which falsify the modes themselves. The first motion of
/// the structure then shows the delay. It is used for a channel if the channel's phases establish no delay and are in
/// disorder (0.3 rad rms or more about zero, or too few), and if the first motion comes more than one period of the
/// highest mode after the onset of the force. The channel's FRFs are then corrected by the time of the first motion,
/// and the modes are identified again.
std::vector<ChannelDelay> channel_delays(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                         const std::vector<AnalysedHit>& hits, std::size_t channels);

}  // namespace percuss::pipeline
