#include "model/bat/bat_collision.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "model/bat/bat_impact.hpp"

namespace percuss::model {

double LossyBall::force_N(double u_m, double largest_m) const {
  if (!(u_m > 0)) return 0;
  if (u_m >= largest_m) return stiffness * std::pow(u_m, exponent);
  const double unloading = (1 + exponent) / (restitution * restitution) - 1;  // (2)
  return stiffness * std::pow(largest_m, exponent) * std::pow(u_m / largest_m, unloading);
}

double struck_speed_mps(const BatModes& bat, const BatCollision& collision, double z_m) {
  switch (bat.support.kind) {
    case BeamSupport::free:
      return swing_speed_mps(rigid_collision(bat.inertia, collision), z_m - bat.inertia.cm_m);
    case BeamSupport::pinned:
      return collision.swing_rate_radps * (z_m - bat.support.at_m);
    default:
      return 0;
  }
}

double rigid_exit_speed_mps(const BatModes& bat, const BatCollision& collision, double z_m) {
  const double v = collision.ball_speed_mps, u = struck_speed_mps(bat, collision, z_m);
  if (!(v + u > 0)) return -v;
  const double ratio = collision.ball.mass_kg * bat.rigid_accelerance_per_kg(z_m), e = collision.ball.restitution;
  return (v * (e - ratio) + u * (1 + e)) / (1 + ratio);  // (3)
}

BatRebound bat_rebound(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                       const BatCollisionOptions& options) {
  if (!(collision.ball_speed_mps + struck_speed_mps(bat, collision, z_m) > 0)) {  // the bat moves away from the ball
    return {.exit_speed_mps = -collision.ball_speed_mps,
            .contacts = 0,
            .mode_share = Eigen::VectorXd::Zero(std::min(static_cast<Eigen::Index>(modes), bat.freq_Hz.size()))};
  }
  BatCollisionOptions halved = options;
  halved.steps = std::max<std::size_t>(1, options.steps / 2);
  const double ratio = static_cast<double>(options.steps) / static_cast<double>(halved.steps);
  const BatRebound coarse = BatImpact(bat, modes, collision, z_m, halved).run();
  BatRebound fine = BatImpact(bat, modes, collision, z_m, options).run();
  if (!std::isfinite(fine.exit_speed_mps))
    throw InputError("the collision has no finite solution", "bat model", "check the values of ball and bat");
  if (fine.contacts != coarse.contacts) return fine;
  // The error falls with the square of the step: Richardson extrapolation from two steps removes most of it.
  const auto extrapolate = [&](auto& value, const auto& coarse_value) {
    value += (value - coarse_value) / (ratio * ratio - 1);
  };
  extrapolate(fine.exit_speed_mps, coarse.exit_speed_mps);
  extrapolate(fine.ball_share, coarse.ball_share);
  extrapolate(fine.mode_share, coarse.mode_share);
  return fine;
}

std::vector<BatRebound> bat_sweep(const BatModes& bat, std::size_t modes, const BatCollision& collision,
                                  const std::vector<double>& z_m, std::size_t threads) {
  std::vector<BatRebound> sweep(z_m.size());
  parallel_for(z_m.size(), threads, [&](std::size_t i) { sweep[i] = bat_rebound(bat, modes, collision, z_m[i]); });
  return sweep;
}

Eigen::MatrixXd bat_wave(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                         const std::vector<double>& time_s, const BatCollisionOptions& options) {
  BatImpact impact(bat, modes, collision, z_m, options);
  const std::vector<double> at_m = positions_of(bat.beam);
  Eigen::MatrixXd amplitudes(impact.bat().q.size(), std::ssize(time_s));
  for (Eigen::Index i = 0; i < amplitudes.cols(); ++i)
    amplitudes.col(i) = impact.amplitudes_at(time_s[static_cast<std::size_t>(i)]);
  Eigen::MatrixXd shapes(std::ssize(at_m), amplitudes.rows());
  for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
    const double at = at_m[static_cast<std::size_t>(i)];
    shapes.row(i) = rigid_and_elastic(bat.rigid_deflection(at), bat.deflection(at), shapes.cols() - 2).transpose();
  }
  return shapes * amplitudes;
}

RigidCollision rigid_collision(const BatInertia& bat, const BatCollision& collision) {
  return {.ball_mass_kg = collision.ball.mass_kg,
          .bat_mass_kg = bat.mass_kg,
          .inertia_kgm2 = bat.inertia_kgm2,
          .ball_speed_mps = collision.ball_speed_mps,
          .swing_rate_radps = collision.swing_rate_radps,
          .bat_speed_mps = collision.bat_speed_mps,
          .restitution = collision.ball.restitution};
}

}  // namespace percuss::model
