#pragma once
#include <cstddef>
#include <vector>

namespace percuss::model {

/// How a beam is held at x = 0; its end x = L is free.
enum class BeamSupport {
  torsion,  // pinned, with a torsion spring
  pinned,   // the spring's stiffness 0: the beam can turn as a rigid body
  clamped,  // … without bound
  free      // not held at all: the beam can move and turn as a rigid body
};

/// A uniform beam. The defaults are the composite cricket bat of [9] in docs/theory/sources.md; its length is inferred.
struct UniformBeam {
  BeamSupport support = BeamSupport::torsion;
  double stiffness_Nm2 = 4000;         // EI
  double mass_per_length_kgpm = 2.24;  // ρA
  double torsion_Nmprad = 1200;        // T, of the spring; otherwise unused
  double length_m = 0.57;              // L
  // What Euler and Bernoulli leave out; both as they are there unless given (Timoshenko).
  double gyration_m = 0;         // √(I/A), of the section: rotary inertia ρI = ρA·I/A
  double shear_stiffness_N = 0;  // κGA; 0: without bound

  bool is_timoshenko() const { return gyration_m > 0 || shear_stiffness_N > 0; }
  double relative_torsion() const { return torsion_Nmprad * length_m / stiffness_Nm2; }  // T* = T L / EI
};

/// One natural mode of a beam, undamped. Its deflection, with ξ = x/L,
///   X = o + t ξ + p sin λξ + q cos λξ + a e^(−δ(1−ξ)) + b e^(−δξ)      (1)
/// where o and t are those of a rigid-body mode (λ = 0) and the others those of an elastic one. Growing exponentials do
/// not occur, so that nothing cancels in high modes. δ = λ for Euler and Bernoulli. Scaled so that X = 1 at the free
/// end x = L.
/// theory (8.5)
struct BeamMode {
  double lambda = 0;       // βL
  double decay = 0;        // δ
  double omega_radps = 0;  // 0 for a rigid-body mode
  double length_m = 1;
  double norm_m = 0;  // ∫ X² dx over the beam; of a Timoshenko beam not known: 0
  double offset = 0, tilt = 0, sine = 0, cosine = 0, far = 0, near = 0;  // o t p q a b

  double shape(double x_m) const;
  double slope_1pm(double x_m) const;  // dX/dx
  double freq_Hz() const;
};

/// The `count` lowest modes, rigid-body modes first: a pinned beam turns about its end, a free one moves and turns.
///   T* (1 + cos λ cosh λ) = λ (sin λ cosh λ − cos λ sinh λ)    held by a spring    (2)
///   cos λ cosh λ = ∓1                                          clamped, free       (3)
///   tan λ = tanh λ                                             pinned              (4)
///   ω = (λ/L)² √(EI/ρA)                                                            (5)
///   ∫ X² dx = L X(L)²/4 + (T/EI) X′(0)²/(4 β⁴)                                     (6)
/// The equations are solved times e^(−λ), (2) between the roots of (4) and (3). Timoshenko beams: timoshenko.hpp.
/// errors  InputError when a frequency is beyond what a double holds, or above where timoshenko.hpp goes.
/// source  [9], its equations repaired.
/// theory (8.1), (8.2), (8.3), (8.4), (8.6)
std::vector<BeamMode> beam_modes(const UniformBeam& beam, std::size_t count);

/// How many of the lowest modes are rigid-body modes.
std::size_t rigid_body_modes(BeamSupport support);

/// Where the mode's deflection is zero, in order, without x = 0 of a beam held there.
std::vector<double> beam_nodes_m(const BeamMode& mode);

}  // namespace percuss::model
