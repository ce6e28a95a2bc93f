#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"

namespace percuss::model {

enum class BeamParameter { stiffness, torsion, mass_per_length };

struct MeasuredFrequency {
  std::size_t mode = 0;  // of beam_modes, not a rigid-body one
  double freq_Hz = 0;
  double std_Hz = 0;  // 0: unknown; then unknown for all frequencies
};

struct FittedParameter {
  BeamParameter which = BeamParameter::stiffness;
  double value = 0;
  std::optional<double> std;  // needs std_Hz, or more frequencies than parameters
};

struct BeamFit {
  UniformBeam beam;  // with the fitted values
  std::vector<FittedParameter> parameters;
  std::vector<double> model_Hz;  // the model's frequency for each measured one
  bool at_limit = false;  // T* is below 1e-5 or above 1e5: the spring acts as a pin or a clamp, and T is not determined
  double chi2 = 0;        // Σ ((ln f − ln f_model) f/σ)²; σ = f where it is unknown
};

/// The number of parameters that can be fitted together. Frequencies depend only on EI/ρA and T* = T L/EI, and without
/// a spring (or with one of zero or infinite stiffness) only on EI/ρA.
std::size_t max_beam_parameters(BeamSupport support);

/// Fits `parameters` of `beam` to measured frequencies, by least squares (Levenberg–Marquardt) on the logarithms of
/// frequencies and parameters. The start is the best of the values of `beam` and of a range of T*. Standard deviations
/// follow from std_Hz where it is known, times birge_ratio() of chi2; otherwise from the residuals, with equal relative
/// deviations of the frequencies assumed. Preconditions: no rigid-body mode; 1 to max_beam_parameters different
/// parameters, the torsion only with a spring; at least as many frequencies as parameters.
BeamFit fit_beam(const UniformBeam& beam, const std::vector<BeamParameter>& parameters,
                 const std::vector<MeasuredFrequency>& measured);

/// A transverse load at a distance from the spring, and the deflection under it.
struct StaticReading {
  double load_N = 0, lever_m = 0, deflection_m = 0;
};

struct TorsionFit {
  double torsion_Nmprad = 0;
  std::optional<double> std_Nmprad;  // needs two readings or more
};

/// Fits the stiffness of the spring to static readings by least squares on 1/T, with the bending of the beam included:
///   d = P a²/T + P a³/(3 EI)                                                   (1)
/// errors  InputError when bending alone explains the deflections or exceeds them.
/// theory (8.10)
TorsionFit fit_torsion(const std::vector<StaticReading>& readings, double stiffness_Nm2);

}  // namespace percuss::model
