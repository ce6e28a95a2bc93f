#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/shell/shell.hpp"

namespace percuss::model {

/// A measured hoop frequency: n waves around the tube, m half-waves along it.
struct MeasuredHoop {
  std::size_t n = 2, m = 1;
  double freq_Hz = 0, freq_std_Hz = 0;
};

enum class ShellUnknowns : std::uint8_t { young, wall, both };

/// Modulus and wall fitted to measured hoop frequencies. A value that is not fitted has a standard deviation of 0.
struct ShellFit {
  TubeShell shell;  // with the fitted values
  double young_std_Pa = 0, wall_std_m = 0;
  double correlation = 0;  // of modulus and wall
  double chi2 = 0;         // Σ ((f − model)/σ)²
  std::vector<double> model_Hz;
};

/// Fits ln E and ln h to Flügge's frequencies by weighted least squares (Levenberg–Marquardt). `shell` is the start and
/// holds all other constants. Every frequency is proportional to √E. Where the wall bends without stretching, it is
/// also proportional to h. E and h differ in their effect only because patterns stretch the wall by different amounts,
/// most for small n and large m. The standard deviations follow from freq_std_Hz, times birge_ratio() of chi2.
/// errors  InputError: fewer frequencies than unknowns; a standard deviation above half the value (patterns that do not
/// separate E from h, or uncertain frequencies); no convergence.
ShellFit fit_shell(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns);

}  // namespace percuss::model
