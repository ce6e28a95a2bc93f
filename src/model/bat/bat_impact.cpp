#include "model/bat/bat_impact.hpp"

#include <algorithm>
#include <cmath>

#include "core/budget.hpp"
#include "core/units.hpp"

namespace percuss::model {
namespace {

constexpr Eigen::Index kRigidMotions = 2;
constexpr double kFreeSteps = 4;  // length of a step between contacts, in steps of the contact
constexpr int kMaxTries = 100;
constexpr double kCompressionAccuracy = 1e-14;  // of the ball's deepest compression on a wall
constexpr std::size_t kMaxTouches = 1000;

}  // namespace

Eigen::ArrayXd rigid_and_elastic(const Eigen::Vector2d& rigid, const Eigen::VectorXd& elastic, Eigen::Index modes) {
  Eigen::ArrayXd all(kRigidMotions + modes);
  all << rigid.array(), elastic.head(modes).array();
  return all;
}

BatImpact::BatImpact(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                     const BatCollisionOptions& options)
    : ball_(collision.ball),
      swing_mps_(struck_speed_mps(bat, collision, z_m)),
      closing_mps_(collision.ball_speed_mps + swing_mps_),
      wall_m_(std::pow((ball_.exponent + 1) * ball_.mass_kg * closing_mps_ * closing_mps_ / (2 * ball_.stiffness),
                       1 / (ball_.exponent + 1))),
      count_(std::min(static_cast<Eigen::Index>(modes), bat.freq_Hz.size())),
      omega_(rigid_and_elastic(Eigen::Vector2d::Zero(), kTwoPi * bat.freq_Hz, count_)),
      contact_(omega_, rigid_and_elastic(bat.rigid_deflection(z_m), bat.deflection(z_m), count_),
               wall_m_ / closing_mps_ / static_cast<double>(options.steps)),
      free_(omega_, contact_.phi, kFreeSteps * contact_.step_s),
      compliance_(contact_.step_s * contact_.step_s / (6 * ball_.mass_kg) + (contact_.phi * contact_.q_to).sum()),
      compliance_rate_(contact_.step_s / (2 * ball_.mass_kg) + (contact_.phi * contact_.rate_to).sum()),
      recontact_window_s_(options.recontact_window_s),
      bat_{.q = Eigen::ArrayXd::Zero(omega_.size()), .rate = Eigen::ArrayXd::Zero(omega_.size())},
      earlier_(bat_),
      ball_mps_(closing_mps_),
      rate_mps_(closing_mps_) {}

void BatImpact::step() {
  check_budget();
  const double h = contact_.step_s;
  bat_.advance(contact_, force_N_);
  ball_m_ += h * ball_mps_ - h * h / 3 * force_N_ / ball_.mass_kg;
  const double free_u = ball_m_ - bat_.deflection(contact_);  // with no force at the step's end
  const double free_rate = ball_mps_ - h / 2 * force_N_ / ball_.mass_kg - (contact_.phi * bat_.rate).sum();
  const double before_N = force_N_;
  force_N_ = end_force(free_u);
  const bool turns = free_u > 0 && u_m_ >= largest_m_ && free_rate < compliance_rate_ * force_N_;
  if (turns) {
    largest_m_ = std::max(u_m_, turning_point(free_u, free_rate));
    force_N_ = end_force(free_u);
  }
  bat_.add_end(contact_, force_N_);
  ball_m_ -= h * h / 6 * force_N_ / ball_.mass_kg;
  ball_mps_ -= h / 2 * (before_N + force_N_) / ball_.mass_kg;
  u_m_ = free_u - compliance_ * force_N_;
  rate_mps_ = free_rate - compliance_rate_ * force_N_;
  largest_m_ = std::max(largest_m_, u_m_);
  deepest_m_ = std::max(deepest_m_, u_m_);
  time_s_ += h;
}

Eigen::VectorXd BatImpact::amplitudes_at(double time_s) {
  while (time_s_ < time_s) {
    earlier_ = bat_;
    earlier_N_ = force_N_;
    step();
    if (!(u_m_ > 0)) largest_m_ = 0;
  }
  if (time_s_ == 0) return bat_.q;
  // Repeats the last step under the same force, but only up to time_s.
  const double part = 1 - (time_s_ - time_s) / contact_.step_s;
  const ModalStepper shorter(omega_, contact_.phi, part * contact_.step_s);
  ModalState then = earlier_;
  then.advance(shorter, earlier_N_);
  then.add_end(shorter, earlier_N_ + part * (force_N_ - earlier_N_));
  return then.q;
}

BatRebound BatImpact::run() {
  BatRebound result;
  for (result.contacts = 0;; ++result.contacts) {
    // If the ball is not compressed by this time, the touch was a rounding error.
    const double touch_by_s = time_s_ + 2 * free_.step_s;
    do {
      step();
    } while (u_m_ > 0 || (largest_m_ == 0 && time_s_ < touch_by_s));
    result.contact_s = time_s_;
    largest_m_ = 0;
    if (result.contacts + 1 == kMaxTouches || !will_recontact()) break;
  }
  ++result.contacts;
  result.largest_m = deepest_m_;
  result.exit_speed_mps = swing_mps_ - ball_mps_;
  const double ball_J = ball_.mass_kg / 2 * closing_mps_ * closing_mps_;
  const double inverse_mass_per_kg = contact_.phi.head(kRigidMotions).square().sum();  // 1/M_e
  const double collision_J = ball_J / (1 + ball_.mass_kg * inverse_mass_per_kg);
  const Eigen::ArrayXd energy_J = (bat_.rate.square() + (omega_ * bat_.q).square()) / 2;
  result.mode_share = (energy_J.tail(count_) / collision_J).matrix();
  result.ball_share = (ball_J - ball_.mass_kg / 2 * ball_mps_ * ball_mps_ - energy_J.sum()) / collision_J;
  return result;
}

double BatImpact::turning_point(double free_u, double free_rate) const {
  const double h = contact_.step_s, a = u_m_, ra = h * rate_mps_, b = free_u - compliance_ * force_N_;
  const double rb = h * (free_rate - compliance_rate_ * force_N_), c = 3 * (b - a) - 2 * ra - rb,
               d = 2 * (a - b) + ra + rb;
  const double at = ra / (std::sqrt(std::max(0.0, c * c - 3 * d * ra)) - c);  // position of the cubic's maximum
  return at > 0 && at < 1 ? a + at * (ra + at * (c + at * d)) : std::max(a, b);
}

double BatImpact::end_force(double free_u) const {
  if (!(free_u > 0)) return 0;
  double low = 0, high = free_u, u = std::clamp(u_m_, 0.0, free_u);
  for (int i = 0; i < kMaxTries && high - low > kCompressionAccuracy * wall_m_; ++i) {
    const double force_N = ball_.force_N(u, largest_m_), excess = u + compliance_ * force_N - free_u;
    (excess > 0 ? high : low) = u;
    const double slope = 1 + compliance_ * (u > 0 ? force_N / u * exponent_at(u) : 0);
    const double newton = u - excess / slope;
    if (std::abs(newton - u) <= kCompressionAccuracy * wall_m_) break;
    u = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return ball_.force_N(u, largest_m_);
}

double BatImpact::exponent_at(double u) const {
  const double e = ball_.restitution;
  return u >= largest_m_ ? ball_.exponent : (1 + ball_.exponent) / (e * e) - 1;
}

bool BatImpact::will_recontact() {
  const double end_s = time_s_ + recontact_window_s_;
  while (time_s_ < end_s && !has_separated()) {
    check_budget();
    const ModalState before = bat_;
    bat_.advance(free_, 0);
    const double ball_m = ball_m_ + free_.step_s * ball_mps_;
    if (ball_m > bat_.deflection(free_)) {
      bat_ = before;
      u_m_ = ball_m_ - bat_.deflection(contact_);
      return true;
    }
    ball_m_ = ball_m;
    time_s_ += free_.step_s;
  }
  return false;
}

bool BatImpact::has_separated() const {
  const auto phi = contact_.phi.head(kRigidMotions);
  const double gap_m = (phi * bat_.q.head(kRigidMotions)).sum() - ball_m_;
  const double speed = (phi * bat_.rate.head(kRigidMotions)).sum() - ball_mps_;
  const Eigen::ArrayXd q = bat_.q.tail(count_), rate = bat_.rate.tail(count_) / omega_.tail(count_);
  return speed > 0 && gap_m > (contact_.phi.tail(count_).abs() * (q.square() + rate.square()).sqrt()).sum();
}

}  // namespace percuss::model
