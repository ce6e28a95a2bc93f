#include "model/bat/bat_modes.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "model/bat/lowest_modes.hpp"

namespace percuss::model {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int kIntervalsPerElement = 4;  // each is searched for a change of sign
constexpr double kAtRest = 1e-7;         // of the largest deflection: less is rounding of a part that does not move
constexpr double kAtSupport = 1e-9;      // of the length

double about_support_kgm2(const BatModes& modes) {
  const double arm_m = modes.support.at_m - modes.inertia.cm_m;
  return modes.inertia.inertia_kgm2 + modes.inertia.mass_kg * arm_m * arm_m;
}

// Slopes of the rigid-body modes.
Eigen::Vector2d rigid_slope(const BatModes& modes) {
  const Eigen::Vector2d there = modes.rigid_deflection(1), origin = modes.rigid_deflection(0);
  return there - origin;
}

Index rigid_count(BeamSupport support) { return static_cast<Index>(rigid_body_modes(support)); }

// The rigid-body modes in the unknowns of the beam. shape [unknowns, rigid-body modes].
Eigen::MatrixXd rigid_shapes(const BatModes& modes) {
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(modes.beam.mass.rows(), 2);
  const Eigen::Vector2d slope = rigid_slope(modes);
  Index row = 0;
  for (const double z_m : positions_of(modes.beam)) {
    rigid.row(row) = modes.rigid_deflection(z_m).transpose();
    rigid.row(row + 1) = slope.transpose();
    row += kUnknownsPerElement;
  }
  return rigid.rightCols(rigid_count(modes.support.kind));
}

// An estimate of the lowest ω²: a uniform beam with the mean of 1/EI.
double lowest_square_estimate(const BatModes& modes) {
  double compliance = 0;
  for (const BeamElement& e : modes.beam.elements) compliance += e.element_length_m / e.bending_Nm2;
  const double unit = 1 / (compliance * modes.inertia.mass_kg * modes.length_m * modes.length_m);
  if (rigid_count(modes.support.kind) > 0) return 500 * unit;  // 4.73⁴ = 500.6
  const double cantilever = 12.4 * unit;                       // 1.875⁴
  if (modes.support.kind == BeamSupport::clamped) return cantilever;
  return std::min(cantilever, modes.support.torsion_Nmprad / about_support_kgm2(modes));
}

// Converts matrices between all unknowns of a beam and its free ones (not in `fixed`).
class FreeUnknowns {
 public:
  explicit FreeUnknowns(const TimoshenkoBeam& beam) : reduced_(static_cast<std::size_t>(beam.mass.rows()), 0) {
    for (const Index fixed : beam.fixed) reduced_[static_cast<std::size_t>(fixed)] = -1;
    for (Index& unknown : reduced_) {
      if (unknown == 0) unknown = count_++;
    }
  }

  Sparse reduced(const Sparse& full) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(full.nonZeros()));
    for (Index column = 0; column < full.outerSize(); ++column) {
      for (Sparse::InnerIterator at(full, column); at; ++at) {
        if (index(at.row()) >= 0 && index(column) >= 0)
          entries.emplace_back(index(at.row()), index(column), at.value());
      }
    }
    Sparse out(count_, count_);
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
  }
  Eigen::MatrixXd reduced(const Eigen::MatrixXd& full) const {
    Eigen::MatrixXd out(count_, full.cols());
    for (Index row = 0; row < full.rows(); ++row) {
      if (index(row) >= 0) out.row(index(row)) = full.row(row);
    }
    return out;
  }
  Eigen::MatrixXd expanded(const Eigen::MatrixXd& some) const {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(std::ssize(reduced_), some.cols());
    for (Index row = 0; row < out.rows(); ++row) {
      if (index(row) >= 0) out.row(row) = some.row(index(row));
    }
    return out;
  }

 private:
  Index index(Index full) const { return reduced_[static_cast<std::size_t>(full)]; }

  std::vector<Index> reduced_;  // index among the free unknowns; −1: fixed
  Index count_ = 0;
};

}  // namespace

Eigen::VectorXd BatModes::deflection(double z_m) const {
  const std::size_t at = element_at(beam, z_m);
  const BeamElement& e = beam.elements[at];
  const ElementVector weights = e.deflection((z_m - e.start_m) / e.element_length_m);
  return shape.middleRows<6>(kUnknownsPerElement * static_cast<Eigen::Index>(at)).transpose() * weights;
}

Eigen::Vector2d BatModes::rigid_deflection(double z_m) const {
  if (support.kind == BeamSupport::free)
    return {1 / std::sqrt(inertia.mass_kg), (z_m - inertia.cm_m) / std::sqrt(inertia.inertia_kgm2)};
  if (support.kind == BeamSupport::pinned) return {0, (z_m - support.at_m) / std::sqrt(about_support_kgm2(*this))};
  return {0, 0};
}

double BatModes::rigid_accelerance_per_kg(double z_m) const {
  if (support.kind != BeamSupport::torsion) return rigid_deflection(z_m).squaredNorm();
  const double arm_m = z_m - support.at_m;
  return arm_m * arm_m / about_support_kgm2(*this);
}

BatModes bat_modes(const BeamStructure& structure, const BatModesOptions& options) {
  BatModes modes{.beam = timoshenko_beam(structure, structure.length_m() * options.max_element_fraction),
                 .inertia = {},
                 .support = structure.support,
                 .length_m = structure.length_m(),
                 .freq_Hz = {},
                 .shape = {}};
  modes.inertia = inertia_of(modes.beam);
  const FreeUnknowns unknowns(modes.beam);
  const LowestModes lowest = lowest_modes(unknowns.reduced(modes.beam.stiffness), unknowns.reduced(modes.beam.mass),
                                          unknowns.reduced(rigid_shapes(modes)), lowest_square_estimate(modes),
                                          static_cast<Index>(options.modes));
  modes.freq_Hz = lowest.square.cwiseSqrt() / kTwoPi;
  modes.shape = unknowns.expanded(lowest.shape);
  return modes;
}

BatModes bat_modes(const BatProfile& profile, const BatMaterial& material, const BatModesOptions& options) {
  return bat_modes(structure_of(profile, material), options);
}

std::vector<double> nodes_of(const BatModes& modes, std::size_t mode) {
  const auto shape = modes.shape.col(static_cast<Eigen::Index>(mode));
  const double rest = kAtRest * shape(Eigen::seq(0, Eigen::last, kUnknownsPerElement)).cwiseAbs().maxCoeff();
  const bool held = modes.support.kind != BeamSupport::free;
  std::vector<double> nodes;
  Index first = 0;
  for (const BeamElement& e : modes.beam.elements) {
    const ElementVector unknowns = shape.segment<6>(first);
    first += kUnknownsPerElement;
    const auto at = [&](double x) { return e.deflection(x).dot(unknowns); };
    for (int i = 0; i < kIntervalsPerElement; ++i) {
      const double low = static_cast<double>(i) / kIntervalsPerElement, high = (i + 1.0) / kIntervalsPerElement;
      if ((at(low) < 0) == (at(high) < 0) || std::max(std::abs(at(low)), std::abs(at(high))) < rest) continue;
      const double node_m = e.start_m + e.element_length_m * bracketed_root(at, low, high);
      if (held && std::abs(node_m - modes.support.at_m) <= kAtSupport * modes.length_m) continue;
      nodes.push_back(node_m);
    }
  }
  return nodes;
}

}  // namespace percuss::model
