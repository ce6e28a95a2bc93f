#include "identify/peaks.hpp"

#include <algorithm>
#include <limits>

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

// Equal samples of which none beside them is as high; the whole sequence is none.
struct Plateau {
  std::size_t begin, end;
  std::size_t middle() const { return (begin + end - 1) / 2; }
};

std::vector<Plateau> plateaus_above(std::span<const double> x, double least) {
  std::vector<Plateau> found;
  for (std::size_t i = 0; i < x.size();) {
    std::size_t end = i + 1;
    if (x[i] > least) {
      while (end < x.size() && x[end] == x[i]) ++end;
      const bool above_left = i == 0 || x[i - 1] < x[i];
      const bool above_right = end == x.size() || x[end] < x[i];
      if (above_left && above_right && end - i < x.size()) found.push_back({i, end});
    }
    i = end;
  }
  return found;
}

}  // namespace

std::vector<Peak> find_peaks(std::span<const double> level) {
  const auto before = saddles_before(level);
  const std::vector<double> reversed(level.rbegin(), level.rend());
  auto after = saddles_before(reversed);
  std::reverse(after.begin(), after.end());
  std::vector<Peak> peaks;
  for (const Plateau& p : plateaus_above(level, -std::numeric_limits<double>::infinity()))
    peaks.push_back({.line = p.middle(), .prominence = level[p.begin] - std::max(before[p.begin], after[p.end - 1])});
  return peaks;
}

std::vector<std::size_t> maxima_above(std::span<const double> level, double least) {
  std::vector<std::size_t> lines;
  for (const Plateau& p : plateaus_above(level, least)) lines.push_back(p.middle());
  return lines;
}

}  // namespace percuss
