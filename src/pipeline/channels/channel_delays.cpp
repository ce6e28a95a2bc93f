#include "pipeline/channels/channel_delays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "identify/identify.hpp"
#include "identify/noise/force_noise.hpp"
#include "pipeline/channels/robust_slope.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kSearched_s = 0.02;  // on either side of zero
constexpr double kSteps = 16;         // per period of the highest mode
constexpr std::size_t kStarts = 30;   // the best of the steps, from which the delay is refined
constexpr std::size_t kMinPhases = 3;
constexpr double kClearPhase = 5;     // standard deviations of a residue whose phase is used
constexpr double kPhaseFloor = 0.05;  // rad, added to the standard deviations in the search
constexpr double kDisorder = 0.907;   // rms of phases without any order, π/√12
constexpr double kSpoilt = 0.3;       // rms phase in rad that complex shapes rarely reach

double to_half_turn(double phase_rad) { return std::remainder(phase_rad, std::numbers::pi); }

std::vector<double> phases_after(std::span<const ModePhase> phases, double delay_s) {
  std::vector<double> left;
  left.reserve(phases.size());
  for (const ModePhase& p : phases) left.push_back(to_half_turn(p.phase_rad + kTwoPi * p.freq_Hz * delay_s));
  return left;
}

// The standard deviation of a delay from the noise of the force alone. This noise moves the phases of all modes nearly
// like one shift in time, so that more modes hardly reduce it.
double force_std_s(std::span<const ModePhase> phases) {
  std::vector<double> shift_s(phases.front().force_rad.size());
  double weights = 0;
  for (const ModePhase& p : phases) {
    const double omega = kTwoPi * p.freq_Hz, weight = omega / (p.std_rad * p.std_rad);
    for (std::size_t v = 0; v < shift_s.size(); ++v) shift_s[v] += weight * p.force_rad[v];
    weights += weight * omega;
  }
  double squares = 0;
  for (const double shift : shift_s) squares += shift * shift;
  return std::sqrt(squares) / weights;
}

// The delay near a start. log_chance counts the delays between zero and this one: each is another trial in which the
// phases could agree as well by chance.
ChannelDelay refined(std::span<const ModePhase> phases, double start_s) {
  std::vector<double> omega, std;
  double highest_Hz = 0;
  for (const ModePhase& p : phases) {
    omega.push_back(kTwoPi * p.freq_Hz);
    std.push_back(p.std_rad);
    highest_Hz = std::max(highest_Hz, p.freq_Hz);
  }
  ChannelDelay out{.delay_s = start_s, .modes = phases.size(), .highest_Hz = highest_Hz};
  for (int pass = 0; pass < 3; ++pass) {  // the half turns may change with the delay
    const RobustSlope slope = robust_slope(omega, phases_after(phases, out.delay_s), std);
    out.delay_s -= slope.slope;
    out.std_s = slope.std;
    out.phase_rms = slope.rms;
  }
  double without = 0;
  for (const double phase : phases_after(phases, 0)) without += phase * phase / static_cast<double>(phases.size());
  without = std::min(std::sqrt(without), kDisorder);
  out.undelayed_rms = without;
  const double trials = std::max(1.0, 4 * std::abs(out.delay_s) * highest_Hz);
  const double better = without > 0 ? std::clamp(out.phase_rms / without, 1e-12, 1.0) : 1;
  out.log_chance = std::log(trials) + static_cast<double>(phases.size() - 1) * std::log(better);
  return out;
}

// Delays at which the phases agree best, and zero. Phases that are all small need no other start.
std::vector<double> starts_s(std::span<const ModePhase> phases) {
  const std::vector<double> undelayed = phases_after(phases, 0);
  if (std::all_of(undelayed.begin(), undelayed.end(), [](double phase) { return std::abs(phase) < kPhaseFloor; }))
    return {0};
  double highest_Hz = 0;
  for (const ModePhase& p : phases) highest_Hz = std::max(highest_Hz, p.freq_Hz);
  const double step_s = 1 / (kSteps * highest_Hz);
  std::vector<std::pair<double, double>> by_misfit;
  for (double delay_s = -kSearched_s; delay_s <= kSearched_s; delay_s += step_s) {
    const std::vector<double> left = phases_after(phases, delay_s);
    double misfit = 0;
    for (std::size_t i = 0; i < left.size(); ++i) misfit += std::abs(left[i]) / (phases[i].std_rad + kPhaseFloor);
    by_misfit.emplace_back(misfit, delay_s);
  }
  const std::size_t count = std::min(kStarts, by_misfit.size());
  std::partial_sort(by_misfit.begin(), by_misfit.begin() + static_cast<std::ptrdiff_t>(count), by_misfit.end());
  std::vector<double> starts{0};
  for (std::size_t i = 0; i < count; ++i) starts.push_back(by_misfit[i].second);
  return starts;
}

// The phases of the gain of each point's FRFs at the modes, from the noise of the force: [points], each [modes,
// variables]. A point has no variables where this noise is unknown.
std::vector<Eigen::MatrixXd> force_phases(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes) {
  std::vector<std::size_t> lines;
  for (const identify::Mode& mode : modes) lines.push_back(set.lines.nearest(mode.pole.freq_Hz));
  std::vector<Eigen::MatrixXd> out(set.points.size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = identify::gain_errors(set, p, lines).imag();
  return out;
}

// The direction of a mode's residues in a channel: the phase that most of their energy lies along, over all points.
// The mode has the row `row` of the matrices `of_force` of force_phases(), [points].
std::optional<ModePhase> phase_of(const identify::Mode& mode, std::size_t channel,
                                  const std::vector<Eigen::MatrixXd>& of_force, std::size_t row) {
  Complex doubled;
  double energy = 0, noise = 0;
  std::vector<double> energy_at(of_force.size());  // [points]
  for (const identify::Residue& residue : mode.residues) {
    if (residue.channel != channel || !(residue.std > 0)) continue;
    const Complex scaled = residue.value / residue.std;
    doubled += scaled * scaled;
    energy += std::norm(scaled);
    energy_at[residue.point] += std::norm(scaled);
    noise += 1;
  }
  if (!(energy > kClearPhase * kClearPhase * noise) || !(std::abs(doubled) > 0)) return std::nullopt;
  ModePhase out{.freq_Hz = mode.pole.freq_Hz, .phase_rad = 0.5 * std::arg(doubled), .std_rad = 1 / std::sqrt(energy)};
  for (std::size_t p = 0; p < of_force.size(); ++p) {
    for (Eigen::Index v = 0; v < of_force[p].cols(); ++v)
      out.force_rad.push_back(energy_at[p] / energy * of_force[p](static_cast<Eigen::Index>(row), v));
  }
  return out;
}

// The smallest time from the force to the first motion over the accepted hits.
double first_motion_s(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  std::optional<double> least;
  for (const std::size_t h : accepted_hits(hits)) {
    if (hits[h].responses.size() <= channel || !hits[h].responses[channel].delay_s) continue;
    const double delay_s = *hits[h].responses[channel].delay_s;
    least = least ? std::min(*least, delay_s) : delay_s;
  }
  return least.value_or(0);
}

bool disordered(const std::vector<ChannelDelay>& delays, std::size_t channel) {
  return std::none_of(delays.begin(), delays.end(), [&](const ChannelDelay& delay) {
    return delay.channel == channel && (delay.established() || delay.undelayed_rms < kSpoilt);
  });
}

// Removes each channel's delay from its FRFs.
identify::FrfDataset turned_back(identify::FrfDataset set, const std::vector<double>& delay_s) {
  for (identify::FrfChannel& channel : set.channels) {
    for (std::size_t k = 0; k < channel.frf.size(); ++k)
      channel.frf[k] *= std::polar(1.0, kTwoPi * set.lines.freq_Hz(k) * delay_s[channel.channel]);
  }
  return set;
}

}  // namespace

double ChannelDelay::largest_phase() const { return kTwoPi * highest_Hz * std::abs(delay_s); }

bool ChannelDelay::established() const {
  return log_chance < kMaxLogChance && std::abs(delay_s) > kSureSlope * std_s && phase_rms < kDisorder / 2;
}

std::optional<ChannelDelay> delay_of_phases(std::span<const ModePhase> phases) {
  if (phases.size() < kMinPhases) return std::nullopt;
  const std::vector<double> starts = starts_s(phases);
  ChannelDelay best = refined(phases, starts.front());
  for (std::size_t i = 1; i < starts.size(); ++i) {
    const ChannelDelay one = refined(phases, starts[i]);
    if (one.log_chance < best.log_chance) best = one;
  }
  best.std_s = std::hypot(best.std_s, force_std_s(phases));
  return best;
}

std::vector<ChannelDelay> delays_of_residues(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                             std::size_t channels) {
  std::vector<ChannelDelay> out;
  const std::vector<Eigen::MatrixXd> of_points = force_phases(set, modes);
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<ModePhase> phases;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (auto phase = phase_of(modes[m], c, of_points, m)) phases.push_back(*std::move(phase));
    }
    if (auto delay = delay_of_phases(phases)) {
      delay->channel = c;
      out.push_back(*delay);
    }
  }
  return out;
}

std::vector<ChannelDelay> channel_delays(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                         const std::vector<AnalysedHit>& hits, std::size_t channels) {
  std::vector<ChannelDelay> delays = delays_of_residues(set, modes, channels);
  if (modes.size() < kMinPhases) return delays;
  const double period_s = 1 / modes.back().pole.freq_Hz;
  std::vector<double> late_s(channels);
  bool any = false;
  for (std::size_t c = 0; c < channels; ++c) {
    if (const double first_s = first_motion_s(hits, c); first_s > period_s && disordered(delays, c))
      late_s[c] = first_s;
    any = any || late_s[c] > 0;
  }
  if (!any) return delays;
  const auto again = identify::identify_modes(turned_back(set, late_s), {.effort = identify::Effort::standard});
  for (ChannelDelay delay : delays_of_residues(set, again, channels)) {
    if (!(late_s[delay.channel] > 0)) continue;
    delay.delay_s += late_s[delay.channel];
    // The chance that phases without any order lie so close to a line.
    delay.log_chance = static_cast<double>(delay.modes - 1) * std::log(std::max(delay.phase_rms / kDisorder, 1e-12));
    if (!delay.established()) continue;
    std::erase_if(delays, [&](const ChannelDelay& old) { return old.channel == delay.channel; });
    delays.push_back(delay);
  }
  std::stable_sort(delays.begin(), delays.end(), [](const auto& a, const auto& b) { return a.channel < b.channel; });
  return delays;
}

}  // namespace percuss::pipeline
