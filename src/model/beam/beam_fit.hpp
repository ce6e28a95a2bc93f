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
  double std_Hz = 0;  // 0: not known; then of none
};

struct FittedParameter {
  BeamParameter which = BeamParameter::stiffness;
  double value = 0;
  std::optional<double> std;  // none when there are no more frequencies than parameters, and no deviations of theirs
};

struct BeamFit {
  UniformBeam beam;  // with the fitted values in it
  std::vector<FittedParameter> parameters;
  std::vector<double> model_Hz;  // beside the measured ones
  bool at_limit = false;         // T* ran to 1e-6 or 1e6: as good as no spring or a clamp, and T is not determined
  double chi2 = 0;               // Σ ((ln f − ln f_model) f/σ)²; σ = f where it is not known
};

/// How many of the three may be fitted at once: frequencies depend on EI/ρA and on T* = T L/EI alone, without a spring
/// (of no or boundless stiffness too) on the first of them.
std::size_t max_beam_parameters(BeamSupport support);

/// Fits what is asked for, with the rest of `beam` as it is: least squares on the logarithms of frequencies and
/// parameters (Marquardt), started from the best of a range of T*. Deviations from the frequencies' own where these are
/// known; else from what the fit leaves, with equal relative deviations assumed.
/// Preconditions: no rigid-body mode; one parameter to max_beam_parameters, each once, the torsion only with a spring;
/// at least as many frequencies.
BeamFit fit_beam(const UniformBeam& beam, const std::vector<BeamParameter>& asked,
                 const std::vector<MeasuredFrequency>& measured);

/// A load across the beam at a distance from the spring, and the deflection that it makes there.
struct StaticReading {
  double load_N = 0, lever_m = 0, deflection_m = 0;
};

struct TorsionFit {
  double torsion_Nmprad = 0;
  std::optional<double> std_Nmprad;  // of several readings
};

/// The spring's stiffness from static readings, the beam's own bending accounted for:
///   d = P a²/T + P a³/(3 EI)                                                   (1)
/// by least squares on 1/T. errors  InputError when the bending alone, or more, is what was read.
/// theory (8.10)
TorsionFit fit_torsion(const std::vector<StaticReading>& readings, double stiffness_Nm2);

}  // namespace percuss::model
