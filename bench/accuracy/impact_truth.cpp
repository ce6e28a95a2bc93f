#include "impact_truth.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace percuss::accuracy {
namespace {

constexpr double kTolerance = 1e-14;
constexpr double kFirstStep_s = 1e-9;

// Unknowns: η and η̇ of each mode, then the position and the speed of the ball.
struct Motion {
  std::vector<double> omega2, weight;  // [modes] ωᵢ², yᵢ
  double hertz_Npm15, ball_mass_kg;

  double approach_m(const double* y) const {
    double m = y[2 * weight.size()];
    for (std::size_t i = 0; i < weight.size(); ++i) m -= weight[i] * y[i];
    return m;
  }
  double approach_rate_mps(const double* y) const {
    double mps = y[2 * weight.size() + 1];
    for (std::size_t i = 0; i < weight.size(); ++i) mps -= weight[i] * y[weight.size() + i];
    return mps;
  }
};

int derivatives(double /*t*/, const double* y, double* out, void* parameters) {
  const Motion& motion = *static_cast<const Motion*>(parameters);
  const std::size_t modes = motion.weight.size();
  const double approach_m = std::max(0.0, motion.approach_m(y));
  const double force_N = motion.hertz_Npm15 * approach_m * std::sqrt(approach_m);
  for (std::size_t i = 0; i < modes; ++i) {
    out[i] = y[modes + i];
    out[modes + i] = motion.weight[i] * force_N - motion.omega2[i] * y[i];
  }
  out[2 * modes] = y[2 * modes + 1];
  out[2 * modes + 1] = -force_N / motion.ball_mass_kg;
  return GSL_SUCCESS;
}

Motion motion_of(const model::Impact& impact) {
  Motion motion{.omega2 = {}, .weight = {}, .hertz_Npm15 = impact.hertz_Npm15, .ball_mass_kg = impact.ball_mass_kg};
  for (const model::BeamMode& mode : model::beam_modes(impact.beam, impact.modes)) {
    motion.omega2.push_back(mode.omega_radps * mode.omega_radps);
    motion.weight.push_back(mode.shape(impact.at_m) / std::sqrt(impact.beam.mass_per_length_kgpm * mode.norm_m));
  }
  return motion;
}

}  // namespace

double exact_cor(const model::Impact& impact) {
  Motion motion = motion_of(impact);
  const std::size_t size = 2 * impact.modes + 2;
  gsl_odeiv2_system system{derivatives, nullptr, size, &motion};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, kFirstStep_s, kTolerance, kTolerance),
      gsl_odeiv2_driver_free);
  std::vector<double> y(size);
  y.back() = impact.speed_mps;
  const auto go_to = [&](double& t_s, double to_s) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t_s, to_s, y.data()) != GSL_SUCCESS)
      throw std::runtime_error("GSL could not integrate the equations of motion of the impact");
  };
  double t_s = 0;
  const double hop_s = model::hertz_contact_s(impact) / 1000;
  std::vector<double> before = y;
  double before_s = 0;
  do {
    before = y;
    before_s = t_s;
    go_to(t_s, t_s + hop_s);
  } while (motion.approach_m(y.data()) > 0);
  // Near the end the approach falls linearly with time, so Newton's method converges in a few steps from the last point
  // with contact. The ball's remaining change of speed is proportional to the approach to the power of 5/2, so a small
  // error in the time of the end does not matter.
  y = before;
  t_s = before_s;
  gsl_odeiv2_driver_reset_hstart(driver.get(), kFirstStep_s);
  for (int i = 0; i < 20; ++i) {
    const double rest_s = -motion.approach_m(y.data()) / motion.approach_rate_mps(y.data());
    if (!(rest_s > 1e-15)) break;
    go_to(t_s, t_s + rest_s);
  }
  return -y.back() / impact.speed_mps;
}

}  // namespace percuss::accuracy
