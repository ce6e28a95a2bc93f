#include "identify/hits/residue_scatter.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

constexpr double kSignificantRatios = 3.1;  // normal deviate of χ²: without scatter, one value in 1000 exceeds it
constexpr double kRoundingRatio = 1e-9;      // of a ratio without noise

// The ratios of the hits at one point, with what their mean weights are in an average of FRFs.
struct PointRatios {
  std::vector<double> value, std, power;
};

// The standard deviation of the averaged residue from the scatter, relative to the residue.
double scatter_of_average(const PointRatios& ratios) {
  if (ratios.value.size() < 2) return 0;
  const ScatterOfHits scatter = scatter_of_hits(ratios.value, ratios.std);
  if (!(scatter.deviate > kSignificantRatios)) return 0;
  double sum = 0, squares = 0;
  for (const double power : ratios.power) {
    sum += power;
    squares += power * power;
  }
  if (!(sum > 0)) return 0;
  return student_factor(ratios.value.size() - 1) * scatter.spread * std::sqrt(squares) / sum;
}

}  // namespace

void add_residue_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                         std::vector<Mode>& modes) {
  for (std::size_t m = 0; m < linear.poles.size(); ++m) {
    Mode& mode = modes[m];
    const std::size_t line = set.lines.nearest(mode.pole.freq_Hz);
    std::vector<PointRatios> points(set.points.size());
    for (std::size_t h = 0; h < hits.points.size(); ++h) {
      const ResidueRatio& ratio = linear.poles[m].hits[h].residue_ratio;
      if (!(ratio.weight > 0)) continue;
      PointRatios& at = points[hits.points[h]];
      at.value.push_back(ratio.value());
      at.std.push_back(
          std::hypot(std::sqrt(1 / ratio.weight), gain_std(hits.set, h, mode.pole.freq_Hz), kRoundingRatio));
      at.power.push_back(hits.set.points[h].ff[line]);
    }
    std::vector<double> scatter;
    scatter.reserve(points.size());
    for (const PointRatios& at : points) scatter.push_back(scatter_of_average(at));
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      Residue& residue = mode.residues[o];
      residue.relative_std = std::hypot(residue.relative_std, scatter[set.channels[o].point]);
    }
  }
}

}  // namespace percuss::identify
