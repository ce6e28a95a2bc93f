#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "model/bat/structure_fit.hpp"

namespace percuss::tools {

/// The options of a fit to measured frequencies.
struct FrequencyFitFlags {
  std::vector<std::string> names;
  std::vector<double> measured_Hz, measured_std_Hz;
  std::vector<std::size_t> measured_modes;

  bool any() const {
    return !names.empty() || !measured_Hz.empty() || !measured_std_Hz.empty() || !measured_modes.empty();
  }
};

/// `names` of the parameters that can be fitted; `numbers` is the help text of --measured-modes.
void add_frequency_fit_flags(Command& command, FrequencyFitFlags& flags, const std::vector<std::string>& names,
                             const char* numbers);

/// The measured frequencies with their modes; `first` is the number of the first elastic mode. Throws OptionError where
/// the options contradict each other, and where there are fewer frequencies than parameters.
std::vector<model::MeasuredMode> measured_modes(const FrequencyFitFlags& flags, std::size_t first);

/// The parameters of a bat or beam with a table of sections, out of young, shear, density, torsion and added-mass.
/// Throws OptionError for a parameter that the structure does not have, and for one named twice.
/// total_mass  whether the total mass is given: the density then follows from it, and cannot be fitted
std::vector<model::StructureParameter> structure_parameters(const FrequencyFitFlags& flags,
                                                            const model::BeamStructure& structure, bool total_mass);

}  // namespace percuss::tools
