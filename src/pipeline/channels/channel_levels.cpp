#include "pipeline/channels/channel_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinCompared = 4;
constexpr double kClearResidue = 5;  // standard deviations of a residue

bool clear(const identify::Residue& residue) { return std::abs(residue.value) > kClearResidue * residue.std; }

struct Residues {
  std::vector<double> ratio;
  double cross = 0, first = 0, second = 0;
  void add(Complex a, Complex b) {
    ratio.push_back(std::abs(b) / std::abs(a));
    // Normalised by the pair, so that every mode counts alike.
    const double both = std::abs(a) * std::abs(b);
    cross += (a * std::conj(b)).real() / both;
    first += std::abs(a) / std::abs(b);
    second += std::abs(b) / std::abs(a);
  }
};

}  // namespace

std::vector<ChannelPair> compare_channels(const std::vector<identify::Mode>& modes, std::size_t channels) {
  std::vector<ChannelPair> out;
  for (std::size_t c = 1; c < channels; ++c) {
    Residues all;
    std::vector<std::size_t> shown;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const identify::Mode& mode = modes[m];
      const std::size_t before = all.ratio.size();
      for (const identify::Residue& a : mode.residues) {
        if (a.channel != 0 || !clear(a)) continue;
        for (const identify::Residue& b : mode.residues) {
          if (b.channel == c && b.point == a.point && clear(b)) all.add(a.value, b.value);
        }
      }
      if (all.ratio.size() > before) shown.push_back(m);
    }
    if (shown.size() < kMinCompared) continue;
    // Equal ratios in all modes give ±1; ratios that differ in size give less.
    const double alike = all.cross / std::sqrt(all.first * all.second);
    const auto [least, most] = std::minmax_element(all.ratio.begin(), all.ratio.end());
    out.push_back({.first = 0,
                   .second = c,
                   .modes = std::move(shown),
                   .ratio = median(all.ratio),
                   .spread = *most / *least,
                   .correlation = alike});
  }
  return out;
}

double largest_velocity_mps(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes) {
  double largest = 0;
  for (const identify::Mode& mode : modes) {
    const std::size_t line = set.lines.nearest(mode.pole.freq_Hz);
    for (std::size_t o = 0; o < mode.residues.size() && o < set.channels.size(); ++o) {
      const identify::PointForce& force = set.points[set.channels[o].point];
      if (force.ff.size() <= line || force.blocks.empty() || !clear(mode.residues[o])) continue;
      const double impulse_Ns = std::sqrt(force.ff[line] / static_cast<double>(force.blocks.size())) / set.lines.fs_Hz;
      largest = std::max(largest, std::abs(mode.residues[o].value) * impulse_Ns);
    }
  }
  return largest;
}

}  // namespace percuss::pipeline
