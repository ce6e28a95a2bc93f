#include "report/svg/extreme_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percuss::report {
namespace {

constexpr std::size_t kMaxDrawn = 1000;

}  // namespace

std::vector<std::size_t> extreme_samples(const std::vector<double>& y) {
  std::vector<std::size_t> kept;
  const std::size_t run = std::max<std::size_t>(1, 2 * y.size() / kMaxDrawn);
  for (std::size_t begin = 0; begin < y.size(); begin += run) {
    const std::size_t end = std::min(begin + run, y.size());
    std::array<std::size_t, 3> chosen{end, end, end};  // lowest, highest, a gap
    for (std::size_t i = begin; i < end; ++i) {
      if (std::isnan(y[i])) {
        chosen[2] = i;
        continue;
      }
      if (chosen[0] == end || y[i] < y[chosen[0]]) chosen[0] = i;
      if (chosen[1] == end || y[i] > y[chosen[1]]) chosen[1] = i;
    }
    std::sort(chosen.begin(), chosen.end());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen.at(i) < end && (i == 0 || chosen.at(i) != chosen.at(i - 1))) kept.push_back(chosen.at(i));
    }
  }
  return kept;
}

}  // namespace percuss::report
