#include "pipeline/stages/hit_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/math/assignment.hpp"
#include "identify/hits/hit_scatter.hpp"

namespace percuss::pipeline {
namespace {

// Cost of a mode that a hit does not show: equal to √2 bandwidths off, or to 1 bandwidth off with unlike residues.
constexpr double kGap = 2;
constexpr double kSignificantScatter = 2.3;  // normal deviate of χ²; without scatter, one value in 100 exceeds it
constexpr double kDoubling = 0.7;            // of a damping ratio, in nepers: costs as much as one bandwidth

// The squared difference of the residues at a point over their squared size: 0 for equal residues, at most 1. Unlike a
// MAC, it compares amplitudes too, because the shape at one channel says nothing.
double residue_distance(const identify::Mode& test, const identify::Mode& hit, int point) {
  double apart = 0, size = 0;
  for (const identify::Residue& own : hit.residues) {
    for (const identify::Residue& known : test.residues) {
      if (known.point != static_cast<std::size_t>(point) || known.channel != own.channel) continue;
      apart += std::norm(own.value - known.value);
      size += std::norm(own.value) + std::norm(known.value);
    }
  }
  return size > 0 ? std::min(1.0, apart / size) : 0;
}

double cost_of(const identify::Mode& test, const identify::Mode& hit, int point) {
  const double width_Hz = std::max({test.pole.half_power_Hz(), hit.pole.half_power_Hz(), 3 * hit.freq_std_Hz});
  const double moved = (hit.pole.freq_Hz - test.pole.freq_Hz) / width_Hz;
  const double damped = std::log(hit.pole.damping_ratio / test.pole.damping_ratio) / kDoubling;
  return moved * moved + damped * damped + residue_distance(test, hit, point);
}

// The scatter of one quantity of a mode between its hits, beyond the noise; 0 where it is not significant.
double scatter_between(const std::vector<HitMode*>& hits, double identify::Pole::*value, HitStdParts HitMode::*parts) {
  std::vector<double> values, stds;
  for (const HitMode* hit : hits) {
    values.push_back(hit->pole.*value);
    stds.push_back((hit->*parts).noise);
  }
  if (values.size() < 2 || *std::min_element(stds.begin(), stds.end()) <= 0) return 0;
  const identify::ScatterOfHits scatter = identify::scatter_of_hits(values, stds);
  return scatter.deviate > kSignificantScatter ? scatter.spread : 0;
}

void add_scatter(std::size_t modes, std::vector<HitMode>& found) {
  for (std::size_t m = 0; m < modes; ++m) {
    std::vector<HitMode*> hits;
    for (HitMode& one : found) {
      if (one.mode == m) hits.push_back(&one);
    }
    const double freq_Hz = scatter_between(hits, &identify::Pole::freq_Hz, &HitMode::freq_std_parts_Hz);
    const double damping = scatter_between(hits, &identify::Pole::damping_ratio, &HitMode::damping_std_parts);
    for (HitMode* hit : hits) {
      hit->freq_std_parts_Hz.hits = freq_Hz;
      hit->damping_std_parts.hits = damping;
    }
  }
}

}  // namespace

double HitStdParts::total() const { return std::hypot(noise, hits); }

std::vector<HitMode> modes_of_hits(const std::vector<identify::Mode>& modes, const std::vector<HitOfPoint>& hits,
                                   const std::function<identify::FrfDataset(std::size_t hit)>& dataset_of,
                                   identify::Effort effort) {
  std::vector<identify::Pole> poles;
  poles.reserve(modes.size());
  for (const identify::Mode& mode : modes) poles.push_back(mode.pole);
  std::vector<HitMode> out;
  if (modes.empty()) return out;
  for (const HitOfPoint& at : hits) {
    const auto found = identify::modes_from_poles(dataset_of(at.hit), poles, effort);
    Eigen::MatrixXd cost(static_cast<Eigen::Index>(modes.size()), static_cast<Eigen::Index>(found.size()));
    for (Eigen::Index m = 0; m < cost.rows(); ++m) {
      for (Eigen::Index k = 0; k < cost.cols(); ++k)
        cost(m, k) = cost_of(modes[static_cast<std::size_t>(m)], found[static_cast<std::size_t>(k)], at.point);
    }
    const auto partner = assign_rows(cost, kGap);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (!partner[m]) continue;
      const identify::Mode& mode = found[*partner[m]];
      out.push_back({.hit = at.hit,
                     .mode = m,
                     .pole = mode.pole,
                     .freq_std_parts_Hz = {.noise = mode.freq_std_Hz},
                     .damping_std_parts = {.noise = mode.damping_std}});
    }
  }
  add_scatter(modes.size(), out);
  return out;
}

}  // namespace percuss::pipeline
