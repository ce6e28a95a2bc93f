#include "identify/hits/drift_removal.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/complex.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr std::size_t kMinDrifting = 3;
constexpr double kAlike = 0.2;                // of the median drift
constexpr double kMinPartAlike = 0.75;        // of the drifting modes
constexpr std::size_t kFlopsPerColumn = 100;  // of a mode's column, per line

// Hits from the middle of the test, [hits].
std::vector<double> hits_from_middle(std::size_t hits) {
  std::vector<double> from;
  for (std::size_t h = 0; h < hits; ++h) from.push_back(static_cast<double>(h) - 0.5 * static_cast<double>(hits - 1));
  return from;
}

// [modes] the column of each mode at its pole in a hit minus the column at its mean pole.
std::vector<VectorXcd> changed_columns(const FrfDataset& set, const PointForce& force, const std::vector<Mode>& modes,
                                       double change) {
  std::vector<VectorXcd> out;
  out.reserve(modes.size());
  for (const Mode& mode : modes) {
    Pole moved = mode.pole;
    moved.freq_Hz *= 1 + change;
    const auto column = [&](const Pole& pole) {
      return mode_column(pole, force, set.lines, 0, set.lines.count, ColumnContent::value).value;
    };
    out.emplace_back(column(moved) - column(mode.pole));
  }
  return out;
}

}  // namespace

std::optional<DriftTrend> common_drift(const std::vector<Mode>& modes) {
  std::vector<double> change;
  for (const Mode& mode : modes)
    if (mode.drift) change.push_back(mode.drift->freq_change_per_hit);
  if (change.size() < kMinDrifting) return std::nullopt;
  const double middle = median(change);
  double weights = 0, sum = 0;
  std::size_t alike = 0;
  for (const Mode& mode : modes) {
    if (!mode.drift || std::abs(mode.drift->freq_change_per_hit - middle) > kAlike * std::abs(middle)) continue;
    const double weight = 1 / (mode.drift->std * mode.drift->std);
    weights += weight;
    sum += weight * mode.drift->freq_change_per_hit;
    ++alike;
  }
  if (static_cast<double>(alike) < kMinPartAlike * static_cast<double>(change.size()) || !std::isfinite(sum / weights))
    return std::nullopt;
  return DriftTrend{.freq_change_per_hit = sum / weights, .std = 1 / std::sqrt(weights)};
}

SteadyTest without_drift(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                         double change_per_hit) {
  SteadyTest steady{.set = set, .hits = hits, .spectra = {}};
  for (const auto& accel : hits.accel) steady.spectra.emplace_back(accel.begin(), accel.end());
  steady.hits.accel.assign(steady.spectra.begin(), steady.spectra.end());
  const std::vector<double> from_middle = hits_from_middle(hits.points.size());
  const std::vector<std::size_t> residue_of = residue_indices(set, hits);
  std::vector<std::vector<std::size_t>> of_hit(hits.points.size());
  for (std::size_t o = 0; o < hits.set.channels.size(); ++o) of_hit[hits.set.channels[o].point].push_back(o);
  std::vector<std::vector<std::size_t>> of_point(set.points.size());
  for (std::size_t h = 0; h < hits.points.size(); ++h) of_point[hits.points[h]].push_back(h);
  const std::size_t lines = set.lines.count;
  parallel_for_cost(of_point.size(), kFlopsPerColumn * lines * modes.size(), [&](std::size_t p) {
    std::vector<double> power(lines);  // Σ|F|² of the point's hits
    for (const std::size_t h : of_point[p]) {
      const Complex* const force = hits.set.points[h].spectra.front().get();
      for (std::size_t k = 0; k < lines; ++k) power[k] += std::norm(force[k]);
    }
    for (const std::size_t h : of_point[p]) {
      const PointForce& own = hits.set.points[h];
      const Complex* const force = own.spectra.front().get();
      const auto columns = changed_columns(set, own, modes, change_per_hit * from_middle[h]);
      for (const std::size_t o : of_hit[h]) {
        VectorXcd change = VectorXcd::Zero(static_cast<Index>(lines));
        for (std::size_t m = 0; m < modes.size(); ++m) change += modes[m].residues[residue_of[o]].value * columns[m];
        FrfChannel& average = steady.set.channels[residue_of[o]];
        for (std::size_t k = 0; k < lines; ++k) {
          const Complex of_line = change(static_cast<Index>(k));
          steady.spectra[o][k] -= force[k] * of_line;
          if (power[k] > 0) average.frf[k] -= of_line * (std::norm(force[k]) / power[k]);
        }
      }
    }
  });
  return steady;
}

void describe_common_drift(const DriftTrend& drift, std::size_t hits, const std::vector<Mode>& before,
                           std::vector<Mode>& modes) {
  const auto n = static_cast<double>(hits);
  const double spread = std::abs(drift.freq_change_per_hit) * std::sqrt(n * (n + 1) / 12);  // of the orders 1 … n
  for (Mode& mode : modes) {
    mode.drift = drift;
    mode.freq_std_parts_Hz.hits = std::max(mode.freq_std_parts_Hz.hits, spread * mode.pole.freq_Hz);
    mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
    const auto apart_Hz = [&](const Mode& other) { return std::abs(other.pole.freq_Hz - mode.pole.freq_Hz); };
    const auto nearest = std::min_element(before.begin(), before.end(),
                                          [&](const Mode& a, const Mode& b) { return apart_Hz(a) < apart_Hz(b); });
    if (nearest == before.end() || apart_Hz(*nearest) > mode.pole.half_power_Hz()) continue;
    mode.hit_scatter_Hz = nearest->hit_scatter_Hz;
    mode.hit_scatter_freq_p = nearest->hit_scatter_freq_p;
  }
}

}  // namespace percuss::identify
