#include "identify/hits/residue_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/significance.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

// Normal deviates of χ²: of all points of a mode together, and of one point alone, as a survey has hundreds of points
// and modes.
constexpr double kSignificantTogether = kOnceIn1000, kSignificantAlone = kOnceIn300000;
constexpr double kRoundingRatio = 1e-9;  // of a ratio without noise
constexpr double kMaxShare = 0.99;       // of the weight of a hit's ratio: such a residue alone decides the ratio
constexpr double kClearDirection = 5;    // standard deviations of a residue whose phase is known

// One value per hit, with the weights of the hits in an average of FRFs.
struct HitValues {
  std::vector<double> value, std, power;
  ScatterOfHits scatter() const { return value.size() < 2 ? ScatterOfHits{} : scatter_of_hits(value, std); }
};

// The standard deviation of the averaged residue from the scatter, relative to the residue.
double std_of_average(const HitValues& values, double spread) {
  double sum = 0, squares = 0;
  for (const double power : values.power) {
    sum += power;
    squares += power * power;
  }
  const double degrees = static_cast<double>(values.value.size()) - 1;
  return sum > 0 ? student_factor(degrees) * spread * std::sqrt(squares) / sum : 0;
}

// [points] the relative standard deviations of one mode's residues from the scatter. Where the points together
// scatter significantly, the scatter of each counts. One point that scatters does not make the others doubtful.
std::vector<double> scatter_of_points(const std::vector<HitValues>& points) {
  std::vector<ScatterOfHits> scatter;
  double sum = 0, count = 0;
  for (const HitValues& point : points) {
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

// The direction in the complex plane along which most of the energy of a mode's residues lies; its sign is arbitrary.
Complex common_direction(const Mode& mode) {
  Complex doubled;
  for (const Residue& residue : mode.residues) doubled += residue.value * residue.value;
  return std::abs(doubled) > 0 ? std::sqrt(doubled / std::abs(doubled)) : Complex(1);
}

// Adds the scatter that differs between the channels to the residues' standard deviations. It is the scatter of the
// hit's residue minus the hit's ratio times the residue of the test, along the phase of the latter; theory (4.30).
void add_scatter_of_channels(const HitFrfs& hits, const HitPoles& poles, std::size_t line, Mode& mode) {
  const Complex common = common_direction(mode);
  std::vector<HitValues> deviations_from_ratio(mode.residues.size());  // [residues], 1/kg
  std::map<std::size_t, std::vector<std::size_t>> of_points;
  for (std::size_t h = 0; h < poles.hits.size(); ++h) {
    const HitPole& hit = poles.hits[h];
    if (!(hit.residue_ratio.weight > 0)) continue;
    for (const HitResidue& one : hit.residues) {
      const Residue& mean = mode.residues[one.residue];
      const bool clear = std::abs(mean.value) > kClearDirection * mean.std;
      const Complex along = clear ? mean.value / std::abs(mean.value) : common;
      HitValues& at = deviations_from_ratio[one.residue];
      if (one.share > kMaxShare) continue;
      at.value.push_back((std::conj(along) * (one.value - hit.residue_ratio.value() * mean.value)).real());
      at.std.push_back(one.std * std::sqrt(1 - one.share));
      at.power.push_back(hits.set.points[h].ff[line]);
      auto& members = of_points[hits.points[h]];
      if (std::find(members.begin(), members.end(), one.residue) == members.end()) members.push_back(one.residue);
    }
  }
  double sum = 0, count = 0;
  for (const auto& [point, members] : of_points) {
    double deviates = 0, measured = 0;
    for (const std::size_t r : members) {
      if (deviations_from_ratio[r].value.size() < 2) continue;
      deviates += std::min(deviations_from_ratio[r].scatter().deviate, kSignificantAlone);
      ++measured;
    }
    if (!(measured > 0)) continue;
    sum += deviates / measured;  // the channels of a point depend on each other
    ++count;
  }
  const bool all = count > 0 && sum > kSignificantTogether * std::sqrt(count);
  for (std::size_t r = 0; r < deviations_from_ratio.size(); ++r) {
    if (deviations_from_ratio[r].value.size() < 2) continue;
    const ScatterOfHits scatter = deviations_from_ratio[r].scatter();
    if (all || scatter.deviate > kSignificantAlone)
      mode.residues[r].std = std::hypot(mode.residues[r].std, std_of_average(deviations_from_ratio[r], scatter.spread));
  }
}

}  // namespace

void add_residue_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                         std::vector<Mode>& modes) {
  for (std::size_t m = 0; m < linear.poles.size(); ++m) {
    Mode& mode = modes[m];
    const std::size_t line = set.lines.nearest(mode.pole.freq_Hz);
    std::vector<HitValues> points(set.points.size());
    for (std::size_t h = 0; h < hits.points.size(); ++h) {
      const ResidueRatio& ratio = linear.poles[m].hits[h].residue_ratio;
      if (!(ratio.weight > 0)) continue;
      HitValues& at = points[hits.points[h]];
      at.value.push_back(ratio.value());
      at.std.push_back(
          std::hypot(std::sqrt(1 / ratio.weight), gain_amplitude_std(hits.set, h, mode.pole.freq_Hz), kRoundingRatio));
      at.power.push_back(hits.set.points[h].ff[line]);
    }
    add_scatter_of_channels(hits, linear.poles[m], line, mode);
    const std::vector<double> scatter = scatter_of_points(points);
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      Residue& residue = mode.residues[o];
      residue.relative_std = std::hypot(residue.relative_std, scatter[set.channels[o].point]);
    }
  }
}

}  // namespace percuss::identify
