#pragma once
#include <cstddef>
#include <vector>

namespace percuss::model {

/// How a beam is held at x = 0; its end x = L is free.
enum class BeamSupport {
  torsion,  // pinned, with a torsion spring
  pinned,   // a spring of stiffness 0: the beam can turn as a rigid body
  clamped,  // a spring of infinite stiffness
  free      // no support: the beam can move and turn as a rigid body
};

/// A uniform beam. The defaults are the composite cricket bat of [9] in docs/theory/sources.md; its length is inferred.
struct UniformBeam {
  BeamSupport support = BeamSupport::torsion;
  double stiffness_Nm2 = 4000;         // EI
  double mass_per_length_kgpm = 2.24;  // ρA
  double torsion_Nmprad = 1200;        // T of the spring; unused with another support
  double length_m = 0.57;              // L
  // Timoshenko's terms; with both at 0 the beam is an Euler–Bernoulli beam.
  double gyration_m = 0;         // √(I/A) of the section: rotary inertia ρI = ρA·I/A
  double shear_stiffness_N = 0;  // κGA; 0: infinite

  bool is_timoshenko() const { return gyration_m > 0 || shear_stiffness_N > 0; }
  double relative_torsion() const { return torsion_Nmprad * length_m / stiffness_Nm2; }  // T* = T L / EI
};

/// One natural mode of a beam, undamped. Its deflection, with ξ = x/L,
///   X = o + t ξ + p sin λξ + q cos λξ + a e^(−δ(1−ξ)) + b e^(−δξ)      (1)
/// A rigid-body mode (λ = 0) has only o and t, an elastic mode only the other terms. No exponential grows, so high
/// modes do not suffer from cancellation. δ = λ for Euler–Bernoulli beams. The shape is scaled to X = 1 at the free end
/// x = L.
/// theory (8.5)
struct BeamMode {
  double lambda = 0;       // βL
  double decay = 0;        // δ
  double omega_radps = 0;  // 0 for a rigid-body mode
  double length_m = 1;
  double norm_m = 0;  // ∫ X² dx over the beam; 0 (not computed) for a Timoshenko beam
  double offset = 0, tilt = 0, sine = 0, cosine = 0, far = 0, near = 0;  // o t p q a b

  double shape(double x_m) const;
  double slope_1pm(double x_m) const;  // dX/dx
  double freq_Hz() const;
};

/// Computes the `count` lowest modes, rigid-body modes first: a pinned beam turns about its end, a free beam moves and
/// turns.
///   T* (1 + cos λ cosh λ) = λ (sin λ cosh λ − cos λ sinh λ)    torsion spring      (2)
///   cos λ cosh λ = ∓1                                          clamped, free       (3)
///   tan λ = tanh λ                                             pinned              (4)
///   ω = (λ/L)² √(EI/ρA)                                                            (5)
///   ∫ X² dx = L X(L)²/4 + (T/EI) X′(0)²/(4 β⁴)                                     (6)
/// The equations are multiplied by e^(−λ) before they are solved. A root of (2) lies between roots of (4) and (3).
/// timoshenko_mode solves Timoshenko beams.
/// errors  InputError when a double cannot hold a frequency, or where timoshenko_mode throws one.
/// source  [9], with its equations corrected.
/// theory (8.1), (8.2), (8.3), (8.4), (8.6)
std::vector<BeamMode> beam_modes(const UniformBeam& beam, std::size_t count);

/// The number of rigid-body modes.
std::size_t rigid_body_modes(BeamSupport support);

/// The positions of the mode's nodes in ascending order. The support of a beam held at x = 0 is not one of them.
std::vector<double> beam_nodes_m(const BeamMode& mode);

}  // namespace percuss::model
