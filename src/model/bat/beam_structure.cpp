#include "model/bat/beam_structure.hpp"

#include "core/error.hpp"
#include "model/bat/timoshenko_elements.hpp"

namespace percuss::model {
namespace {

constexpr double kMassElements = 84;  // as bat_modes: where a wall reaches the axis, the mass depends on the elements

}  // namespace

double density_for_mass(const BeamStructure& structure, double total_kg) {
  const auto mass_with = [&](double density_kgpm3) {
    BeamStructure trial = structure;
    trial.material.density_kgpm3 = density_kgpm3;
    return inertia_of(timoshenko_beam(trial, trial.length_m() / kMassElements)).mass_kg;
  };
  const double fixed_kg = mass_with(0), volume_m3 = (mass_with(1000) - fixed_kg) / 1000;
  if (!(volume_m3 > 0)) {
    throw InputError("every layer has a density of its own", "total mass", "leave out the total mass or a density",
                     {"total_mass"});
  }
  if (!(total_kg > fixed_kg)) {
    throw InputError("the added masses and the layers with a density weigh as much or more", "total mass",
                     "check the masses in kg and the densities in kg/m³", {"total_mass", "add_mass"});
  }
  return (total_kg - fixed_kg) / volume_m3;  // (1)
}

}  // namespace percuss::model
