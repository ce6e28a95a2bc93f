#include "identify/hits/hit_poles.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/complex.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/fit/joint_fit.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"
#include "identify/hits/mode_windows.hpp"
#include "identify/model/close_poles.hpp"
#include "identify/model/frf_lines.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMaxUncertainty = 0.5;  // of half-power bandwidth and damping ratio: beyond it the pole is unknown
// F statistic of a mode over the fits of all hits: in noise, a search for a mode reaches 6.
constexpr double kMinModeGain = 12;
// Of the data, or of the largest noise: the weight of an FRF without residual stays finite.
constexpr double kMinNoise = 1e-9;
constexpr std::size_t kFlopsPerLine = 600;  // of a window's projection, per line

// [channels] rms of the residual per line.
VectorXd noise_of(const ProjectedState& state, const std::vector<VectorXcd>& data, double freedom) {
  VectorXd noise(static_cast<Index>(data.size()));
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      const double rms = std::sqrt(part.residual.col(static_cast<Index>(i)).squaredNorm() / freedom);
      noise(static_cast<Index>(o)) = std::max({rms, kMinNoise * data[o].norm() / std::sqrt(freedom), 1e-300});
    }
  }
  return noise;
}

// [hits] energy of the residual over the noise.
std::vector<double> residual_energies(const ProjectedState& state, const HitFrfs& hits, const VectorXd& noise) {
  std::vector<double> energies(hits.points.size());
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      energies[hits.set.channels[o].point] +=
          part.residual.col(static_cast<Index>(i)).squaredNorm() / std::pow(noise(static_cast<Index>(o)), 2);
    }
  }
  return energies;
}

HitPole hit_pole(const Pole& pole, double freq_std_Hz, double damping_std, const Pole& start) {
  const bool known = std::isfinite(freq_std_Hz) && std::isfinite(damping_std) &&
                     freq_std_Hz < kMaxUncertainty * start.half_power_Hz() &&
                     damping_std < kMaxUncertainty * start.damping_ratio &&
                     std::abs(pole.freq_Hz - start.freq_Hz) < start.half_power_Hz() && pole.damping_ratio > 0;
  return {.pole = pole, .freq_std_Hz = freq_std_Hz, .damping_std = damping_std, .known = known};
}

void step_window(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes, const ModeWindow& window,
                 const std::vector<Mode>& modes_in_hits, std::vector<HitPoles>& out) {
  const std::vector<Pole> poles = window.poles(modes);
  const auto data = hit_data(set, hits, modes, window, modes_in_hits);
  const std::size_t terms = LocalFitOptions{}.residual_terms;
  VariableProjection projection(hits.set, data, VectorXd::Ones(static_cast<Index>(data.size())), window.first,
                                window.count, terms);
  const ProjectedState state = projection.evaluate(poles);
  const double freedom = std::max(1.0, static_cast<double>(window.count) - static_cast<double>(poles.size() + terms));
  const VectorXd noise = noise_of(state, data, freedom);
  projection.set_noise_scale(noise);
  const auto normal = projection.normal_equations_by_point(state, poles.size());
  const std::vector<double> energies = residual_energies(state, hits, noise);
  const HitResidues residues(set, hits, modes, window, state, freedom);
  std::vector<std::vector<ResidueRatio>> ratios;                  // [window.modes][hits]
  std::vector<std::vector<std::vector<HitResidue>>> of_channels;  // [window.modes][hits][channels]
  for (std::size_t i = 0; i < poles.size(); ++i) {
    ratios.push_back(residues.ratios(i));
    of_channels.push_back(residues.residues(i, ratios.back()));
    out[window.modes[i]].differs_from_previous =
        i > 0 && are_close(poles[i - 1], poles[i]) && scatter_clearly(residues.contrasts(i - 1, i));
  }
  const std::size_t channels = data.size() / hits.points.size();
  for (std::size_t h = 0; h < hits.points.size(); ++h) {
    const Eigen::MatrixXd inverse = inverse_gram(normal[h].matrix);
    const VectorXd step = inverse * normal[h].right;
    const double degrees =
        std::max(1.0, 2 * freedom * static_cast<double>(channels) - 2 * static_cast<double>(poles.size()));
    const double left = energies[h] - step.dot(normal[h].right);
    for (std::size_t i = 0; i < poles.size(); ++i) {
      const auto f = static_cast<Index>(2 * i);
      const double scale = std::max(left, 0.0) / degrees;
      const Pole moved{.freq_Hz = poles[i].freq_Hz + step(f), .damping_ratio = poles[i].damping_ratio + step(f + 1)};
      const double floor_Hz = kRounding * moved.freq_Hz, floor = kRoundingDamping * poles[i].damping_ratio;
      out[window.modes[i]].hits[h] = hit_pole(moved, std::hypot(std::sqrt(scale * inverse(f, f)), floor_Hz),
                                              std::hypot(std::sqrt(scale * inverse(f + 1, f + 1)), floor), poles[i]);
      out[window.modes[i]].hits[h].residue_ratio = ratios[i][h];
      out[window.modes[i]].hits[h].residues = std::move(of_channels[i][h]);
    }
  }
}

HitPole pole_of_fit(const LocalFit& fit, std::size_t mode, const Pole& start) {
  const auto m = static_cast<Index>(mode);
  HitPole out = hit_pole(fit.poles[mode], std::hypot(fit.freq_std_Hz(m), kRounding * start.freq_Hz),
                         std::hypot(fit.damping_std(m), kRoundingDamping * start.damping_ratio), start);
  out.known = out.known && fit.converged;
  return out;
}

// [channels] noise scales from the residual of a fit.
VectorXd noise_scales_of(const LocalFit& fit) { return fit.noise.cwiseMax(kMinNoise * fit.noise.maxCoeff() + 1e-300); }

LocalFit fit_by_residual(const FrfDataset& set, const std::vector<VectorXcd>& data, const std::vector<Pole>& start,
                         const ModeWindow& window) {
  const LocalFitOptions options{.first = window.first, .count = window.count};
  const VectorXd ones = VectorXd::Ones(static_cast<Index>(data.size()));
  return fit_locally(set, data, noise_scales_of(fit_locally(set, data, ones, start, options)), start, options);
}

// A separate fit of each hit, started at these poles: the sums of the costs and of the degrees of freedom.
struct HitCosts {
  double cost = 0, degrees = 0;
};
HitCosts costs_of_hits(const HitFrfs& hits, const std::vector<VectorXcd>& data,
                       const std::vector<VectorXd>& noise_scales, const std::vector<Pole>& poles,
                       const ModeWindow& window) {
  const std::size_t channels = data.size() / hits.points.size();
  HitCosts sum;
  for (std::size_t h = 0; h < hits.points.size(); ++h) {
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(h * channels);
    const LocalFit fit =
        fit_locally(set_of_point(hits.set, h).set, {first, first + static_cast<std::ptrdiff_t>(channels)},
                    noise_scales[h], poles, {.first = window.first, .count = window.count});
    sum.cost += fit.cost;
    sum.degrees += static_cast<double>(fit.degrees);
  }
  return sum;
}

// The sum of squares where all hits have these poles.
double common_cost(const HitFrfs& hits, const std::vector<VectorXcd>& data, const std::vector<VectorXd>& noise_scales,
                   const std::vector<Pole>& poles, const ModeWindow& window) {
  VectorXd all(static_cast<Index>(data.size()));
  Index next = 0;
  for (const VectorXd& of_hit : noise_scales) {
    all.segment(next, of_hit.size()) = of_hit;
    next += of_hit.size();
  }
  const std::size_t terms = LocalFitOptions{}.residual_terms;
  return VariableProjection(hits.set, data, all, window.first, window.count, terms).evaluate(poles).cost;
}

std::vector<VectorXd> noise_scales_of_hits(const HitFrfs& hits, const std::vector<VectorXcd>& data,
                                           const std::vector<Pole>& poles, const ModeWindow& window) {
  const std::size_t channels = data.size() / hits.points.size();
  std::vector<VectorXd> noise_scales;
  for (std::size_t h = 0; h < hits.points.size(); ++h) {
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(h * channels);
    const std::vector<VectorXcd> own{first, first + static_cast<std::ptrdiff_t>(channels)};
    noise_scales.push_back(noise_scales_of(fit_by_residual(set_of_point(hits.set, h).set, own, poles, window)));
  }
  return noise_scales;
}

}  // namespace

std::vector<HitPoles> linearised_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                           const std::vector<ModeWindow>& windows,
                                           const std::vector<Mode>& modes_in_hits) {
  std::vector<HitPoles> out(modes.size(), HitPoles{.hits = std::vector<HitPole>(hits.points.size())});
  const std::size_t lines = windows.empty() ? 0 : windows.front().count;
  parallel_for_cost(windows.size(), kFlopsPerLine * lines * hits.accel.size(),
                    [&](std::size_t w) { step_window(set, hits, modes, windows[w], modes_in_hits, out); });
  return out;
}

std::vector<HitPoles> fitted_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                       const ModeWindow& window, const std::vector<Mode>& modes_in_hits) {
  const std::vector<Pole> start = window.poles(modes);
  const auto fit = [&](const FrfDataset& of, const std::vector<VectorXcd>& data) {
    return fit_by_residual(of, data, start, window);
  };
  std::vector<HitPoles> out(start.size(), HitPoles{.hits = std::vector<HitPole>(hits.points.size())});
  const auto averages = window_data(set, modes, window);
  for (HitPoles& of_mode : out) of_mode.averages.resize(set.points.size());
  if (!has_repeated_points(hits.points)) {
    const LocalFit all = fit(set, averages);
    for (std::size_t i = 0; i < start.size(); ++i)
      std::fill(out[i].averages.begin(), out[i].averages.end(), pole_of_fit(all, i, start[i]));
  } else {
    parallel_for_cost(set.points.size(), 20 * kFlopsPerLine * window.count, [&](std::size_t p) {
      const PointSet point = set_of_point(set, p);
      std::vector<VectorXcd> own;
      for (const std::size_t o : point.channels) own.push_back(averages[o]);
      const LocalFit one = fit(point.set, own);
      for (std::size_t i = 0; i < start.size(); ++i) out[i].averages[p] = pole_of_fit(one, i, start[i]);
    });
  }
  const auto data = hit_data(set, hits, modes, window, modes_in_hits);
  const std::size_t channels = data.size() / hits.points.size();
  parallel_for_cost(hits.points.size(), 20 * kFlopsPerLine * window.count * channels, [&](std::size_t h) {
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(h * channels);
    const LocalFit one = fit(set_of_point(hits.set, h).set, {first, first + static_cast<std::ptrdiff_t>(channels)});
    for (std::size_t i = 0; i < start.size(); ++i) out[i].hits[h] = pole_of_fit(one, i, start[i]);
  });
  return out;
}

bool has_repeated_points(const std::vector<std::size_t>& points) {
  const std::set<std::size_t> different(points.begin(), points.end());
  return different.size() < points.size();
}

std::vector<Mode> modes_with_residues_of_hits(const FrfDataset& set, const HitFrfs& hits,
                                              const std::vector<Mode>& modes, const std::vector<HitPoles>& linear) {
  const auto scatters = [&](const HitPoles& poles) {
    std::vector<ResidueRatio> ratios;
    for (const HitPole& hit : poles.hits) ratios.push_back(hit.residue_ratio);
    return scatter_clearly(ratios, hits.points);
  };
  if (std::none_of(linear.begin(), linear.end(), scatters)) return {};
  FrfDataset each = hits.set;  // the FRFs of the single hits
  for (std::size_t o = 0; o < each.channels.size(); ++o) {
    const Complex* force = each.points[each.channels[o].point].spectra.front().get();
    each.channels[o].frf.resize(each.lines.count);
    for (std::size_t k = 0; k < each.lines.count; ++k)
      each.channels[o].frf[k] = conj_times(force[k], hits.accel[o][k]) * (1 / std::norm(force[k]));
  }
  std::vector<Pole> poles;
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  const Eigen::MatrixXcd residues = residues_at(each, poles);
  std::vector<Mode> out = modes;
  const std::vector<std::size_t> residue_of = residue_indices(set, hits);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    out[m].residues.clear();
    for (std::size_t o = 0; o < residue_of.size(); ++o) {
      out[m].residues.push_back(modes[m].residues[residue_of[o]]);
      out[m].residues.back().value = residues(static_cast<Index>(o), static_cast<Index>(m));
    }
  }
  return out;
}

std::vector<std::size_t> modes_from_hit_scatter(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                const std::vector<Mode>& modes_in_hits) {
  std::vector<std::size_t> imitating, left = window.modes;
  std::vector<Pole> poles = window.poles(modes);
  if (poles.size() < 2) return imitating;
  const auto data = hit_data(set, hits, modes, window, modes_in_hits);
  const std::vector<VectorXd> noise_scales = noise_scales_of_hits(hits, data, poles, window);
  HitCosts with = costs_of_hits(hits, data, noise_scales, poles, window);
  const double common = common_cost(hits, data, noise_scales, poles, window);
  while (poles.size() > 1 && with.degrees > 0) {
    std::size_t least = poles.size();
    double least_f = kMinModeGain;
    HitCosts least_costs;
    for (std::size_t i = 0; i < poles.size(); ++i) {
      std::vector<Pole> fewer = poles;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      const HitCosts without = costs_of_hits(hits, data, noise_scales, fewer, window);
      const double f = (without.cost - with.cost) / (without.degrees - with.degrees) / (with.cost / with.degrees);
      if (!(f < least_f && without.cost < common)) continue;
      least = i;
      least_f = f;
      least_costs = without;
    }
    if (least == poles.size()) break;
    imitating.push_back(left[least]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(least));
    poles.erase(poles.begin() + static_cast<std::ptrdiff_t>(least));
    with = least_costs;
  }
  return imitating;
}

}  // namespace percuss::identify
