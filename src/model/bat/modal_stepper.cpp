#include "model/bat/modal_stepper.hpp"

#include <cmath>

namespace percuss::model {
namespace {

constexpr double kSmallAngle = 0.1;  // below it 1 − sin(x)/x cancels, and four terms of its series are exact to 2e-15

}  // namespace

ModalStepper::ModalStepper(const Eigen::ArrayXd& omega_radps, const Eigen::ArrayXd& shape, double h)
    : phi(shape),
      step_s(h),
      cosine(shape.size()),
      sine_over(shape.size()),
      sine_times(shape.size()),
      q_from(shape.size()),
      q_to(shape.size()),
      rate_from(shape.size()),
      rate_to(shape.size()) {
  for (Eigen::Index i = 0; i < phi.size(); ++i) {
    const double omega = omega_radps[i], x = omega * h, x2 = x * x;
    // With x = ωh: sinc = sin(x)/x, versine = (1 − cos x)/x² and lag = (1 − sin(x)/x)/x², without cancellation.
    const double sinc = x == 0 ? 1 : std::sin(x) / x, half = x == 0 ? 1 : std::sin(x / 2) / (x / 2);
    const double versine = half * half / 2;
    const double lag = std::abs(x) < kSmallAngle ? (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72))) / 6 : (1 - sinc) / x2;
    cosine[i] = std::cos(x);
    sine_over[i] = h * sinc;
    sine_times[i] = omega * std::sin(x);
    q_to[i] = phi[i] * h * h * lag;
    q_from[i] = phi[i] * h * h * (versine - lag);
    rate_to[i] = phi[i] * h * versine;
    rate_from[i] = phi[i] * h * (sinc - versine);
  }
}

void ModalState::advance(const ModalStepper& s, double force_N) {
  const Eigen::ArrayXd next = s.cosine * q + s.sine_over * rate + s.q_from * force_N;
  rate = s.cosine * rate - s.sine_times * q + s.rate_from * force_N;
  q = next;
}

void ModalState::add_end(const ModalStepper& s, double force_N) {
  q += s.q_to * force_N;
  rate += s.rate_to * force_N;
}

}  // namespace percuss::model
