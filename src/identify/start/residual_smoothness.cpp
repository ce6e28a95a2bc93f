#include "identify/start/residual_smoothness.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

constexpr int kSmoothBlock = 64;         // lines
constexpr double kSmoothDeviations = 5;  // standard deviations of the roughness of a block of noise
constexpr std::size_t kFlopsPerLine = 50;

}  // namespace

bool smooth_somewhere(const std::vector<Eigen::VectorXcd>& residual) {
  // Real and imaginary parts are the two rows of a block, so that all products are real.
  using Block = Eigen::Matrix<double, 2, kSmoothBlock>;
  const Eigen::Matrix<double, kSmoothBlock, 2> straight = orthonormal_polynomials(kSmoothBlock, 2);
  const double least = 1 - kSmoothDeviations / std::sqrt(static_cast<double>(kSmoothBlock));
  const auto is_smooth = [&](const Eigen::VectorXcd& channel) {
    for (Eigen::Index first = 0; first + kSmoothBlock <= channel.size(); first += kSmoothBlock / 2) {
      Block block = Eigen::Map<const Block>(reinterpret_cast<const double*>(channel.data() + first));
      const Eigen::Matrix2d shares = block * straight;
      block -= shares * straight.transpose();
      constexpr int kInner = kSmoothBlock - 2;
      const double rough =
          (block.middleCols<kInner>(1) - 0.5 * (block.leftCols<kInner>() + block.rightCols<kInner>())).squaredNorm();
      if (rough < least * kWhiteRoughness * block.squaredNorm()) return true;
    }
    return false;
  };
  std::vector<char> smooth(residual.size(), 0);
  const auto lines = residual.empty() ? std::size_t{0} : static_cast<std::size_t>(residual.front().size());
  parallel_for_cost(residual.size(), kFlopsPerLine * lines,
                    [&](std::size_t o) { smooth[o] = is_smooth(residual[o]) ? 1 : 0; });
  return std::any_of(smooth.begin(), smooth.end(), [](char one) { return one != 0; });
}

}  // namespace percuss::identify
