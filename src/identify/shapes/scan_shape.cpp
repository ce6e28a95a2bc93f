#include "identify/shapes/scan_shape.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/math/decompositions.hpp"
#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMinScanNoise = 1e-12;  // of the largest residue: lower limit of a standard deviation

// A mode's residues over [points, channels] with their standard deviations, and the gain error common to a point's
// channels.
struct ResidueTable {
  std::vector<double> position_m;
  MatrixXcd value;
  MatrixXd std;
  VectorXd relative_std;  // [points]
};

ResidueTable table_of(const Mode& mode, std::span<const int> point, std::span<const double> position_m) {
  std::size_t channels = 0;
  for (const Residue& r : mode.residues) channels = std::max(channels, r.channel + 1);
  const auto rows = static_cast<Index>(point.size());
  const auto columns = static_cast<Index>(channels);
  ResidueTable all{.position_m = {},
                   .value = MatrixXcd(rows, columns),
                   .std = MatrixXd(rows, columns),
                   .relative_std = VectorXd(rows)};
  Index row = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    std::size_t seen = 0;
    for (const Residue& r : mode.residues) {
      if (static_cast<int>(r.point) != point[i]) continue;
      all.value(row, static_cast<Index>(r.channel)) = r.value;
      all.std(row, static_cast<Index>(r.channel)) = r.std;
      all.relative_std(row) = r.relative_std;
      ++seen;
    }
    if (seen != channels) continue;
    all.position_m.push_back(position_m[i]);
    ++row;
  }
  all.value.conservativeResize(row, columns);
  all.std.conservativeResize(row, columns);
  all.relative_std.conservativeResize(row);
  return all;
}

VectorXd channel_weights(const ResidueTable& table) {
  VectorXd weight(table.value.cols());
  for (Index c = 0; c < weight.size(); ++c) {
    const VectorXd column = table.std.col(c);
    const double typical = median({column.data(), column.data() + column.size()});
    weight(c) = 1 / std::max(typical, std::max(kMinScanNoise * table.value.cwiseAbs().maxCoeff(), 1e-300));
  }
  return weight;
}

// The projection of the residues on their first right singular vector.
struct Projection {
  VectorXd weight;           // [channels] by which the residues are multiplied first
  VectorXcd channel_vector;  // [channels] the singular vector
  VectorXcd projected;       // [points]
  Complex rotation;          // makes `projected` as real as possible
  double scale = 1;          // to the channel with the largest residues
};

Projection projection_of(const ResidueTable& table) {
  Projection out{.weight = channel_weights(table), .channel_vector = {}, .projected = {}, .rotation = {}};
  const MatrixXcd scaled = table.value * out.weight.cast<Complex>().asDiagonal();
  out.channel_vector = leading_right_vector(scaled);
  out.projected = scaled * out.channel_vector;
  // Σ a² has twice the phase of the best line through the values a.
  out.rotation = std::polar(1.0, -0.5 * std::arg((out.projected.array() * out.projected.array()).sum()));
  if ((out.rotation * out.projected(0)).real() < 0) out.rotation = -out.rotation;
  out.scale = out.channel_vector.cwiseAbs().cwiseQuotient(out.weight).maxCoeff();
  return out;
}

}  // namespace

ScanShape shape_along(const Mode& mode, std::span<const int> point, std::span<const double> position_m) {
  assert(point.size() == position_m.size());
  const ResidueTable table = table_of(mode, point, position_m);
  if (table.value.size() == 0) return {};
  ScanShape shape{.position_m = table.position_m, .amplitude = {}, .std = {}};
  const Projection by = projection_of(table);
  for (Index p = 0; p < by.projected.size(); ++p) {
    const double noise =
        (table.std.row(p).transpose().array() * by.weight.array() * by.channel_vector.cwiseAbs().array())
            .matrix()
            .norm();
    shape.amplitude.push_back((by.rotation * by.projected(p)).real() * by.scale);
    shape.std.push_back(std::hypot(noise * by.scale, table.relative_std(p) * shape.amplitude.back()));
  }
  return shape;
}

std::vector<Complex> channel_factors(const Mode& mode, std::span<const int> point, std::span<const double> position_m) {
  const ResidueTable table = table_of(mode, point, position_m);
  if (table.value.size() == 0) return {};
  const Projection by = projection_of(table);
  std::vector<Complex> factors;
  for (Index c = 0; c < by.weight.size(); ++c)
    factors.push_back(by.rotation * by.weight(c) * by.channel_vector(c) * by.scale);
  return factors;
}

}  // namespace percuss::identify
