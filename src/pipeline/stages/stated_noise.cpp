#include "pipeline/stages/stated_noise.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/math/significance.hpp"
#include "core/units.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "pipeline/stages/stated_scatter.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;

constexpr double kNoiseReach = 2;            // half-power bandwidths on each side of a mode
constexpr std::size_t kMinNoiseReach = 100;  // lines on each side, over which the joint fit takes the noise
constexpr double kMinFreedom = 2;            // lines
constexpr double kSignificantVariance = 2;   // standard deviations
constexpr double kMinDeviate = 3.8;          // of the χ² of the residual below the stated variance: 1 in 10 000
constexpr double kMinVariance = 1e-300;

struct NoiseWindow {
  std::size_t first = 0, end = 0;  // lines
};

NoiseWindow noise_window_around(const identify::Mode& mode, const acquire::LineRange& lines) {
  const std::size_t middle = lines.nearest(mode.pole.freq_Hz);
  const auto reach = std::max(
      kMinNoiseReach, static_cast<std::size_t>(std::ceil(kNoiseReach * mode.pole.half_power_Hz() / lines.df_Hz())));
  return {.first = middle - std::min(middle, reach), .end = std::min(lines.count, middle + reach + 1)};
}

// [lines of the window] how the FRF changes with the residue and with the pole of a mode.
struct ModeChanges {
  Eigen::VectorXcd residue, pole;
};

ModeChanges changes_with(const identify::Pole& pole, const acquire::LineRange& lines, double decay_per_s,
                         const NoiseWindow& window) {
  const double omega = kTwoPi * pole.freq_Hz;
  const Complex lambda = omega * Complex(-pole.damping_ratio, std::sqrt(1 - pole.damping_ratio * pole.damping_ratio));
  const auto count = static_cast<Index>(window.end - window.first);
  ModeChanges changes{.residue = Eigen::VectorXcd(count), .pole = Eigen::VectorXcd(count)};
  for (Index k = 0; k < count; ++k) {
    const Complex s(decay_per_s, kTwoPi * lines.freq_Hz(window.first + static_cast<std::size_t>(k)));
    const Complex column = s * s / ((s - lambda) * omega);
    changes.residue(k) = column;
    changes.pole(k) = column * omega / (s - lambda);
  }
  return changes;
}

// [lines of the window] how much the noise of each line moves the pole: |∂H/∂λ|², without the part of ∂H/∂λ that the
// residue and a constant absorb. The sum is 1.
Eigen::VectorXd influence_of_lines(const ModeChanges& changes) {
  Eigen::MatrixXcd absorbed(changes.pole.size(), 2);
  absorbed << changes.residue, Eigen::VectorXcd::Ones(changes.pole.size());
  const Eigen::VectorXcd change = changes.pole - absorbed * absorbed.colPivHouseholderQr().solve(changes.pole);
  const Eigen::VectorXd influence = change.cwiseAbs2();
  return influence / std::max(influence.sum(), kMinVariance);
}

// The noise of the lines that move the pole.
struct NoiseAtMode {
  double stated = 0;    // stated variance; 0 where none is stated
  double residual = 0;  // the variance that the residual shows
  double freedom = 0;   // lines that tell it
};

// Each line's share of its noise that the fit of the mode takes away: the diagonal of the projection on its changes.
Eigen::VectorXd absorbed_shares(const ModeChanges& changes) {
  Eigen::MatrixXcd absorbed(changes.pole.size(), 3);
  absorbed << changes.residue, changes.pole, Eigen::VectorXcd::Ones(changes.pole.size());
  const Eigen::HouseholderQR<Eigen::MatrixXcd> qr(absorbed);
  const Eigen::MatrixXcd basis = qr.householderQ() * Eigen::MatrixXcd::Identity(absorbed.rows(), absorbed.cols());
  return basis.rowwise().squaredNorm();
}

NoiseAtMode noise_at_mode(const std::vector<double>& std, std::size_t offset, const std::vector<Complex>& frf,
                          const std::vector<Complex>& fit, const NoiseWindow& window, const Eigen::VectorXd& influence,
                          const Eigen::VectorXd& absorbed) {
  NoiseAtMode noise;
  double residual = 0, remains = 0, squares = 0;
  for (std::size_t k = window.first; k < window.end && !std.empty(); ++k) {
    const auto i = static_cast<Index>(k - window.first);
    const double weight = influence(i) * std::max(0.0, 1 - absorbed(i));
    noise.stated += influence(i) * std[offset + k] * std[offset + k];
    residual += influence(i) * std::norm(frf[k] - fit[k]);
    remains += weight;
    squares += weight * weight;
  }
  if (!(remains > 0)) return noise;
  noise.residual = residual / remains;
  noise.freedom = remains * remains / squares;
  return noise;
}

// The mean square of the residual, from which the fit takes the noise.
double residual_variance(const std::vector<Complex>& frf, const std::vector<Complex>& fit, const NoiseWindow& window) {
  double sum = 0;
  for (std::size_t k = window.first; k < window.end; ++k) sum += std::norm(frf[k] - fit[k]);
  return std::max(kMinVariance, sum / static_cast<double>(window.end - window.first));
}

// True where the lines scatter far less than stated: the stated deviations are then errors that the lines share.
bool is_shared(const NoiseAtMode& noise) {
  if (!(noise.freedom >= kMinFreedom) || !(noise.stated > 0)) return false;
  const double degrees = 2 * noise.freedom;  // a line has a real and an imaginary part
  return chi2_deviate(degrees * noise.residual / noise.stated, degrees) < -kMinDeviate;
}

// The stated deviations of the lines of the resonance as the scatter of a residue.
struct GainScatter {
  double stated = 0, energy = 0;
  double relative2() const { return energy > 0 ? stated / energy : 0; }
};

GainScatter gain_scatter(Complex residue, const ModeChanges& changes, const NoiseWindow& window,
                         const std::vector<double>& std, std::size_t offset) {
  const double half2 = std::norm(residue) / 4;  // near its pole, a mode is half of residue times change
  GainScatter gain;
  for (std::size_t k = window.first; k < window.end; ++k) {
    const double value2 = half2 * std::norm(changes.residue(static_cast<Index>(k - window.first)));
    gain.stated += value2 * std[offset + k] * std[offset + k];
    gain.energy += value2 * value2;
  }
  return gain;
}

// The mean of several statements of one scatter, weighted by their inverse variances.
class MeanScatter {
 public:
  void add(const PoleScatter& one) {
    if (!(one.std > 0)) return;
    evidence_ += 1 / (one.std * one.std);
    weighted_ += one.variance / (one.std * one.std);
  }
  // Without evidence: {}.
  PoleScatter mean() const {
    return evidence_ > 0 ? PoleScatter{.variance = weighted_ / evidence_, .std = 1 / std::sqrt(evidence_)}
                         : PoleScatter{};
  }

 private:
  double evidence_ = 0, weighted_ = 0;
};

// What the FRFs of a point say of a mode. They share their hits.
struct PointScatter {
  double weight = 0;  // of the FRFs in the fit of the mode
  MeanScatter pole;
  GainScatter gain;
};

using Points = std::map<std::size_t, PointScatter>;

// The residues scatter by what the channels of a point have in common, and by the rest of each.
void add_gains(const Points& points, const std::map<std::size_t, GainScatter>& of_residues, identify::Mode& mode) {
  for (const auto& [o, own] : of_residues) {
    identify::Residue& residue = mode.residues[o];
    const double rest2 = std::max(0.0, own.relative2() - points.at(residue.point).gain.relative2());
    residue.std = std::hypot(residue.std, std::sqrt(rest2) * std::abs(residue.value));
  }
  for (identify::Residue& residue : mode.residues)
    residue.relative_std = std::hypot(residue.relative_std, std::sqrt(points.at(residue.point).gain.relative2()));
}

// The scatter of a mode's pole: the mean of the points, each with its own hits.
PoleScatter mean_of_points(const Points& points) {
  double weights = 0, all2 = 0, known2 = 0;
  for (const auto& [point, of] : points) weights += of.weight;
  PoleScatter mean;
  for (const auto& [point, of] : points) {
    const double share2 = std::pow(of.weight / weights, 2);
    all2 += share2;
    const PoleScatter one = of.pole.mean();
    if (!(one.std > 0)) continue;
    known2 += share2;
    mean.variance += share2 * one.variance;
    mean.std = std::hypot(mean.std, share2 * one.std);
  }
  if (!(known2 > 0) || !std::isfinite(mean.variance)) return {};
  return {.variance = mean.variance * all2 / known2, .std = mean.std * all2 / known2};
}

// Hits usually differ in the same proportion at all modes, as by their temperature: a mode whose lines cannot tell
// takes what `all` modes say, as far as its lines allow it.
double variance_of_hits(const PoleScatter& own, const PoleScatter& all) {
  if (own.variance > kSignificantVariance * own.std) return own.variance;
  if (!(all.variance > kSignificantVariance * all.std)) return 0;
  return own.std > 0 ? std::clamp(own.variance + kSignificantVariance * own.std, 0.0, all.variance) : all.variance;
}

void add_hits(double variance, identify::Mode& mode) {
  if (!(variance > 0)) return;
  const double relative = std::sqrt(variance);
  mode.freq_std_parts_Hz.hits = std::hypot(mode.freq_std_parts_Hz.hits, relative * mode.pole.freq_Hz);
  mode.damping_std_parts.hits = std::hypot(mode.damping_std_parts.hits, relative);
  mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
  mode.damping_std = mode.damping_std_parts.total();
}

}  // namespace

void widen_to_stated_noise(const acquire::FrfRecord& given, const identify::FrfDataset& set,
                           std::vector<identify::Mode>& modes) {
  const auto states_none = [](const acquire::PointFrf& one) { return one.frf.std.empty(); };
  if (std::all_of(given.frfs.begin(), given.frfs.end(), states_none)) return;
  const std::vector<identify::SynthesisedFrf> fits = identify::synthesised_frfs(set, modes, set.lines);
  const std::size_t offset = set.lines.first - given.lines.first;
  std::vector<PoleScatter> hits(modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    identify::Mode& mode = modes[m];
    const NoiseWindow window = noise_window_around(mode, set.lines);
    const ModeChanges changes = changes_with(mode.pole, set.lines, set.window_decay_per_s(), window);
    const Eigen::VectorXd influence = influence_of_lines(changes), absorbed = absorbed_shares(changes);
    // The weights of the FRFs in the fit come from the residual. They stay, whatever is stated.
    double weights = 0, variance_of_pole = 0;
    Points points;
    std::map<std::size_t, GainScatter> gains;  // by the index of the residue
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      identify::Residue& residue = mode.residues[o];
      const std::vector<Complex>& frf = set.channels[o].frf;
      const std::vector<double>& std = given.frfs[o].frf.std;
      const double fitted = residual_variance(frf, fits[o].value, window);
      const NoiseAtMode noise = noise_at_mode(std, offset, frf, fits[o].value, window, influence, absorbed);
      const double weight = std::norm(residue.value) / fitted;
      double variance = std::max(fitted, noise.stated);
      if (is_shared(noise)) {
        variance = std::max(fitted, noise.residual);
        const GainScatter gain = gain_scatter(residue.value, changes, window, std, offset);
        gains.emplace(o, gain);
        points[residue.point].gain.stated += gain.stated;
        points[residue.point].gain.energy += gain.energy;
      }
      if (!std.empty())
        points[residue.point].pole.add(stated_pole_scatter(set, modes, m, o, std::span(std).subspan(offset), variance));
      points[residue.point].weight += weight;
      weights += weight;
      variance_of_pole += weight * variance / fitted;
      residue.std *= std::sqrt(variance / fitted);
    }
    add_gains(points, gains, mode);
    if (!(weights > 0)) continue;
    hits[m] = mean_of_points(points);
    const double ratio = std::sqrt(variance_of_pole / weights);
    if (!(ratio > 1)) continue;
    mode.freq_std_parts_Hz.noise *= ratio;
    mode.damping_std_parts.noise *= ratio;
    mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
    mode.damping_std = mode.damping_std_parts.total();
  }
  MeanScatter of_modes;
  for (const PoleScatter& one : hits) of_modes.add(one);
  const PoleScatter all = of_modes.mean();
  for (std::size_t m = 0; m < modes.size(); ++m) add_hits(variance_of_hits(hits[m], all), modes[m]);
}

}  // namespace percuss::pipeline
