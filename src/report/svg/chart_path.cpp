#include "report/svg/chart_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "report/svg/extreme_samples.hpp"

namespace percuss::report {
namespace {

bool is_drawn(const ChartPlane& plane, double x, double y) {
  return std::isfinite(plane.x.pixel(x)) && !std::isnan(plane.y.pixel(y));
}

// Pixels count downwards: the axis begins at the lower border.
std::string vertex(const ChartPlane& plane, bool pen, double x, double y) {
  return fmt::format("{}{:.1f} {:.1f}", pen ? "L" : "M", plane.x.pixel(x),
                     std::clamp(plane.y.pixel(y), plane.y.to, plane.y.from));
}

}  // namespace

std::string path_through(const ChartPlane& plane, const std::vector<double>& x, const std::vector<double>& y) {
  std::string path;
  bool pen = false;
  for (const std::size_t i : extreme_samples(y)) {
    const bool drawn = is_drawn(plane, x[i], y[i]);
    if (drawn) path += vertex(plane, pen, x[i], y[i]);
    pen = drawn;
  }
  return path;
}

std::string path_around(const ChartPlane& plane, const ChartBand& band) {
  std::vector<std::size_t> part(band.x.size());  // the number of gaps up to each sample
  for (std::size_t i = 0; i < part.size(); ++i) {
    const bool drawn = is_drawn(plane, band.x[i], band.low[i]) && is_drawn(plane, band.x[i], band.high[i]);
    part[i] = (i == 0 ? 0 : part[i - 1]) + (drawn ? 0 : 1);
  }
  const auto in_gap = [&](std::size_t i) { return part[i] > (i == 0 ? 0 : part[i - 1]); };
  std::vector<std::size_t> upper = extreme_samples(band.high), lower = extreme_samples(band.low);
  std::erase_if(upper, in_gap);
  std::erase_if(lower, in_gap);
  std::string path;
  for (auto high = upper.begin(), low = lower.begin(); high != upper.end();) {
    const std::size_t here = part[*high];
    bool pen = false;
    for (; high != upper.end() && part[*high] == here; pen = true, ++high)
      path += vertex(plane, pen, band.x[*high], band.high[*high]);
    low = std::find_if(low, lower.end(), [&](std::size_t i) { return part[i] >= here; });
    const auto end = std::find_if(low, lower.end(), [&](std::size_t i) { return part[i] > here; });
    for (auto back = end; back != low;) {
      --back;
      path += vertex(plane, true, band.x[*back], band.low[*back]);
    }
    path += 'Z';
    low = end;
  }
  return path;
}

}  // namespace percuss::report
