#include "pipeline/warnings/channel_mode_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/io/significant_digits.hpp"
#include "core/units.hpp"
#include "pipeline/channels/mass_loading.hpp"
#include "pipeline/warnings/sensor_name.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kManyModes = 3;      // too many to have a node at one place
constexpr double kNoResidue = 4;           // standard deviations of the clearest residue of a silent channel …
constexpr double kStillResidue = 10;       // the same of a channel that stays in its noise …
constexpr double kClearResidue = 20;       // … and of another channel
constexpr double kVisiblePhase = 0.05;     // rad at the highest mode
constexpr double kUnitFactor = 1000;       // between m/s² and mm/s², V and mV
constexpr double kUnitSpread = 5;          // largest factor between residues at two places of a structure
constexpr double kMaxSpeed_mps = 50;       // ten times the speed of a hammer swung by hand
constexpr double kSameMotion = 0.98;       // of ChannelPair::correlation
constexpr double kSameRatio = 1.1;         // of ChannelPair::spread: sensors at one place; bending and hoop differ more
constexpr double kSameSize = 3;            // of ChannelPair::ratio: signals of one motion differ by gains alone
constexpr double kOppositeMotion = -0.95;  // of ChannelPair::correlation
constexpr double kOwnPlace_rad = std::numbers::pi / 6;  // sensors with a larger angle between them move differently
constexpr double kOneAngle_rad = kDegree_rad;           // sensors at one angle around a tube

std::string delay_text(double s, double std_s) {
  const double magnitude = std::abs(s);
  const char* unit = magnitude < 1e-3 ? "µs" : "ms";
  const double scale = magnitude < 1e-3 ? 1e6 : 1e3;
  return fmt::format("{} {}", value_with_std(magnitude * scale, std_s * scale), unit);
}

// "accel 1 20 ± 0.1 µs after the force, …", and the delay that turns a phase most.
struct DelayList {
  std::string text;
  const ChannelDelay* most = nullptr;
};

// Whether the delay turns residues visibly, or turns a residue that was fitted as real by more than its standard
// deviation. Such a fit biases the mode and its close neighbour.
bool matters(const ChannelDelay& delay, const std::vector<identify::Mode>& modes) {
  if (!delay.established()) return false;
  if (delay.largest_phase() > kVisiblePhase) return true;
  return std::any_of(modes.begin(), modes.end(), [&](const identify::Mode& mode) {
    return std::any_of(mode.residues.begin(), mode.residues.end(), [&](const identify::Residue& residue) {
      const double turned = std::abs(kTwoPi * mode.pole.freq_Hz * delay.delay_s * residue.value);
      return residue.channel == delay.channel && residue.value.imag() == 0 && turned > residue.std;
    });
  });
}

DelayList list_of(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                  const std::vector<ChannelDelay>& delays) {
  DelayList list;
  for (const ChannelDelay& delay : delays) {
    if (!matters(delay, modes)) continue;
    list.text +=
        fmt::format("{}{} {} {} the force", list.text.empty() ? "" : ", ", sensor_name(record.accel, delay.channel),
                    delay_text(delay.delay_s, delay.std_s), delay.delay_s > 0 ? "after" : "before");
    if (list.most == nullptr || delay.largest_phase() > list.most->largest_phase()) list.most = &delay;
  }
  return list;
}

std::vector<Warning> skew(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                          const std::vector<ChannelDelay>& delays, bool correctable) {
  const auto& [list, most] = list_of(record, modes, delays);
  if (most == nullptr) return {};
  Warning warning{"skew",
                  fmt::format("channels were not sampled together: {}. The residues' phase grows evenly with frequency "
                              "over {} modes, to {:.0f}° at {:.6g} Hz. Residues and shapes are turned by it, and "
                              "frequencies and damping ratios are off once it exceeds a turn or so. Possible causes: "
                              "the recorder, unequal filters, the mounting of one sensor",
                              list, most->modes, most->largest_phase() * kRadian_deg, most->highest_Hz)};
  if (!correctable)
    return {with_remedy(std::move(warning), "measure again with equal filters and one clock, or shift the FRFs")};
  warning.options = {"delay"};
  return {with_remedy(std::move(warning), "take the delays out")};
}

std::vector<Warning> corrected_skew(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                    const std::vector<ChannelDelay>& delays) {
  const auto& [list, most] = list_of(record, modes, delays);
  if (most == nullptr) return {};
  return {{.code = "skew",
           .message = fmt::format("delays were taken out of the channels: {}, from the phases of {} modes. All results "
                                  "hold for channels that are sampled together",
                                  list, most->modes),
           .severity = acquire::Severity::info}};
}

bool is_pair(const ChannelPair& pair, const std::optional<identify::SensorPair>& sensors) {
  return sensors && std::minmax(pair.first, pair.second) == std::minmax(sensors->first, sensors->second);
}

// Two sensors of a tube may show its two planes, which bend at different frequencies where the wall or the grain
// differs.
std::vector<Warning> clocks(const acquire::Record& record, const std::vector<ChannelClock>& clocks,
                            const std::optional<identify::SensorPair>& tube) {
  std::vector<Warning> out;
  for (const ChannelClock& clock : clocks) {
    if (!clock.established()) continue;
    const std::string difference =
        fmt::format("{} shows the {} modes that it shares with {} at frequencies {} ± {} ppm {}: ",
                    sensor_name(record.accel, clock.channel), clock.modes, sensor_name(record.accel, 0),
                    significant(std::abs(clock.excess) * 1e6, 4), significant(clock.std * 1e6, 2),
                    clock.excess > 0 ? "higher" : "lower");
    const std::string of_clocks =
        "frequencies are uncertain by as much, damping ratios are off, and one mode may appear as two";
    if (is_pair({.first = 0, .second = clock.channel}, tube)) {
      out.push_back(with_remedy(
          {"clock_mismatch",
           fmt::format("{}their recorders have clocks that differ by this factor, or the sensors face two planes in "
                       "which the tube bends at different frequencies, as across and along the grain of wood. With "
                       "two clocks, {}; with two planes, nothing is wrong",
                       difference, of_clocks),
           {"accel_channel"},
           {},
           acquire::Severity::warn},
          "check that one clock drives all channels, or analyse each channel alone"));
      continue;
    }
    out.push_back(
        with_remedy({"clock_mismatch",
                     difference + "the clocks of their recorders differ by this factor. F" + of_clocks.substr(1),
                     {"accel_channel"}},
                    "record all channels with one clock, or analyse each recorder's channels alone"));
  }
  return out;
}

std::vector<Warning> units(const acquire::Record& record, const ChannelFindings& findings,
                           const SensorDirections& sensors) {
  std::vector<Warning> out;
  for (const ChannelPair& pair : findings.pairs) {
    if (is_pair(pair, sensors.tube)) continue;
    const double factor = std::max(pair.ratio, 1 / pair.ratio);
    if (factor < kUnitFactor / kUnitSpread || factor > kUnitFactor * kUnitSpread) continue;
    const bool second = pair.ratio > 1;
    out.push_back(
        with_remedy({"units_differ",
                     fmt::format("{} is {:.3g} times {} in the median of {} modes: is one of them in mm/s² or mV, or a "
                                 "sensitivity wrong by 1000? Residues, shapes and mode types are wrong then",
                                 sensor_name(record.accel, second ? pair.second : pair.first), factor,
                                 sensor_name(record.accel, second ? pair.first : pair.second), pair.modes.size()),
                     {"unit", "accel_scale"}},
                    "state the unit or the scale of each channel"));
  }
  if (out.empty() && findings.largest_velocity_mps > kMaxSpeed_mps) {
    out.push_back(
        with_remedy({"implausible_motion",
                     fmt::format("a mode moves at {:.3g} m/s after the hits, faster than any hammer: a unit or a "
                                 "sensitivity is wrong (mm/s² for m/s², mV for V, kN for N). Frequencies and damping "
                                 "ratios hold, residues do not",
                                 findings.largest_velocity_mps),
                     {"unit", "force_unit", "accel_scale", "force_scale"}},
                    "state the units or the scales"));
  }
  return out;
}

std::optional<double> angle_between(const acquire::Record& record, const ChannelPair& pair) {
  const auto& first = record.accel[pair.first].angle_rad;
  const auto& second = record.accel[pair.second].angle_rad;
  if (!first || !second) return std::nullopt;
  return std::abs(std::remainder(*first - *second, kTwoPi));
}

// Whether all modes that the sensors share are hoop modes, and the sensors are not at one angle. A hoop mode moves two
// places around a tube alike or against each other. Its direction is not known, so its signs tell nothing of a sensor.
bool share_hoop_modes_alone(const ChannelPair& pair, const std::optional<double>& angle_rad,
                            const SensorDirections& sensors) {
  const bool one_angle = !sensors.angles_assumed && angle_rad && *angle_rad < kOneAngle_rad;
  return !one_angle && std::all_of(pair.modes.begin(), pair.modes.end(),
                                   [&](std::size_t m) { return m < sensors.hoop.size() && sensors.hoop[m]; });
}

// Whether one motion explains both signals. Bending modes alone have one ratio, too: the tangent of the angle between
// the blow and the first sensor. A sensor nearly across the blow is much weaker than the other.
bool shows_same_motion(const ChannelPair& pair) {
  return pair.correlation > kSameMotion && pair.spread < kSameRatio && std::max(pair.ratio, 1 / pair.ratio) < kSameSize;
}

std::vector<Warning> directions(const acquire::Record& record, const std::vector<ChannelPair>& pairs,
                                const SensorDirections& sensors) {
  std::vector<Warning> out;
  for (const ChannelPair& pair : pairs) {
    if (pair.second >= record.accel.size()) continue;
    const auto angle_rad = angle_between(record, pair);
    // Opposite motion is no fault of sensors that point in different directions.
    const bool one_direction = sensors.angles_assumed || angle_rad.value_or(0) < kOwnPlace_rad;
    if (pair.correlation < kOppositeMotion && one_direction && !is_pair(pair, sensors.tube) &&
        !share_hoop_modes_alone(pair, angle_rad, sensors)) {
      out.push_back(with_remedy(
          {"reversed",
           fmt::format("{} moves against {} in each of {} modes: reversing one of them would make all "
                       "modes agree. Shapes have the wrong sign there",
                       sensor_name(record.accel, pair.second), sensor_name(record.accel, pair.first),
                       pair.modes.size()),
           {"setup", "accel_scale"}},
          R"(check which way the sensors point, and state "sign": -1 for the reversed one in the set-up, or a )"
          "negative scale"));
    } else if (shows_same_motion(pair) && angle_rad && *angle_rad > kOwnPlace_rad) {
      out.push_back(with_remedy(
          {"same_motion",
           fmt::format(
               "{} and {} show the same motion in all {} modes, but their stated angles are {:.0f}° apart. So do "
               "bending modes alone, struck between the sensors. Otherwise an angle is wrong, or one signal "
               "was recorded twice, and bending and hoop are not distinguished",
               sensor_name(record.accel, pair.first), sensor_name(record.accel, pair.second), pair.modes.size(),
               *angle_rad * kRadian_deg),
           {"angle"}},
          "if the band holds hoop modes, too, state the angle of each sensor"));
    }
  }
  return out;
}

std::vector<Warning> silent_channels(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                     const std::vector<Silence>& silent, const std::vector<bool>& types_need) {
  std::vector<Warning> out;
  for (std::size_t c = 0; c < silent.size(); ++c) {
    const std::string finding = fmt::format("{} shows none of the {} mode{}", sensor_name(record.accel, c),
                                            modes.size(), modes.size() == 1 ? "" : "s");
    if (silent[c] == Silence::unexcited) {
      out.push_back(with_remedy(
          {"unexcited_channel", finding +
                                    ", although it responds to the hits: a sensor across the blow sees no bending "
                                    "mode, only modes outside the band"},
          "if it does not lie across the blow, check its mounting and its cable"));
    }
    if (silent[c] != Silence::dead && silent[c] != Silence::still) continue;
    const std::string reason =
        silent[c] == Silence::still
            ? std::string("it does not rise above its noise before the hits")
            : fmt::format("its residues are within {:.0f} standard deviations of zero", kNoResidue);
    out.push_back(with_remedy(
        {"dead_channel",
         fmt::format("{}: {}. If it is dead, results that compare it with other channels are wrong: directions, "
                     "shapes{}",
                     finding, reason, c < types_need.size() && types_need[c] ? kNoTypesWithoutIt : ""),
         {"accel_channel"},
         "",
         acquire::Severity::warn},
        "check its cable and its mounting, or choose the other channels"));
  }
  return out;
}

}  // namespace

std::vector<Warning> mass_loading_warnings(const std::vector<identify::Mode>& modes) {
  std::string list;
  for (const MassLoading& one : mass_loading(modes)) {
    list += fmt::format("{}{:.1f} Hz (by {} %, {} points)", list.empty() ? "" : ", ", modes[one.mode].pole.freq_Hz,
                        significant(100 * one.largest_fall, 2), one.points);
  }
  if (list.empty()) return {};
  return {with_remedy({"mass_loading", "frequencies fall with the square of the mode's motion at each point: " + list +
                                           ". The mass of a roving sensor does this: frequencies are too low and "
                                           "shapes flattened"},
                      "use a lighter sensor, rove the hammer, or put the same mass at every point")};
}

std::vector<Silence> silences(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                              const std::vector<ChannelMotion>& motions) {
  std::vector<double> clearest(record.accel.size());
  for (const identify::Mode& mode : modes) {
    for (const identify::Residue& residue : mode.residues) {
      if (residue.channel < clearest.size() && residue.std > 0)
        clearest[residue.channel] = std::max(clearest[residue.channel], std::abs(residue.value) / residue.std);
    }
  }
  const bool any = std::any_of(clearest.begin(), clearest.end(), [](double ratio) { return ratio > kClearResidue; });
  std::vector<Silence> out(record.accel.size(), Silence::none);
  for (std::size_t c = 0; c < out.size(); ++c) {
    const ChannelMotion motion = c < motions.size() ? motions[c] : ChannelMotion{};
    if (motion.constant) {
      out[c] = Silence::constant;
    } else if (any && motion.still && clearest[c] < kStillResidue) {
      out[c] = Silence::still;
    } else if (any && modes.size() >= kManyModes && clearest[c] > 0 && clearest[c] < kNoResidue) {
      out[c] = motion.responds ? Silence::unexcited : Silence::dead;
    }
  }
  return out;
}

std::vector<Warning> channel_mode_warnings(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                           const ChannelFindings& findings, bool correctable,
                                           const SensorDirections& sensors, const std::vector<Silence>& silent,
                                           const std::vector<bool>& types_need) {
  // A different clock also causes delays. Only the clock is then reported.
  const bool own_clock = std::any_of(findings.clocks.begin(), findings.clocks.end(),
                                     [](const ChannelClock& clock) { return clock.established(); });
  std::vector<Warning> out;
  if (!own_clock) out = skew(record, modes, findings.delays, correctable);
  for (const auto& more :
       {corrected_skew(record, modes, findings.corrected_delays), clocks(record, findings.clocks, sensors.tube),
        units(record, findings, sensors), directions(record, findings.pairs, sensors),
        silent_channels(record, modes, silent, types_need)})
    out.insert(out.end(), more.begin(), more.end());
  return out;
}

}  // namespace percuss::pipeline
