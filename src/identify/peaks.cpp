#include "identify/peaks.hpp"

#include <algorithm>

namespace percuss {
namespace {

// For each sample: the lowest value between it and the nearest higher sample before it (or the beginning). A stack of
// falling maxima, each with the lowest value met since it was put there, gives all of them in one pass.
std::vector<double> saddles_before(std::span<const double> x) {
  struct Entry {
    double value, lowest;
  };
  std::vector<Entry> stack;
  std::vector<double> saddle(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double lowest = x[i];
    while (!stack.empty() && stack.back().value <= x[i]) {
      lowest = std::min(lowest, stack.back().lowest);
      stack.pop_back();
    }
    saddle[i] = lowest;
    stack.push_back({x[i], lowest});
  }
  return saddle;
}

}  // namespace

std::vector<Peak> find_peaks(std::span<const double> level) {
  const auto before = saddles_before(level);
  const std::vector<double> reversed(level.rbegin(), level.rend());
  auto after = saddles_before(reversed);
  std::reverse(after.begin(), after.end());
  std::vector<Peak> peaks;
  for (std::size_t i = 0; i < level.size();) {
    std::size_t end = i + 1;
    while (end < level.size() && level[end] == level[i]) ++end;
    const bool above_left = i == 0 || level[i - 1] < level[i];
    const bool above_right = end == level.size() || level[end] < level[i];
    if (above_left && above_right && end - i < level.size()) {
      peaks.push_back({.line = (i + end - 1) / 2, .prominence = level[i] - std::max(before[i], after[end - 1])});
    }
    i = end;
  }
  return peaks;
}

}  // namespace percuss
