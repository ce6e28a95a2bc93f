#include "identify/start/residual_smoothness.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

constexpr Eigen::Index kSmoothBlock = 64;  // lines
constexpr double kSmoothDeviations = 5;    // standard deviations of the roughness of a block of noise

}  // namespace

bool smooth_somewhere(const std::vector<Eigen::VectorXcd>& residual) {
  const Eigen::MatrixXd straight = orthonormal_polynomials(kSmoothBlock, 2);
  const double least = 1 - kSmoothDeviations / std::sqrt(static_cast<double>(kSmoothBlock));
  return std::any_of(residual.begin(), residual.end(), [&](const Eigen::VectorXcd& channel) {
    for (Eigen::Index first = 0; first + kSmoothBlock <= channel.size(); first += kSmoothBlock / 2) {
      Eigen::VectorXcd block = channel.segment(first, kSmoothBlock);
      block -= straight * (straight.transpose() * block);
      const Eigen::Index inner = kSmoothBlock - 2;
      const double rough = (block.segment(1, inner) - 0.5 * (block.head(inner) + block.tail(inner))).squaredNorm();
      if (rough < least * kWhiteRoughness * block.squaredNorm()) return true;
    }
    return false;
  });
}

}  // namespace percuss::identify
