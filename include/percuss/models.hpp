#pragma once
/// Models: a uniform beam, a ball that strikes it, rigid and bending bats, a hollow barrel (trampoline), a tube
/// (shell). The equations and their sources stand in docs/theory/theory.md.
///
/// @code
/// #include <iostream>
/// #include <percuss/models.hpp>
///
/// int main() {
///   const percuss::Beam beam{.support = percuss::BeamSupport::clamped, .length_m = 0.6};
///   for (const percuss::BeamMode& mode : percuss::beam_modes(beam)) std::cout << mode.freq_Hz << " Hz\n";
///   std::cout << "COR " << percuss::beam_impact({.beam = beam, .at_m = 0.5}).cor << '\n';
///   std::cout << percuss::hoop_Hz({.wall_m = 0.003}, 2, 1) << " Hz\n";
/// }
/// @endcode
#include <cstddef>
#include <optional>
#include <vector>

namespace percuss {

/// How a beam is held at x = 0; the other end is free.
enum class BeamSupport { torsion, pinned, clamped, free };

struct Beam {
  BeamSupport support = BeamSupport::torsion;
  double ei_Nm2 = 4000;
  double rho_a_kgpm = 2.24;
  double torsion_Nmprad = 1200;  // of the spring
  double length_m = 0.57;
  double gyration_m = 0;         // √(I/A), rotary inertia; 0: none
  double shear_stiffness_N = 0;  // κGA; 0: infinite, without shear deformation
};

struct BeamMode {
  double freq_Hz = 0;  // 0 for a rigid-body mode
  double lambda = 0;   // βL
  std::vector<double> node_m;
  std::vector<double> shape;  // at BeamModeOptions::x_m; 1 at the free end
};

struct BeamModeOptions {
  std::size_t modes = 5;
  std::vector<double> x_m{};  // positions of BeamMode::shape
};

/// The lowest modes, rigid-body modes first. errors  InputError: values not above 0; frequencies beyond the range of
/// double; with shear, modes above the cut-off frequency.
std::vector<BeamMode> beam_modes(const Beam& beam, const BeamModeOptions& options = {});

/// A ball that hits a beam at rest.
struct BeamImpact {
  Beam beam{};
  double at_m = 0.51;  // from x = 0, the supported end
  double ball_mass_kg = 0.16, speed_mps = 5;
  double hertz_Npm15 = 3.2e6;  // k of the contact force k α^(3/2) (1 + χ α̇), α the approach
  double hysteresis_spm = 0;   // χ; 0: a contact without loss
  std::size_t modes = 10;
  double step_s = 0;  // 0: shortened until the rebound converges
};

struct BeamImpactResult {
  double cor = 0;                          // at the first separation
  double contact_s = 0, peak_force_N = 0;  // of the first contact
  // The largest deflection at at_m by magnitude, until 80 ms after the first separation; positive along the ball's
  // motion. NaN where the beam flies off.
  double peak_deflection_m = 0, peak_deflection_time_s = 0;
  std::optional<double> recontact_s{};  // time of the second contact, from the first touch
  std::size_t contacts = 1;             // until the ball stays away for 80 ms
  std::optional<double> final_cor{};    // after the last contact; none where the contacts do not end
  double energy_error = 0;              // largest |E/E₀ − 1| of the total energy E
};

/// errors  InputError: ball and beam do not separate; values not above 0; a beam with shear or rotary inertia.
BeamImpactResult beam_impact(const BeamImpact& impact);

/// A ball that hits a rigid bat; z from the bat's centre of mass.
struct RigidBat {
  double ball_mass_kg = 0.145, bat_mass_kg = 0.83;
  double inertia_kgm2 = 0.039;                    // about the centre of mass
  double ball_speed_mps = 67, bat_speed_mps = 0;  // towards each other; bat_speed_mps is of the centre of mass
  double swing_rate_radps = 60;                   // positive: the barrel moves towards the ball
  double cor = 0.55;                              // relative speed after over before, at the struck point
};

/// Effective mass of the bat at z_m.
double effective_mass_kg(const RigidBat& bat, double z_m);
/// Speed of the ball after the impact, positive against its initial direction.
double exit_speed_mps(const RigidBat& bat, double z_m);
/// The place between low_m and high_m with the largest exit speed.
double best_impact_m(const RigidBat& bat, double low_m, double high_m);

/// A ball that hits a hollow barrel at rest. Each has one degree of freedom.
struct Trampoline {
  double ball_mass_kg = 0.145;
  double stiffness = 60e6;                                        // N/m^(1 + stiffness_exponent)
  double damping = 5000;                                          // N s/m^(1 + damping_exponent)
  double stiffness_exponent = 0.6495, damping_exponent = 0.5202;  // damping_exponent < 1 + stiffness_exponent
  double barrel_mass_kg = 0.090, barrel_damping_Nspm = 90.5;
  double ball_speed_mps = 60.80;
};

struct TrampolineRebound {
  double cor = 0;        // after the last contact
  double contact_s = 0;  // from the first touch to the end of the last contact
  std::size_t contacts = 1;
};

/// errors  InputError: values not above 0; a contact that does not end within a million steps, or whose result is not
/// finite; a thousand contacts without a departure.
TrampolineRebound trampoline_rebound(const Trampoline& model, double hoop_Hz);
/// The rebound from a rigid barrel.
TrampolineRebound rigid_wall_rebound(const Trampoline& model);

/// A mass without stiffness on a bat, such as a grip or a cap: spread evenly, or a point mass where both ends are
/// equal.
struct BatMass {
  double mass_kg = 0;
  double from_m = 0, to_m = 0;
};

/// A round bat from the knob on. end_m, diameter_m and, for a hollow bat, wall_m have equal lengths; end_m ascends.
struct BatProfile {
  std::vector<double> end_m, diameter_m;
  double density_kgpm3 = 649, young_Pa = 1.814e10;
  double shear_Pa = 1.05e9;      // shear modulus × shape factor
  std::vector<double> wall_m{};  // empty: solid
  bool points = false;           // true: dimensions at end_m, linear between; false: of the slice that ends at end_m
  std::vector<BatMass> added{};
  BeamSupport support = BeamSupport::free;
  double support_m = 0.1524;     // position of the support
  double torsion_Nmprad = 1200;  // of the spring
};

struct BatModes {
  double mass_kg = 0, cm_m = 0, inertia_kgm2 = 0;  // inertia about the centre of mass; positions from the knob
  std::vector<double> freq_Hz;
  std::vector<std::vector<double>> node_m;  // [modes]
};

/// Elastic modes of a bat. errors  InputError: vectors of different lengths, values not above 0, masses or a support
/// that are not on the bat.
BatModes bat_modes(const BatProfile& profile, std::size_t modes = 5);

struct BatCollision {
  double ball_mass_kg = 0.145, ball_speed_mps = 67;
  double bat_speed_mps = 0;      // of a free bat
  double swing_rate_radps = 60;  // of a free bat, or of a bat on a pin; a bat on a spring or in a clamp rests
  double cor = 0.5;              // of the ball itself
  std::size_t modes = 40;
};

/// Exit speed of the ball for impacts at z_m from the knob. errors  as bat_modes; a place that is not on the bat.
std::vector<double> bat_exit_speeds_mps(const BatProfile& profile, const std::vector<double>& z_m,
                                        const BatCollision& collision = {});

/// A barrel as a tube with a wall of constant thickness.
struct Tube {
  double outer_diameter_m = 0.066675, wall_m = 0.00254, length_m = 0.3302;
  double young_Pa = 70e9, density_kgpm3 = 2700, poisson = 0.33;
};

/// Flügge's frequency with n waves around (2 and above) and m half-waves along (1 and above; 0 counts as 1).
/// errors  InputError: not a tube; n below 2
double hoop_Hz(const Tube& tube, std::size_t n, std::size_t m);
/// Rayleigh's frequency of a long tube with n waves around.
double long_hoop_Hz(const Tube& tube, std::size_t n);

}  // namespace percuss
