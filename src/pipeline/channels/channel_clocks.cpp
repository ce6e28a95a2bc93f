#include "pipeline/channels/channel_clocks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel/parallel.hpp"
#include "identify/identify.hpp"
#include "pipeline/channels/robust_slope.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxChannels = 8;         // a fit each; more channels usually share one recorder
constexpr double kNear = 2;                     // half-power bandwidths between the places of one mode in two channels
constexpr double kMinMisfit = 1e-9;             // of a frequency: two clocks differ by more; rounding leaves less
constexpr double kMinResidual = 1e-8;           // of the FRFs: clocks that differ by kMinMisfit leave more
constexpr std::size_t kFitFlops = 100'000'000;  // a lower limit

identify::FrfDataset only(const identify::FrfDataset& set, std::size_t channel) {
  identify::FrfDataset one{
      .lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz, .points = set.points, .channels = {}};
  std::copy_if(set.channels.begin(), set.channels.end(), std::back_inserter(one.channels),
               [&](const identify::FrfChannel& frf) { return frf.channel == channel; });
  return one;
}

const identify::Mode* nearest(const std::vector<identify::Mode>& modes, const identify::Mode& to) {
  const auto distance = [&](const identify::Mode& mode) { return std::abs(mode.pole.freq_Hz - to.pole.freq_Hz); };
  const auto at = std::min_element(modes.begin(), modes.end(),
                                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (at == modes.end() || distance(*at) > kNear * to.pole.half_power_Hz()) return nullptr;
  return &*at;
}

std::optional<ChannelClock> compare(const std::vector<identify::Mode>& first,
                                    const std::vector<identify::Mode>& other) {
  std::vector<double> excess, std;
  for (const identify::Mode& mode : first) {
    const identify::Mode* there = nearest(other, mode);
    if (there == nullptr || nearest(first, *there) != &mode) continue;
    excess.push_back(there->pole.freq_Hz / mode.pole.freq_Hz - 1);
    std.push_back(std::hypot(there->freq_std_Hz, mode.freq_std_Hz) / mode.pole.freq_Hz);
  }
  if (excess.size() < kMinClockModes) return std::nullopt;
  const RobustSlope slope = robust_slope(std::vector<double>(excess.size(), 1.0), excess, std);
  return ChannelClock{.excess = slope.slope, .std = slope.std, .modes = excess.size(), .log_chance = slope.log_chance};
}

// A mode whose frequency differs between the channels leaves a misfit, or is taken for two modes. One misfit suffices;
// a single close pair may be a true one.
bool may_differ(const std::vector<identify::Mode>& modes) {
  std::size_t pairs = 0;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const identify::Mode& mode = modes[m];
    if (mode.freq_std_parts_Hz.misfit > kMinMisfit * mode.pole.freq_Hz) return true;
    if (mode.joint_misfit > 0 && mode.joint_residual > kMinResidual) return true;
    if (m > 0 && mode.pole.freq_Hz - modes[m - 1].pole.freq_Hz < mode.pole.half_power_Hz()) ++pairs;
  }
  return pairs > 1;
}

}  // namespace

bool ChannelClock::established() const { return log_chance < kMaxLogChance && std::abs(excess) > kSureSlope * std; }

std::vector<ChannelClock> channel_clocks(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                         std::size_t channels) {
  std::vector<ChannelClock> out;
  if (channels < 2 || channels > kMaxChannels || modes.size() < kMinClockModes || !may_differ(modes)) return out;
  std::vector<std::vector<identify::Mode>> alone(channels);
  parallel_for_cost(channels, kFitFlops, [&](std::size_t c) {
    alone[c] = identify::identify_modes(only(set, c), {.effort = identify::Effort::quick});
  });
  for (std::size_t c = 1; c < channels; ++c) {
    if (auto clock = compare(alone.front(), alone[c])) {
      clock->channel = c;
      out.push_back(*clock);
    }
  }
  return out;
}

}  // namespace percuss::pipeline
