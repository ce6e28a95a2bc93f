#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/bat/beam_structure.hpp"

namespace percuss::model {

enum class StructureParameter {
  young,    // of the beam's own material
  shear,    // shear modulus × shape factor of that material
  density,  // of that material
  torsion,  // stiffness of the spring
  mass      // the last added mass
};

struct MeasuredMode {
  std::size_t elastic = 0;  // index of an elastic mode, from 0
  double freq_Hz = 0;
  double std_Hz = 0;  // 0: unknown. Either all frequencies have one, or none
};

struct FittedStructureParameter {
  StructureParameter which = StructureParameter::young;
  double value = 0;
  std::optional<double> std{};  // needs std_Hz, or more frequencies than parameters
};

struct StructureFitOptions {
  std::optional<double> total_mass_kg{};   // held: the density follows from it at every trial
  double max_element_fraction = 1.0 / 84;  // as in BatModesOptions
};

struct StructureFit {
  BeamStructure structure;  // with the fitted values
  std::vector<FittedStructureParameter> parameters;
  std::vector<double> model_Hz;  // of each measured mode
  double chi2 = 0;               // Σ ((ln f − ln f_model) f/σ)²; σ = f where it is unknown
};

/// Fits `parameters` to measured frequencies by least squares (Levenberg–Marquardt) on the logarithms of frequencies
/// and parameters, as fit_beam does. The values of `structure` are the start. A spring has several starts, up to four
/// decades softer and stiffer; the best fit is kept. Standard deviations follow from std_Hz if it is known, times
/// birge_ratio() of chi2; otherwise from the residuals.
/// Preconditions: different parameters; at least as many frequencies as parameters; the values that are fitted are
/// above zero, the torsion only with a spring, the mass only with an added mass.
/// errors  InputError where the frequencies do not determine the parameters.
StructureFit fit_structure(const BeamStructure& structure, const std::vector<StructureParameter>& parameters,
                           const std::vector<MeasuredMode>& measured, const StructureFitOptions& options = {});

}  // namespace percuss::model
