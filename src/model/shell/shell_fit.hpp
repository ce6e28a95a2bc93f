#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/shell/shell.hpp"

namespace percuss::model {

/// A measured hoop frequency: n waves around, m half-waves along.
struct MeasuredHoop {
  std::size_t n = 2, m = 1;
  double freq_Hz = 0, freq_std_Hz = 0;
};

enum class ShellUnknowns : std::uint8_t { young, wall, both };

/// Modulus and wall that explain measured hoop frequencies; a deviation of 0 for what was given.
struct ShellFit {
  TubeShell shell;  // with what was found
  double young_std_Pa = 0, wall_std_m = 0;
  double correlation = 0;  // of the two
  double chi2 = 0;         // Σ ((f − model)/σ)²
  std::vector<double> model_Hz;
};

/// Weighted least squares of Flügge's frequencies over ln E and ln h, from `shell` on; its outer diameter, length and
/// the other constants stay. Every frequency goes like √E, and in bending like h: what tells E from h is that patterns
/// stretch the wall by different amounts, most for small n and large m.
/// errors  InputError: fewer frequencies than unknowns; E and h cannot be told apart (alike patterns, deviations above
/// half their value); nothing fits.
ShellFit fit_shell(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns);

}  // namespace percuss::model
