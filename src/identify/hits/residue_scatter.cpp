#include "identify/hits/residue_scatter.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

// Normal deviates of χ²: of all points of a mode together (without scatter, one mode in 1000 exceeds it), and of one
// point alone (one in 300,000, as a survey has hundreds of points and modes).
constexpr double kSignificantTogether = 3.1, kSignificantAlone = 4.5;
constexpr double kRoundingRatio = 1e-9;  // of a ratio without noise

// The ratios of the hits at one point, with their weights in an average of FRFs.
struct PointRatios {
  std::vector<double> value, std, power;
  ScatterOfHits scatter() const { return value.size() < 2 ? ScatterOfHits{} : scatter_of_hits(value, std); }
};

// The standard deviation of the averaged residue from the scatter, relative to the residue.
double std_of_average(const PointRatios& ratios, double spread) {
  double sum = 0, squares = 0;
  for (const double power : ratios.power) {
    sum += power;
    squares += power * power;
  }
  return sum > 0 ? student_factor(ratios.value.size() - 1) * spread * std::sqrt(squares) / sum : 0;
}

// [points] the relative standard deviations of one mode's residues from the scatter. Where the points
// together scatter significantly, the scatter of each counts. One point that scatters does not make the others
// doubtful.
std::vector<double> scatter_of_points(const std::vector<PointRatios>& points) {
  std::vector<ScatterOfHits> scatter;
  double sum = 0, count = 0;
  for (const PointRatios& point : points) {
    scatter.push_back(point.scatter());
    if (point.value.size() < 2) continue;
    sum += std::min(scatter.back().deviate, kSignificantAlone);
    ++count;
  }
  const bool all = count > 0 && sum > kSignificantTogether * std::sqrt(count);
  std::vector<double> std(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].value.size() > 1 && (all || scatter[p].deviate > kSignificantAlone))
      std[p] = std_of_average(points[p], scatter[p].spread);
  }
  return std;
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
          std::hypot(std::sqrt(1 / ratio.weight), gain_amplitude_std(hits.set, h, mode.pole.freq_Hz), kRoundingRatio));
      at.power.push_back(hits.set.points[h].ff[line]);
    }
    const std::vector<double> scatter = scatter_of_points(points);
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      Residue& residue = mode.residues[o];
      residue.relative_std = std::hypot(residue.relative_std, scatter[set.channels[o].point]);
    }
  }
}

}  // namespace percuss::identify
