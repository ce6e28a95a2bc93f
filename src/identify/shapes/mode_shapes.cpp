#include "identify/shapes/mode_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/decompositions.hpp"

namespace percuss::identify {
namespace {

constexpr int kShapeSweeps = 20;  // of the rank-one fit; from the singular vector, it converges in a few

// The residues as a matrix with weights 1/σ²; 0 where not measured.
struct Grid {
  std::vector<std::size_t> points, channels;
  Eigen::MatrixXcd value;
  Eigen::MatrixXd weight;
  Eigen::VectorXd relative_std;  // [points] of the gain common to a point's residues
};

Grid grid_of(const Mode& mode) {
  std::set<std::size_t> points, channels;
  double largest = 0;
  for (const Residue& r : mode.residues) {
    points.insert(r.point);
    channels.insert(r.channel);
    largest = std::max(largest, std::abs(r.value));
  }
  Grid grid{.points = {points.begin(), points.end()}, .channels = {channels.begin(), channels.end()}};
  const auto rows = static_cast<Eigen::Index>(points.size()), columns = static_cast<Eigen::Index>(channels.size());
  grid.value = Eigen::MatrixXcd::Zero(rows, columns);
  grid.weight = Eigen::MatrixXd::Zero(rows, columns);
  grid.relative_std = Eigen::VectorXd::Zero(rows);
  const double least = 1e-12 * largest;  // exact residues have equal weights
  for (const Residue& r : mode.residues) {
    const auto row = std::distance(points.begin(), points.find(r.point));
    const auto column = std::distance(channels.begin(), channels.find(r.channel));
    grid.value(row, column) = r.value;
    const double std = std::max(r.std, least);
    grid.weight(row, column) = std > 0 ? 1 / (std * std) : 1;
    grid.relative_std(row) = r.relative_std;
  }
  return grid;
}

// A ≈ a bᵀ by alternating least squares, |b| = 1.
struct RankOne {
  Eigen::VectorXcd a, b;
  Eigen::VectorXd a_std, b_std;
};

Eigen::VectorXcd solve_side(const Eigen::MatrixXcd& value, const Eigen::MatrixXd& weight, const Eigen::VectorXcd& other,
                            Eigen::VectorXd& std) {
  Eigen::VectorXcd out = Eigen::VectorXcd::Zero(value.rows());
  std = Eigen::VectorXd::Zero(value.rows());
  for (Eigen::Index i = 0; i < value.rows(); ++i) {
    Complex sum;
    double power = 0;
    for (Eigen::Index k = 0; k < value.cols(); ++k) {
      sum += weight(i, k) * std::conj(other(k)) * value(i, k);
      power += weight(i, k) * std::norm(other(k));
    }
    if (!(power > 0)) continue;
    out(i) = sum / power;
    std(i) = 1 / std::sqrt(power);
  }
  return out;
}

RankOne rank_one(const Grid& grid) {
  RankOne fit;
  fit.b = leading_right_vector(grid.value).conjugate();
  fit.a = solve_side(grid.value, grid.weight, fit.b, fit.a_std);
  if (grid.channels.size() == 1) {  // the value of a single sensor is part of the shape's scale
    fit.b_std = Eigen::VectorXd::Zero(1);
    return fit;
  }
  for (int sweep = 0; sweep < kShapeSweeps; ++sweep) {
    fit.b = solve_side(grid.value.transpose(), grid.weight.transpose(), fit.a, fit.b_std);
    const double size = fit.b.norm();
    if (!(size > 0)) break;
    fit.b /= size;
    fit.b_std /= size;
    fit.a = solve_side(grid.value, grid.weight, fit.b, fit.a_std);
  }
  return fit;
}

void scale(std::vector<ShapePlace>& places, Complex by) {
  for (ShapePlace& place : places) {
    place.value *= by;
    place.std *= std::abs(by);
  }
}

double collinearity(const std::vector<ShapePlace>& places) {
  double xx = 0, yy = 0, xy = 0;
  for (const ShapePlace& place : places) {
    xx += place.value.real() * place.value.real();
    yy += place.value.imag() * place.value.imag();
    xy += place.value.real() * place.value.imag();
  }
  const double sum = xx + yy;
  return sum > 0 ? ((xx - yy) * (xx - yy) + 4 * xy * xy) / (sum * sum) : 0;
}

const ShapePlace* largest_place(const std::vector<ShapePlace>& places) {
  const auto most = std::max_element(places.begin(), places.end(), [](const ShapePlace& a, const ShapePlace& b) {
    return std::norm(a.value) < std::norm(b.value);
  });
  return most == places.end() ? nullptr : &*most;
}

void normalise_largest(ModeShape& shape) {
  shape.normalisation = Normalisation::largest_one;
  const Complex turn = turn_of(shape.places);
  scale(shape.places, turn);
  scale(shape.sensors, 1.0 / turn);  // keeps A_pc = φ_p φ_c
  const ShapePlace* most = largest_place(shape.places);
  if (most == nullptr || most->value.real() == 0) return;
  const double by = 1 / most->value.real();
  scale(shape.places, by);
  scale(shape.sensors, 1 / by);
}

// Scales to unit modal mass by the driving point with the most significant residue; false where no residue clearly has
// the sign of its driving point.
bool normalise_mass(ModeShape& shape, const Mode& mode, const ShapeOptions& options) {
  const Residue* best = nullptr;
  Complex square;  // φ_d² of the best one
  for (const DrivingPoint& at : options.driving) {
    const Residue* r = find_residue(mode, at.point, at.channel);
    if (r == nullptr || !(at.sign * r->value.real() > kSignificant * total_std(*r))) continue;
    if (best != nullptr && at.sign * r->value.real() * total_std(*best) <= square.real() * total_std(*r)) continue;
    best = r;
    square = at.sign * r->value;
  }
  if (best == nullptr) return false;
  const bool hammer = options.roving == Roving::hammer;
  const auto at = std::find_if(shape.places.begin(), shape.places.end(), [&](const ShapePlace& p) {
    return p.point == best->point && (hammer || p.channel == best->channel);
  });
  if (at == shape.places.end() || at->value == Complex()) return false;
  const Complex by = std::sqrt(square) / at->value;  // the root with positive real part
  scale(shape.places, by);
  scale(shape.sensors, 1.0 / by);
  at->sets_scale = true;
  shape.normalisation = Normalisation::unit_modal_mass;
  shape.scale_std = 0.5 * total_std(*best) / std::abs(best->value);
  const ShapePlace* most = largest_place(shape.places);
  shape.modal_mass_kg = 1 / std::norm(most->value);
  const double of_largest = most->sets_scale ? 0 : most->std / std::abs(most->value);
  shape.modal_mass_std_kg = 2 * *shape.modal_mass_kg * std::hypot(shape.scale_std, of_largest);
  return true;
}

// By the noise alone: a gain that scatters between the hits does not make a motion doubtful.
double significance(const Mode& mode) {
  double sum = 0;
  for (const Residue& r : mode.residues)
    sum += r.std > 0 ? std::norm(r.value) / (2 * r.std * r.std) : 1e12;  // two real values
  return mode.residues.empty() ? 0 : std::sqrt(sum / static_cast<double>(mode.residues.size()));
}

void place_by_hammer(ModeShape& shape, const Grid& grid) {
  const RankOne fit = rank_one(grid);
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double std = std::hypot(fit.a_std(row), grid.relative_std(row) * std::abs(fit.a(row)));
    shape.places.push_back({.point = grid.points[i], .value = fit.a(row), .std = std});
  }
  for (std::size_t c = 0; c < grid.channels.size(); ++c) {
    const auto row = static_cast<Eigen::Index>(c);
    shape.sensors.push_back({.channel = grid.channels[c], .value = fit.b(row), .std = fit.b_std(row)});
  }
}

}  // namespace

const Residue* find_residue(const Mode& mode, std::size_t point, std::size_t channel) {
  const auto found = std::find_if(mode.residues.begin(), mode.residues.end(),
                                  [&](const Residue& r) { return r.point == point && r.channel == channel; });
  return found == mode.residues.end() ? nullptr : &*found;
}

Complex turn_of(const std::vector<ShapePlace>& places) {
  Complex squares;
  for (const ShapePlace& place : places) squares += place.value * place.value;
  return std::polar(1.0, -0.5 * std::arg(squares));
}

double total_std(const Residue& r) { return std::hypot(r.std, r.relative_std * std::abs(r.value)); }

const char* name_of(Normalisation normalisation) {
  return normalisation == Normalisation::unit_modal_mass ? "unit_modal_mass" : "largest_one";
}

ModeShape shape_of(const Mode& mode, const ShapeOptions& options) {
  ModeShape shape;
  if (mode.residues.empty()) return shape;
  if (options.roving == Roving::hammer) {
    place_by_hammer(shape, grid_of(mode));
  } else {
    for (const Residue& r : mode.residues)
      shape.places.push_back({.point = r.point, .channel = r.channel, .value = r.value, .std = total_std(r)});
    std::sort(shape.places.begin(), shape.places.end(), [](const ShapePlace& a, const ShapePlace& b) {
      return std::pair(a.point, a.channel) < std::pair(b.point, b.channel);
    });
  }
  if (!normalise_mass(shape, mode, options)) normalise_largest(shape);
  shape.mpc = collinearity(shape.places);
  shape.significance = significance(mode);
  return shape;
}

RankOneResidual rank_one_residual(const Mode& mode) {
  RankOneResidual out;
  const Grid grid = grid_of(mode);
  if (grid.points.size() < 2 || grid.channels.size() < 2) return out;
  const RankOne fit = rank_one(grid);
  const Eigen::MatrixXcd rest = grid.value - fit.a * fit.b.transpose();
  out.chi2 = (grid.weight.array() * rest.array().abs2()).sum();
  out.freedom = 2 * (static_cast<double>(mode.residues.size()) - static_cast<double>(grid.points.size()) -
                     static_cast<double>(grid.channels.size()) + 1);
  const Eigen::VectorXd singular = singular_values(grid.value);
  if (singular(0) > 0) out.second_singular = singular(1) / singular(0);
  return out;
}

}  // namespace percuss::identify
