#include "identify/fit/line_groups.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::identify {
namespace {

constexpr double kCore = 2;      // half-power bandwidths on either side of a pole; groups there are narrow
constexpr double kGrowth = 0.1;  // lines of a group per line of distance from the narrow groups
constexpr double kMaxLinesPerGroup = 64;
constexpr double kMinCore = 4;  // lines

}  // namespace

LineGroups::LineGroups(const acquire::LineRange& lines, const std::vector<Pole>& poles, double core_share) {
  std::vector<double> widest(lines.count, kMaxLinesPerGroup);
  for (const Pole& pole : poles) {
    const double at = lines.position(pole.freq_Hz);
    const double core = std::max(kCore * pole.half_power_Hz() / lines.df_Hz(), kMinCore);
    const double least = core_share * pole.half_power_Hz() / lines.df_Hz();
    for (std::size_t k = 0; k < lines.count; ++k)
      widest[k] = std::min(widest[k], std::max(least, kGrowth * (std::abs(static_cast<double>(k) - at) - core)));
  }
  begin_.push_back(0);
  while (begin_.back() < lines.count) {
    const std::size_t from = begin_.back();
    std::size_t to = from + 1;
    // The narrowest width that a line of the group demands.
    double allowed = widest[from];
    while (to < lines.count && static_cast<double>(to + 1 - from) <= std::min(allowed, widest[to])) {
      allowed = std::min(allowed, widest[to]);
      ++to;
    }
    begin_.push_back(to);
    scale_.push_back(1 / std::sqrt(static_cast<double>(to - from)));
  }
}

std::vector<std::size_t> LineGroups::middles() const {
  std::vector<std::size_t> lines;
  for (std::size_t b = 0; b + 1 < begin_.size(); ++b) lines.push_back((begin_[b] + begin_[b + 1] - 1) / 2);
  return lines;
}

void LineGroups::sum(const Eigen::VectorXcd& z, const Eigen::VectorXd& w, Eigen::Ref<Eigen::VectorXd> column) const {
  const Eigen::Index groups = count();
  for (Eigen::Index b = 0; b < groups; ++b) {
    const auto at = static_cast<std::size_t>(b);
    double re = 0;
    double im = 0;
    for (auto k = static_cast<Eigen::Index>(begin_[at]); k < static_cast<Eigen::Index>(begin_[at + 1]); ++k) {
      re += w(k) * z(k).real();
      im += w(k) * z(k).imag();
    }
    column(b) = re * scale_[at];
    column(groups + b) = im * scale_[at];
  }
}

}  // namespace percuss::identify
