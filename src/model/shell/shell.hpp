#pragma once
#include <cstddef>

namespace percuss::model {

/// A barrel as a tube of constant wall thickness. R = (outer diameter − wall)/2 is its mean radius.
struct TubeShell {
  double outer_diameter_m = 0.066675;  // 2.625 in
  double wall_m = 0.00254;             // 0.100 in; below half the diameter
  double length_m = 0.3302;            // 13 in
  double young_Pa = 70e9;
  double density_kgpm3 = 2700;
  double poisson = 0.33;  // below 1/2

  double radius_m() const { return (outer_diameter_m - wall_m) / 2; }
};

// Natural frequencies of the pattern with n >= 2 waves around the tube.
// h is the wall, k = h²/(12 R²), Ω = ωR√(ρ(1 − ν²)/E).

/// Ring: the tube's section bends in its plane.
///   ω² = E h²/(12 ρ R⁴) · n²(n² − 1)²/(n² + 1)                                                  (1)
/// theory (13.1)
double ring_Hz(const TubeShell& shell, std::size_t n);

/// Rayleigh: a tube with free ends bends without stretching, with the same deflection along its length.
///   Ω² = k n²(n² − 1)²/(n² + 1)                                                                 (2)
/// theory (13.2)
double rayleigh_Hz(const TubeShell& shell, std::size_t n);

/// Love: as Rayleigh, but the deflection is odd about the middle and grows linearly from it.
///   Ω² = (2) · [1 + 24(1 − ν) R²/(n² L²)] / [1 + 12 R²/(n²(n² + 1) L²)]                         (3)
/// theory (13.3)
double love_Hz(const TubeShell& shell, std::size_t n);

/// Flügge: a thin shell on shear diaphragms (its ends stay round and slide axially), with m half-waves along it.
/// Ω² is the lowest eigenvalue of the symmetric matrix S, with λ = mπR/L:
///   S11 = λ² + (1 − ν)/2 n²(1 + k)          S12 = −(1 + ν)/2 nλ
///   S13 = −νλ − k(λ³ − (1 − ν)/2 n²λ)       S22 = n² + (1 − ν)/2 λ²(1 + 3k)
///   S23 = n + k (3 − ν)/2 λ²n               S33 = 1 + k((λ² + n²)² − 2n² + 1)                   (4)
/// For a long tube (4) becomes (2). It exceeds three-dimensional elasticity by 0.4 to 0.5 % (n = 2) and 1 % (n = 3)
/// for a wall of R/13. For half that wall the excess is a quarter to a half as large.
/// source  [15] in docs/theory/sources.md
/// theory (13.4)
double flugge_Hz(const TubeShell& shell, std::size_t n, std::size_t m);

/// The mass of the tube, ρ π (D − h) h L. Source [8] takes the mass of a tube, shorter than the barrel, as the barrel's
/// effective mass m₂.
double tube_mass_kg(const TubeShell& shell);

}  // namespace percuss::model
