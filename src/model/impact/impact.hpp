#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"

namespace percuss::model {

enum class ImpactMethod {
  modal,           // the modes move exactly between impulses of the contact force; fourth order
  small_increment  // the source's method: the force is constant over each step; first order
};

/// A mode of the beam at the struck point: yᵢ of (1) below.
struct StruckMode {
  double omega_radps = 0;  // 0 for a rigid-body mode
  double weight = 0;       // 1/√kg
};

/// A ball that hits a beam at rest. The defaults are the composite bat and the cricket ball of [9], struck 60 mm from
/// its free end. The source does not state its Hertz constant; this one reproduces the level of its results.
struct Impact {
  UniformBeam beam;
  double at_m = 0.51;  // from the spring's end
  double ball_mass_kg = 0.16, speed_mps = 5;
  double hertz_Npm15 = 3.2e6;
  double hysteresis_spm = 0;  // χ of (2)
  std::size_t modes = 10;
  std::vector<StruckMode> struck{};  // replaces `beam`, `at_m` and `modes` where it is not empty
};

struct ImpactOptions {
  ImpactMethod method = ImpactMethod::modal;
  double step_s = 0;  // 0: small_increment 10 µs; modal: shortened until the rebound converges
  bool series = false;
};

/// The motion at one time after the first touch; positive in the ball's initial direction.
struct ImpactMoment {
  double time_s = 0, beam_m = 0, ball_m = 0, force_N = 0, ball_speed_mps = 0;
};

struct ImpactResult {
  double cor = 0;        // −v_out/v_in at the first separation; negative when the ball follows the beam
  double contact_s = 0;  // from the first touch to the first separation
  double peak_force_N = 0;
  // The beam's deflection at at_m, until 80 ms after the first separation. peak: the largest magnitude, with its sign
  // (positive along the ball's initial motion). forward: the largest value in that direction. NaN if flies_off.
  double peak_deflection_m = 0, peak_deflection_time_s = 0;
  double forward_deflection_m = 0, forward_deflection_time_s = 0;
  bool flies_off = false;  // a rigid-body mode carries the struck point away, so there is no largest deflection
  std::optional<double> recontact_s;            // from the first touch to the second; none within those 80 ms: empty
  std::size_t contacts = 1;                     // until the ball stays away for 80 ms
  double last_separation_s = 0;                 // from the first touch
  std::optional<double> final_cor;              // −v_out/v_in after the last contact; none where contacts do not end
  std::optional<double> final_cor_uncertainty;  // one contact: cor_uncertainty; several: from halving the step
  double energy_error = 0;                      // largest |E/E₀ − 1|, E = ball + modes + contact + lost energy
  double lost_J = 0;                            // to the hysteresis of the contact
  std::optional<double> cor_uncertainty;        // from the change in the last refinement; none for a given step
  std::size_t steps = 0;                        // of the contact, in the last pass
  std::vector<double> omega_radps;              // of the modes
  std::vector<ImpactMoment> series;             // the contact and 80 ms after it, without further contacts
};

/// The time after the first separation for which the motion is followed.
inline constexpr double kFollowUp_s = 0.08;

/// Simulates a Hertz ball on a beam from the first touch to the first separation, and the free motion after it. Where
/// they touch again, further contacts follow until the ball stays away. Each separation is located within its step.
///   η̈ᵢ + ωᵢ² ηᵢ = yᵢ F,  w₁ = Σ yᵢ ηᵢ,  yᵢ = Xᵢ(c)/√(ρA Nᵢ),  m ẅ₂ = −F         (1)
///   F = k₂ α^(3/2) (1 + χ α̇), not below 0;  α = w₂ − w₁ > 0, else F = 0           (2)
/// The contact ends when F falls to zero. If 1 + χα̇ reaches zero before α does, the ball keeps a dent of depth α in the
/// free motion.
/// modal: each step consists of five symmetric second-order steps of p, p, 1 − 4p, p, p of its length, with
/// p = 1/(4 − 4^(1/3)). Each of the five is half a step of exact free motion, an impulse, and another half step. Steps
/// shrink as √α where α is small, because the power 3/2 would reduce the order. If no step is given, the step
/// becomes shorter until the estimated error of the restitution and the error of the energy are at most 5e-10.
/// errors  InputError when ball and beam do not separate within the limit of steps.
/// source  [9]; the loss in (2) [13]; the five steps [14].
/// theory (9.1), (9.2)
ImpactResult simulate_impact(const Impact& impact, const ImpactOptions& options = {});

/// The duration of the contact with a rigid wall: 2.943 α_m/v, α_m = (5 m v²/(4 k₂))^(2/5).
/// theory (9.4)
double hertz_contact_s(const Impact& impact);

/// The χ with which a ball leaves a rigid wall at `restitution` (above 0, at most 1) times its speed:
///   ln((1 + d)/(1 − e d)) = d (1 + e),  d = χ v                                  (3)
/// theory (9.3)
double hysteresis_for_spm(double restitution, double speed_mps);

}  // namespace percuss::model
