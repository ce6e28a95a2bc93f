#include "model/impact/ball_on_beam.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::model {
namespace {

const double kPart = 1 / (4 - std::cbrt(4.0));  // p: five steps of second order make one of fourth (Suzuki)

double pow_3_2(double x) { return x > 0 ? x * std::sqrt(x) : 0; }

double weighted_sum(const std::vector<double>& weight, const std::vector<double>& value) {
  double sum = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) sum += weight[i] * value[i];
  return sum;
}

}  // namespace

BallOnBeam::BallOnBeam(const Impact& impact)
    : ball_mass_kg_(impact.ball_mass_kg),
      hertz_(impact.hertz_Npm15),
      hysteresis_(impact.hysteresis_spm),
      mobility_(1 / impact.ball_mass_kg) {
  omega_.reserve(impact.modes);
  y_.reserve(impact.modes);
  for (const BeamMode& mode : beam_modes(impact.beam, impact.modes)) {
    omega_.push_back(mode.omega_radps);
    y_.push_back(mode.shape(impact.at_m) / std::sqrt(impact.beam.mass_per_length_kgpm * mode.norm_m));
    mobility_ += y_.back() * y_.back();
  }
  for (ModalRotation* turn : {&first_, &second_, &third_}) {
    for (auto* values : {&turn->c, &turn->s_over_omega, &turn->omega_s}) values->resize(impact.modes);
  }
}

BallOnBeamState BallOnBeam::start(double speed_mps) const {
  return {.eta = std::vector<double>(modes()), .rate = std::vector<double>(modes()), .ball_mps = speed_mps};
}

double BallOnBeam::force_of(double approach_m, double rate_mps) const {
  return hertz_ * pow_3_2(approach_m) * std::max(0.0, 1 + hysteresis_ * rate_mps);  // (2)
}

BallOnBeamReading BallOnBeam::read(const BallOnBeamState& state) const {
  BallOnBeamReading reading;
  double back_mps2 = 0, twice_J = 0;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double pull = omega_[i] * omega_[i] * state.eta[i];
    reading.beam_m += y_[i] * state.eta[i];
    reading.beam_mps += y_[i] * state.rate[i];
    back_mps2 += y_[i] * pull;
    twice_J += state.rate[i] * state.rate[i] + pull * state.eta[i];
  }
  const double approach = state.ball_m - reading.beam_m, rate = state.ball_mps - reading.beam_mps;
  const double pressed = std::max(0.0, approach);
  reading.approach_m = approach;
  reading.contact_event_m = approach > 0 ? approach * (1 + hysteresis_ * rate) : approach;
  reading.force_N = force_of(approach, rate);
  const double acceleration = back_mps2 - mobility_ * reading.force_N;
  reading.force_rate_Nps =
      hertz_ * std::sqrt(pressed) * (1.5 * rate * (1 + hysteresis_ * rate) + pressed * hysteresis_ * acceleration);
  reading.energy_J = (ball_mass_kg_ * state.ball_mps * state.ball_mps + twice_J) / 2 +
                     0.4 * hertz_ * pressed * pow_3_2(pressed) + state.lost_J;
  return reading;
}

void BallOnBeam::set_rotation(ModalRotation& turn, double dt_s) const {
  turn.dt_s = dt_s;
  for (std::size_t i = 0; i < omega_.size(); ++i) {
    const double angle = omega_[i] * dt_s, s = std::sin(angle);
    turn.c[i] = std::cos(angle);
    turn.s_over_omega[i] = omega_[i] > 0 ? s / omega_[i] : dt_s;
    turn.omega_s[i] = omega_[i] * s;
  }
}

void BallOnBeam::set_double_rotation(const ModalRotation& half, ModalRotation& turn) const {
  turn.dt_s = 2 * half.dt_s;
  for (std::size_t i = 0; i < omega_.size(); ++i) {
    turn.c[i] = 1 - 2 * half.omega_s[i] * half.s_over_omega[i];
    turn.s_over_omega[i] = 2 * half.c[i] * half.s_over_omega[i];
    turn.omega_s[i] = 2 * half.c[i] * half.omega_s[i];
  }
}

void BallOnBeam::drift(BallOnBeamState& state, const ModalRotation& turn) {
  for (std::size_t i = 0; i < state.eta.size(); ++i) {
    const double eta = state.eta[i];
    state.eta[i] = turn.c[i] * eta + turn.s_over_omega[i] * state.rate[i];
    state.rate[i] = turn.c[i] * state.rate[i] - turn.omega_s[i] * eta;
  }
  state.ball_m += state.ball_mps * turn.dt_s;
}

// During a kick the approach α is constant and α̇ falls: (1 + χα̇)′ = −μ χ k₂ α^(3/2) (1 + χα̇), with the mobility μ. The
// solution of this equation is exact.
void BallOnBeam::kick(BallOnBeamState& state, double dt_s) const {
  const double elastic = hertz_ * pow_3_2(state.ball_m - weighted_sum(y_, state.eta));
  double impulse = elastic * dt_s;
  if (hysteresis_ > 0) {
    const double scale = 1 + hysteresis_ * (state.ball_mps - weighted_sum(y_, state.rate));
    if (!(scale > 0)) return;
    const double fall = mobility_ * hysteresis_ * elastic * dt_s;  // of ln(1 + χα̇)
    const double gone = -std::expm1(-fall);
    impulse = scale * gone / (mobility_ * hysteresis_);
    // The work that (2) dissipates: ∫ k₂ α^(3/2) α̇ (1 + χα̇) dt − ∫ k₂ α^(3/2) α̇ dt.
    state.lost_J += (-scale * scale * std::expm1(-2 * fall) / 2 - 2 * scale * gone + fall) /
                    (mobility_ * hysteresis_ * hysteresis_);
  }
  state.ball_mps -= impulse / ball_mass_kg_;
  for (std::size_t i = 0; i < y_.size(); ++i) state.rate[i] += y_[i] * impulse;
}

void BallOnBeam::step(BallOnBeamState& state, double dt_s) {
  set_rotation(first_, kPart * dt_s / 2);
  set_double_rotation(first_, second_);
  set_rotation(third_, (1 - 3 * kPart) * dt_s / 2);
  drift(state, first_);
  kick(state, kPart * dt_s);
  drift(state, second_);
  kick(state, kPart * dt_s);
  drift(state, third_);
  kick(state, (1 - 4 * kPart) * dt_s);
  drift(state, third_);
  kick(state, kPart * dt_s);
  drift(state, second_);
  kick(state, kPart * dt_s);
  drift(state, first_);
}

void BallOnBeam::small_increment(BallOnBeamState& state, double dt_s) {
  const BallOnBeamReading before = read(state);
  const double lossy_N = before.force_N - hertz_ * pow_3_2(before.approach_m);
  if (first_.dt_s != dt_s) set_rotation(first_, dt_s);
  drift(state, first_);
  const double half_s2 = dt_s * dt_s / 2;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double half = omega_[i] * dt_s / 2;
    const double chord = half > 0 ? std::sin(half) / half : 1;  // (1 − cos ωt)/ω² = t²/2 · chord²
    state.eta[i] += y_[i] * before.force_N * half_s2 * chord * chord;
    state.rate[i] += y_[i] * before.force_N * first_.s_over_omega[i];
  }
  state.ball_m -= before.force_N * half_s2 / ball_mass_kg_;
  state.ball_mps -= before.force_N * dt_s / ball_mass_kg_;
  state.lost_J += lossy_N * (state.ball_m - weighted_sum(y_, state.eta) - before.approach_m);
}

}  // namespace percuss::model
