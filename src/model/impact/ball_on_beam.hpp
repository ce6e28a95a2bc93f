#pragma once
#include <cstddef>
#include <vector>

#include "model/impact/impact.hpp"

namespace percuss::model {

/// The state of ball and beam, in the variables of (1) of impact.hpp.
struct BallOnBeamState {
  std::vector<double> eta, rate;  // [modes]
  double ball_m = 0, ball_mps = 0;
  double lost_J = 0;  // in the contact, so far
};

/// Quantities derived from a state.
struct BallOnBeamReading {
  double beam_m = 0, beam_mps = 0;
  double approach_m = 0;
  double contact_event_m = 0;  // above 0 only during contact: approach · (1 + χα̇), or the approach if negative
  double force_N = 0, force_rate_Nps = 0;
  double energy_J = 0;  // of the ball, of the modes, in the contact, and lost
};

/// Integrates (1), (2) of impact.hpp step by step.
class BallOnBeam {
 public:
  explicit BallOnBeam(const Impact& impact);

  /// The state at the first touch, with the beam at rest.
  BallOnBeamState start(double speed_mps) const;
  BallOnBeamReading read(const BallOnBeamState& state) const;

  /// Advances by one symmetric fourth-order step.
  void step(BallOnBeamState& state, double dt_s);
  /// Advances without contact, exactly.
  void move_freely(BallOnBeamState& state, double dt_s);
  /// Advances by one step with the force at its start.
  void small_increment(BallOnBeamState& state, double dt_s);

  std::size_t modes() const { return omega_.size(); }
  const std::vector<double>& omega_radps() const { return omega_; }
  const std::vector<double>& weight() const { return y_; }  // yᵢ

 private:
  /// The rotation of the modes in free motion over dt_s.
  struct ModalRotation {
    double dt_s = 0;
    std::vector<double> c, s_over_omega, omega_s;
  };
  void set_rotation(ModalRotation& turn, double dt_s) const;
  void set_double_rotation(const ModalRotation& half, ModalRotation& turn) const;
  static void drift(BallOnBeamState& state, const ModalRotation& turn);
  void kick(BallOnBeamState& state, double dt_s) const;
  double force_of(double approach_m, double rate_mps) const;

  double ball_mass_kg_, hertz_, hysteresis_, mobility_;  // mobility: 1/m + Σ yᵢ²
  std::vector<double> omega_, y_;
  ModalRotation first_, second_, third_;
};

}  // namespace percuss::model
