#include "identify/start/peaks.hpp"

#include <algorithm>
#include <limits>

namespace percuss::identify {
namespace {

// The lowest value between each maximum and the nearest higher maximum before it (or the beginning). dips[i] is the
// lowest value between top i − 1 and top i. One pass with a stack of descending tops. Each entry has the lowest value
// between its top and the top below it in the stack.
std::vector<double> saddles_before(std::span<const double> tops, std::span<const double> dips) {
  struct Entry {
    double value, lowest;
  };
  std::vector<Entry> stack;
  std::vector<double> saddle(tops.size());
  for (std::size_t i = 0; i < tops.size(); ++i) {
    double lowest = dips[i];
    while (!stack.empty() && stack.back().value <= tops[i]) {
      lowest = std::min(lowest, stack.back().lowest);
      stack.pop_back();
    }
    saddle[i] = lowest;
    stack.push_back({tops[i], lowest});
  }
  return saddle;
}

// A run of equal values.
struct Plateau {
  std::size_t begin, end;
  std::size_t middle() const { return (begin + end - 1) / 2; }
};

// The runs above `min_level` that are higher than both neighbours. A constant sequence has none.
std::vector<Plateau> plateaus_above(std::span<const double> x, double min_level) {
  std::vector<Plateau> found;
  for (std::size_t i = 0; i < x.size();) {
    std::size_t end = i + 1;
    if (x[i] > min_level) {
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
  const auto plateaus = plateaus_above(level, -std::numeric_limits<double>::infinity());
  // Only the lowest value between two maxima matters.
  std::vector<double> tops, dips;  // dips[i] before top i, one more after the last
  const auto at = [&](std::size_t line) { return level.begin() + static_cast<std::ptrdiff_t>(line); };
  std::size_t from = 0;
  for (const Plateau& p : plateaus) {
    tops.push_back(level[p.begin]);
    dips.push_back(*std::min_element(at(from), at(p.end)));
    from = p.end;
  }
  if (plateaus.empty()) return {};
  dips.push_back(*std::min_element(at(from - 1), level.end()));
  const auto before = saddles_before(tops, dips);
  std::reverse(tops.begin(), tops.end());
  std::reverse(dips.begin(), dips.end());
  const auto after = saddles_before(tops, dips);
  std::vector<Peak> peaks;
  for (std::size_t i = 0; i < plateaus.size(); ++i) {
    const double saddle = std::max(before[i], after[plateaus.size() - 1 - i]);
    peaks.push_back({.line = plateaus[i].middle(), .prominence = level[plateaus[i].begin] - saddle});
  }
  return peaks;
}

std::vector<std::size_t> maxima_above(std::span<const double> level, double min_level) {
  std::vector<std::size_t> lines;
  for (const Plateau& p : plateaus_above(level, min_level)) lines.push_back(p.middle());
  return lines;
}

}  // namespace percuss::identify
