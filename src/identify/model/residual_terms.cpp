#include "identify/model/residual_terms.hpp"

#include <algorithm>
#include <array>

namespace percuss::identify {
namespace {

// (Highest line over the frequency of a mode above the band)², for modes that stand for all modes there; 0: mass line.
constexpr std::array<double, 5> kModesAbove{0, 0.87, 0.6, 0.3, 0.1};

}  // namespace

Eigen::MatrixXd out_of_band_terms(const acquire::LineRange& lines) {
  const auto count = static_cast<Eigen::Index>(lines.count);
  const double low_Hz = lines.freq_Hz(0);
  const double high_Hz = lines.freq_Hz(lines.count - 1);
  const Eigen::ArrayXd x = (Eigen::ArrayXd::LinSpaced(count, low_Hz, high_Hz) / high_Hz).square();
  const double lowest = std::max(x(0), 0.25 * x(1));  // the lines may begin at 0 Hz
  Eigen::MatrixXd shapes(count, static_cast<Eigen::Index>(kModesAbove.size()) + 1);
  for (std::size_t term = 0; term < kModesAbove.size(); ++term)
    shapes.col(static_cast<Eigen::Index>(term)) = 1 / (1 - kModesAbove[term] * x);
  shapes.rightCols(1) = lowest / x.max(lowest);
  return shapes;
}

}  // namespace percuss::identify
