#pragma once
#include <cstddef>
#include <vector>

namespace percuss::model {

/// A ball that hits the hollow barrel of a bat at rest. Ball and barrel have one degree of freedom each: the ball is a
/// nonlinear spring and dashpot, the barrel's hoop mode a linear oscillator. The defaults are the constants of the
/// source's script for a baseball.
///   m₁ẍ₁ = −F, m₂ẍ₂ = −k₂x₂ − c₂ẋ₂ + F                          (1)
///   F = k₁ δ|δ|ᵃ + c₁ δ̇ |δ|ᵇ where positive, else 0; δ = x₁ − x₂    (2)
///   k₂ = (2π f_hoop)² m₂                                         (3)
/// A contact cannot pull: it ends when the force falls to zero, which happens before the overlap is zero.
/// source  [8] in docs/theory/sources.md, 4.4 and appendix D
/// theory (10.1), (10.2), (10.3)
struct Trampoline {
  double ball_mass_kg = 0.145;         // m₁
  double stiffness = 60e6;             // k₁, N/m^(1 + a)
  double damping = 5000;               // c₁, N s/m^(1 + b)
  double stiffness_exponent = 0.6495;  // a
  double damping_exponent = 0.5202;    // b, below 1 + a: otherwise the dashpot would never release the ball
  double barrel_mass_kg = 0.090;       // m₂
  double barrel_damping_Nspm = 90.5;   // c₂
  double extra_mass_kg = 0;            // moves with the barrel; the spring (3) does not depend on it
  double ball_speed_mps = 60.80;       // towards the barrel
};

Trampoline baseball_on_barrel();
Trampoline softball_on_barrel();

/// The rebound of the ball.
struct Rebound {
  double cor = 0;            // speed away from the barrel / speed towards it, after the last contact
  double first_cor = 0;      // the same after the first contact; negative where the ball still moves inwards
  double contact_s = 0;      // from the first touch to the end of the last contact
  std::size_t contacts = 1;  // number of contacts
};

/// Solves (1) to (3) to 1e-10 of the ball's speed, until the barrel can no longer reach the ball.
/// errors  InputError after a million steps, or where the constants leave no finite result.
Rebound rebound(const Trampoline& model, double hoop_Hz);

/// The same for a rigid barrel.
Rebound rigid_wall_rebound(const Trampoline& model);

struct HoopPeak {
  double hoop_Hz = 0, cor = 0;
  bool at_edge = false;  // at the first or last frequency of the sweep: a larger COR may lie outside
};

/// Computes the rebound at each of `hoop_Hz`, `threads` as in parallel_for.
std::vector<Rebound> hoop_sweep(const Trampoline& model, const std::vector<double>& hoop_Hz, std::size_t threads = 0);

/// The hoop frequency with the largest COR: bracketed_maximum near the best of the sweep.
/// shapes  hoop_Hz ascending, sweep of the same length
HoopPeak optimal_hoop_frequency(const Trampoline& model, const std::vector<double>& hoop_Hz,
                                const std::vector<Rebound>& sweep);

/// The hoop frequency with the extra mass on the barrel: f √(m₂/(m₂ + Δm)).                           (4)
/// theory (10.4)
double loaded_hoop_Hz(const Trampoline& model, double hoop_Hz);

/// (4) solved for m₂: the modal mass whose frequency falls from free_Hz to loaded_Hz with the added mass.
double modal_mass_kg(double added_kg, double free_Hz, double loaded_Hz);

}  // namespace percuss::model
