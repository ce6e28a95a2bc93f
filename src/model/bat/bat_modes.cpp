#include "model/bat/bat_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "model/bat/lowest_modes.hpp"

namespace percuss::model {
namespace {

constexpr int kIntervalsPerElement = 4;  // each is searched for a change of sign

// The rigid-body modes in the unknowns of the beam. shape [unknowns, 2].
Eigen::MatrixXd rigid_shapes(const BatModes& modes) {
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(modes.beam.mass.rows(), 2);
  Eigen::Index row = 0;
  for (const double z_m : positions_of(modes.beam)) {
    rigid.row(row) = modes.rigid_deflection(z_m).transpose();
    rigid(row + 1, 1) = 1 / std::sqrt(modes.inertia.inertia_kgm2);
    row += kUnknownsPerElement;
  }
  return rigid;
}

// An estimate of the lowest ω²: a uniform beam with the mean of 1/EI.
double lowest_square_estimate(const BatModes& modes) {
  double compliance = 0;
  for (const BeamElement& e : modes.beam.elements) compliance += e.element_length_m / e.bending_Nm2;
  return 500 / (compliance * modes.inertia.mass_kg * modes.length_m * modes.length_m);  // 4.73⁴ = 500.6
}

}  // namespace

Eigen::VectorXd BatModes::deflection(double z_m) const {
  const std::size_t at = element_at(beam, z_m);
  const BeamElement& e = beam.elements[at];
  const ElementVector weights = e.deflection((z_m - e.start_m) / e.element_length_m);
  return shape.middleRows<6>(kUnknownsPerElement * static_cast<Eigen::Index>(at)).transpose() * weights;
}

Eigen::Vector2d BatModes::rigid_deflection(double z_m) const {
  return {1 / std::sqrt(inertia.mass_kg), (z_m - inertia.cm_m) / std::sqrt(inertia.inertia_kgm2)};
}

BatModes bat_modes(const BatProfile& profile, const BatMaterial& material, const BatModesOptions& options) {
  BatModes modes{.beam = timoshenko_beam(profile, material, profile.length_m() * options.max_element_fraction),
                 .inertia = inertia_of(profile, material),
                 .length_m = profile.length_m(),
                 .freq_Hz = {},
                 .shape = {}};
  LowestModes lowest = lowest_modes(modes.beam.stiffness, modes.beam.mass, rigid_shapes(modes),
                                    lowest_square_estimate(modes), static_cast<Eigen::Index>(options.modes));
  modes.freq_Hz = lowest.square.cwiseSqrt() / kTwoPi;
  modes.shape = std::move(lowest.shape);
  return modes;
}

std::vector<double> nodes_of(const BatModes& modes, std::size_t mode) {
  const auto shape = modes.shape.col(static_cast<Eigen::Index>(mode));
  std::vector<double> nodes;
  Eigen::Index first = 0;
  for (const BeamElement& e : modes.beam.elements) {
    const ElementVector unknowns = shape.segment<6>(first);
    first += kUnknownsPerElement;
    const auto at = [&](double x) { return e.deflection(x).dot(unknowns); };
    for (int i = 0; i < kIntervalsPerElement; ++i) {
      const double low = static_cast<double>(i) / kIntervalsPerElement, high = (i + 1.0) / kIntervalsPerElement;
      if ((at(low) < 0) == (at(high) < 0)) continue;
      nodes.push_back(e.start_m + e.element_length_m * bracketed_root(at, low, high));
    }
  }
  return nodes;
}

}  // namespace percuss::model
