#include "acquire/formats/mat/mat_frf_layout.hpp"

#include <algorithm>
#include <utility>

namespace percuss::acquire {

MatFrfLayout frf_layout(const MatVariable& variable, std::size_t frequencies) {
  std::vector<std::pair<std::size_t, std::size_t>> axes;  // size, stride
  std::size_t stride = 1;
  for (const std::size_t size : variable.shape) {
    axes.emplace_back(size, stride);
    stride *= size;
  }
  auto lines = std::find_if(axes.begin(), axes.end(), [&](const auto& axis) { return axis.first == frequencies; });
  if (axes.size() == 3 && axes.back().first == frequencies) lines = axes.end() - 1;
  if (lines == axes.end()) lines = std::max_element(axes.begin(), axes.end());
  MatFrfLayout out{.lines = lines->first, .line_stride = lines->second};
  axes.erase(lines);
  if (!axes.empty()) {
    out.points = axes[0].first;
    out.point_stride = axes[0].second;
  }
  if (axes.size() > 1) {
    out.channels = axes[1].first;
    out.channel_stride = axes[1].second;
  }
  return out;
}

}  // namespace percuss::acquire
