#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"

namespace percuss::model {

enum class ImpactMethod {
  modal,           // modes move exactly between pushes of the contact force; fourth order
  small_increment  // the source's: the force at a step's start acts through the step; first order
};

/// A ball against a beam at rest. The defaults are the composite bat and the cricket ball of [9], struck 60 mm from its
/// free end; the Hertz constant is not given there: this one reproduces its level.
struct Impact {
  UniformBeam beam;
  double at_m = 0.51;  // from the spring's end
  double ball_mass_kg = 0.16, speed_mps = 5;
  double hertz_Npm15 = 3.2e6;
  double hysteresis_spm = 0;  // χ of (2)
  std::size_t modes = 10;
};

struct ImpactOptions {
  ImpactMethod method = ImpactMethod::modal;
  double step_s = 0;  // 0: small_increment 10 µs; modal: halved until the rebound settles
  bool series = false;
};

/// The motion at one time after first touch; positive along the ball's first motion.
struct ImpactMoment {
  double time_s = 0, beam_m = 0, ball_m = 0, force_N = 0, ball_speed_mps = 0;
};

struct ImpactResult {
  double cor = 0;        // −v_out/v_in at the first separation; negative when the ball follows the beam
  double contact_s = 0;  // from first touch to first separation
  double peak_force_N = 0;
  double peak_deflection_m = 0, peak_deflection_time_s = 0;  // of the beam there, until 80 ms after first separation
  std::optional<double> recontact_s;                         // when they touch again, within those 80 ms
  double energy_error = 0;                // largest |E/E₀ − 1|, E = ball + modes + contact + what was lost
  double lost_J = 0;                      // in the contact's hysteresis
  std::optional<double> cor_uncertainty;  // what halving the step still changed; none for a step that was given
  std::size_t steps = 0;                  // of the contact, in the last pass
  std::vector<double> omega_radps;        // of the modes
  std::vector<ImpactMoment> series;       // contact and 80 ms after it; second contacts left out
};

/// How long after the first separation the motion is followed.
inline constexpr double kFollowUp_s = 0.08;

/// A Hertz ball on a beam, from first touch to first separation, which is located between steps, and the free motion
/// after.
///   η̈ᵢ + ωᵢ² ηᵢ = yᵢ F,  w₁ = Σ yᵢ ηᵢ,  yᵢ = Xᵢ(c)/√(ρA Nᵢ),  m ẅ₂ = −F         (1)
///   F = k₂ α^(3/2) (1 + χ α̇), not below 0;  α = w₂ − w₁ > 0, else F = 0           (2)
/// The contact ends when F falls to zero; a dent that is then left (1 + χα̇ < 0 before α = 0) stays for the free motion.
/// modal: each step is five symmetric second-order ones, of p, p, 1 − 4p, p, p of its length, p = 1/(4 − 4^(1/3)), each
/// a half step of free motion (exact), a push, a half step; where α is small the steps shrink as √α, or the 3/2 power
/// would spoil the order (4). Without a step given, it is halved until the rebound changes by less than 1e-9 and
/// the energy closes as well; that is 1e-10 of the truth and better.
/// errors  InputError when the two do not separate within as many steps as are reasonable.
/// source  [9]; (2)'s loss [13]; the five steps [14].
/// theory (9.1), (9.2)
ImpactResult simulate_impact(const Impact& impact, const ImpactOptions& options = {});

/// The duration of the same ball's contact with a rigid wall: 2.943 α_m/v, α_m = (5 m v²/(4 k₂))^(2/5).
/// theory (9.4)
double hertz_contact_s(const Impact& impact);

/// The χ with which the ball leaves a rigid wall at `restitution` times the speed (above 0, at most 1):
///   ln((1 + d)/(1 − e d)) = d (1 + e),  d = χ v                                  (3)
/// theory (9.3)
double hysteresis_for_spm(double restitution, double speed_mps);

}  // namespace percuss::model
