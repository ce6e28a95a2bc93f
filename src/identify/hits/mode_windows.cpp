#include "identify/hits/mode_windows.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

#include "core/math/tall_products.hpp"
#include "identify/fit/windowed_fit.hpp"
#include "identify/model/frf_lines.hpp"
#include "identify/model/point_columns.hpp"

namespace percuss::identify {
std::vector<Pole> ModeWindow::poles(const std::vector<Mode>& all) const {
  std::vector<Pole> of;
  of.reserve(modes.size());
  for (const std::size_t m : modes) of.push_back(all[m].pole);
  return of;
}

std::vector<ModeWindow> mode_windows(const FrfDataset& set, const std::vector<Mode>& modes) {
  std::vector<Pole> poles;
  poles.reserve(modes.size());
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  const FrfDataset lines{.lines = set.lines};  // the windows follow from the lines and the poles alone
  WindowedFit fit(lines);
  fit.replace(poles);
  std::vector<ModeWindow> windows;
  std::size_t next = 0;  // groups are ascending, like the modes
  for (const FitGroup& group : fit.groups()) {
    ModeWindow window{.modes = {}, .first = group.first, .count = group.count};
    for (std::size_t m = 0; m < group.fit.poles.size(); ++m) window.modes.push_back(next++);
    windows.push_back(std::move(window));
  }
  return windows;
}

ModeWindow window_around(const FrfDataset& set, const std::vector<Mode>& modes, double freq_Hz, double reach) {
  const double at = set.lines.position(freq_Hz);
  ModeWindow window{.first = set.lines.at(at - reach)};
  window.count = set.lines.at(at + reach) - window.first + 1;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const double line = set.lines.position(modes[m].pole.freq_Hz) - static_cast<double>(window.first);
    if (line >= 0 && line < static_cast<double>(window.count)) window.modes.push_back(m);
  }
  return window;
}

void subtract_other_modes(const FrfDataset& set, const std::vector<Mode>& modes, const ModeWindow& window,
                          const std::vector<std::size_t>& residue_of, std::vector<Eigen::VectorXcd>& data) {
  struct OtherMode {
    std::size_t mode;
    std::optional<PointValues> values;  // of the last pole
    std::size_t point = 0;              // of `column`
    std::vector<Complex> work;
    std::span<const Complex> column;
  };
  std::vector<OtherMode> others;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (std::find(window.modes.begin(), window.modes.end(), m) == window.modes.end())
      others.push_back({.mode = m, .values = {}, .work = {}, .column = {}});
  }
  for (std::size_t o = 0; o < data.size(); ++o) {
    const std::size_t point = set.channels[o].point;
    for (OtherMode& other : others) {
      const Residue& residue = modes[other.mode].residues[residue_of[o]];
      const Pole pole = residue.own_pole.value_or(modes[other.mode].pole);
      const bool same_pole = other.values && other.values->pole() == pole;
      if (!same_pole) other.values.emplace(pole, set, window.first, window.count);
      if (!same_pole || other.point != point) {
        other.column = other.values->at(set.points[point], other.work);
        other.point = point;
      }
      add_scaled(data[o].data(), -residue.value, other.column.data(), window.count);
    }
  }
}

std::vector<Eigen::VectorXcd> window_data(const FrfDataset& set, const std::vector<Mode>& modes,
                                          const ModeWindow& window) {
  std::vector<Eigen::VectorXcd> data;
  for (const FrfChannel& channel : set.channels) {
    data.emplace_back(
        Eigen::Map<const Eigen::VectorXcd>(channel.frf.data() + window.first, static_cast<Eigen::Index>(window.count)));
  }
  std::vector<std::size_t> same(data.size());
  std::iota(same.begin(), same.end(), std::size_t{0});
  subtract_other_modes(set, modes, window, same, data);
  return data;
}

FrfDataset frfs_within(const FrfDataset& set, const std::vector<Mode>& modes, const ModeWindow& window) {
  FrfDataset part = lines_of(set, window.first, window.count);
  const std::vector<Eigen::VectorXcd> data = window_data(set, modes, window);
  for (std::size_t o = 0; o < data.size(); ++o) part.channels[o].frf.assign(data[o].begin(), data[o].end());
  return part;
}

}  // namespace percuss::identify
