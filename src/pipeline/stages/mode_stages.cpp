#include "pipeline/stages/mode_stages.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace percuss::pipeline {
namespace {

// Magnitude of the second sensor's FRFs over the first sensor's at one line; nothing where either is zero.
std::optional<double> overlay_dB(const identify::FrfDataset& set, const identify::SensorPair& sensors,
                                 std::size_t line) {
  double first = 0, second = 0;
  for (const identify::FrfChannel& one : set.channels) {
    const double power = std::norm(one.frf[line]);
    if (one.channel == sensors.first) first += power;
    if (one.channel == sensors.second) second += power;
  }
  if (!(first > 0 && second > 0)) return std::nullopt;
  return 10 * std::log10(second / first);
}

}  // namespace

BandModes modes_in_band(std::vector<identify::Mode> modes, const std::vector<int>& points,
                        std::pair<double, double> band_Hz) {
  BandModes out;
  for (identify::Mode& mode : modes) {
    for (identify::Residue& residue : mode.residues) residue.point = static_cast<std::size_t>(points[residue.point]);
    auto& part = mode.pole.freq_Hz < band_Hz.first    ? out.below
                 : mode.pole.freq_Hz > band_Hz.second ? out.above
                                                      : out.within;
    part.push_back(std::move(mode));
  }
  return out;
}

std::vector<identify::Mode> with_point_indices(std::vector<identify::Mode> modes, const std::vector<int>& points) {
  for (identify::Mode& mode : modes) {
    for (identify::Residue& residue : mode.residues) {
      const auto at = std::lower_bound(points.begin(), points.end(), static_cast<int>(residue.point));
      residue.point = static_cast<std::size_t>(at - points.begin());
    }
  }
  return modes;
}

std::optional<identify::SensorPair> sensor_pair(const std::vector<acquire::SignalInfo>& accel) {
  std::vector<std::optional<double>> angles_rad;
  angles_rad.reserve(accel.size());
  for (const acquire::SignalInfo& signal : accel) angles_rad.push_back(signal.angle_rad);
  return identify::pair_of_sensors(angles_rad);
}

std::vector<identify::ModeClassification> classify_modes(const std::vector<identify::Mode>& modes,
                                                         const identify::FrfDataset& set,
                                                         const std::vector<acquire::SignalInfo>& accel,
                                                         const identify::ClassifyOptions& options) {
  const auto sensors = sensor_pair(accel);
  std::vector<std::optional<double>> overlays_dB(modes.size());
  for (std::size_t m = 0; sensors && m < modes.size(); ++m)
    overlays_dB[m] = overlay_dB(set, *sensors, set.lines.nearest(modes[m].pole.freq_Hz));
  return identify::classify(modes, sensors, overlays_dB, options);
}

std::vector<identify::ModeClassification> classifications_of_part(
    const std::vector<identify::ModeClassification>& classifications, const std::vector<identify::Mode>& all,
    const std::vector<identify::Mode>& part) {
  const auto place_in = [](const std::vector<identify::Mode>& modes, const identify::Mode& mode) {
    return static_cast<std::size_t>(
        std::find_if(modes.begin(), modes.end(), [&](const auto& one) { return one.pole == mode.pole; }) -
        modes.begin());
  };
  std::vector<identify::ModeClassification> out;
  out.reserve(part.size());
  for (const identify::Mode& mode : part) {
    out.push_back(classifications[place_in(all, mode)]);
    auto& split = out.back().split_mode;
    if (!split) continue;
    split->partner = place_in(part, all[split->partner]);
    if (split->partner == part.size()) split.reset();
  }
  return out;
}

identify::Stabilisation stabilisation_in_band(const identify::FrfDataset& set, std::pair<double, double> band_Hz) {
  identify::Stabilisation diagram = identify::stabilise(set);
  std::tie(diagram.low_Hz, diagram.high_Hz) = band_Hz;
  std::erase_if(diagram.poles, [&](const auto& pole) {
    return pole.pole.freq_Hz < band_Hz.first || pole.pole.freq_Hz > band_Hz.second;
  });
  return diagram;
}

}  // namespace percuss::pipeline
