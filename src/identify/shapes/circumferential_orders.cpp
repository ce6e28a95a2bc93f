#include "identify/shapes/circumferential_orders.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identify/model/mode.hpp"
#include "identify/shapes/circumferential_fit.hpp"

namespace percuss::identify {
namespace {

constexpr double kMixing = 0.1;  // standard deviation of an order's energy, over the total: real shapes mix orders
constexpr double kMinAxialValue = 0.05;  // of the largest: smaller axial values have no significant sign
constexpr double kAliasFour = 0.99;      // probability that a pattern is not its alias, for an alias of n ≥ 4 …
constexpr double kAliasThree = 0.95;     // … and of n = 3

struct Energy {
  double value = 0, variance = 0;
};

bool has_less_energy(const Energy& a, const Energy& b) { return a.value < b.value; }

// The energy of order n, summed over the points, without the noise's energy.
Energy energy_of(const std::vector<CircumferentialFit>& fits, int n) {
  Energy energy;
  const Eigen::Index first = n == 0 ? 0 : 2 * n - 1, count = n == 0 ? 1 : 2;
  for (const CircumferentialFit& fit : fits) {
    const Eigen::MatrixXd projection = fit.pattern.middleCols(first, count) * fit.inverse.middleRows(first, count);
    const Eigen::VectorXd part = projection * fit.value;
    const Eigen::VectorXd back = projection.transpose() * part;
    const double noise = (projection.cwiseAbs2() * fit.variance).sum();
    energy.value += part.squaredNorm() - noise;
    energy.variance += 4 * back.cwiseAbs2().dot(fit.variance) + 2 * noise * noise;
  }
  return energy;
}

double unexplained(const std::vector<CircumferentialFit>& fits) {
  double sum = 0;
  for (const CircumferentialFit& fit : fits) sum += (fit.value - fit.pattern * (fit.inverse * fit.value)).squaredNorm();
  return sum;
}

double total_of(const std::vector<CircumferentialFit>& fits) {
  double sum = 0;
  for (const CircumferentialFit& fit : fits) sum += fit.value.squaredNorm();
  return sum;
}

// The order with the largest energy, and its probability.
void choose_order(TubeShape& shape, const std::vector<Energy>& energies, double rest, double total,
                  std::size_t angles) {
  const auto best = std::max_element(energies.begin(), energies.end(), has_less_energy);
  shape.order = static_cast<int>(best - energies.begin());
  double rival = rest, rival_variance = 0;
  for (auto it = energies.begin(); it != energies.end(); ++it) {
    shape.energy.push_back(std::max(0.0, it->value / total));
    if (it == best || it->value <= rival) continue;
    rival = it->value;
    rival_variance = it->variance;
  }
  const double spread = std::sqrt(best->variance + rival_variance + std::pow(kMixing * total, 2));
  shape.confidence = 0.5 * std::erfc(-(best->value - rival) / spread / std::numbers::sqrt2);
  shape.alias = static_cast<int>(angles) - shape.order;
  if (shape.alias <= shape.order) shape.alias = static_cast<int>(angles) + shape.order;
  shape.confidence *= shape.alias >= 4 ? kAliasFour : kAliasThree;
}

// The axial function of the chosen order and its plane, the principal axis of the cosine and sine amplitudes.
void find_axial(TubeShape& shape, const std::vector<CircumferentialFit>& fits) {
  const Eigen::Index first = shape.order == 0 ? 0 : 2 * shape.order - 1;
  Eigen::Vector2d along(1, 0);
  if (shape.order > 0) {
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const CircumferentialFit& fit : fits) {
      const Eigen::Vector2d pair = fit.inverse.middleRows(first, 2) * fit.value;
      squares += pair * pair.transpose();
    }
    const double angle = 0.5 * std::atan2(2 * squares(0, 1), squares(0, 0) - squares(1, 1));
    along = {std::cos(angle), std::sin(angle)};
  }
  const Eigen::Vector2d across(-along(1), along(0));
  double power = 0, across_variance = 0;
  bool plane_known = shape.order > 0;
  for (const CircumferentialFit& fit : fits) {
    const Eigen::Index rows = shape.order == 0 ? 1 : 2;
    const Eigen::RowVectorXd to_value = along.head(rows).transpose() * fit.inverse.middleRows(first, rows);
    const double value = to_value * fit.value;
    shape.axial.push_back(
        {.position_m = fit.position_m, .value = value, .std = std::sqrt(to_value.cwiseAbs2() * fit.variance)});
    if (shape.order == 0) continue;
    const Eigen::RowVectorXd to_across = across.transpose() * fit.inverse.middleRows(first, 2);
    power += value * value;
    across_variance += value * value * (to_across.cwiseAbs2() * fit.variance).value();
    plane_known = plane_known && !(fit.half && 2 * shape.order + 1 == fit.pattern.cols());
  }
  if (!plane_known || !(power > 0)) return;
  const double turn = std::numbers::pi / shape.order;
  const double plane = std::atan2(along(1), along(0)) / shape.order;
  shape.plane_rad = plane - turn * std::floor(plane / turn);
  shape.plane_std_rad = std::sqrt(across_variance) / power / shape.order;
}

void count_sign_changes(TubeShape& shape) {
  if (shape.axial.size() < 2) return;
  double largest = 0, before = 0;
  for (const AxialValue& v : shape.axial) largest = std::max(largest, std::abs(v.value));
  int changes = 0;
  for (const AxialValue& v : shape.axial) {
    if (std::abs(v.value) <= std::max(kSignificant * v.std, kMinAxialValue * largest)) continue;
    if (before * v.value < 0) ++changes;
    before = v.value;
  }
  if (before != 0) shape.sign_changes = changes;
}

}  // namespace

std::optional<TubeShape> tube_shape(const ModeShape& shape, const TubeGeometry& geometry) {
  const CircumferentialFits fits = fit_circumferential(shape, geometry);
  const double total = total_of(fits.rings);
  if (fits.rings.empty() || !(total > 0)) return std::nullopt;
  std::vector<Energy> energies;
  for (int n = 0; n <= fits.highest; ++n) energies.push_back(energy_of(fits.rings, n));
  TubeShape out;
  const double alone = total - std::max_element(energies.begin(), energies.end(), has_less_energy)->value;
  choose_order(out, energies, fits.arc ? alone : unexplained(fits.rings), total, fits.angles);
  find_axial(out, fits.rings);
  count_sign_changes(out);
  return out;
}

ModeType mode_type_of(const TubeShape& shape) {
  if (shape.confidence < kMinTypeProbability) return ModeType::unknown;
  return shape.order == 1 ? ModeType::bending : shape.order == 2 ? ModeType::hoop : ModeType::unknown;
}

}  // namespace percuss::identify
