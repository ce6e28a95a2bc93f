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
constexpr double kMaxDeviate = 2;
constexpr double kMinRelativeStd = 0.01;  // of a variance: equal stated deviations would fit to rounding errors
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

// The chance of so small a residual, if the stated deviations were noise of the lines, as a normal deviate.
double residual_deviate(const NoiseAtMode& noise) {
  if (!(noise.freedom >= kMinFreedom) || !(noise.stated > 0)) return 0;
  const double degrees = 2 * noise.freedom;  // a line has a real and an imaginary part
  return chi2_deviate(degrees * noise.residual / noise.stated, degrees);
}

// The residual of each mode in each FRF against the stated deviations. The hits that all FRFs and modes share may show
// only together that the stated deviations are no noise of the lines.
class SharedTest {
 public:
  void add(double deviate) {
    if (deviate == 0) return;
    sum_ += std::min(deviate, kMaxDeviate);  // a misfit says nothing
    ++count_;
  }
  // True where the lines scatter far less than stated: the stated deviations are then errors that the lines share.
  bool is_shared(double deviate) const {
    return deviate < -kMinDeviate || sum_ < -kMinDeviate * std::sqrt(static_cast<double>(count_));
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

// The mean of several statements of one scatter, weighted by their inverse variances.
class MeanScatter {
 public:
  void add(const StatedScatter& one) {
    if (!(one.std > 0)) return;
    evidence_ += 1 / (one.std * one.std);
    weighted_ += one.variance / (one.std * one.std);
  }
  // Without evidence: {}.
  StatedScatter mean() const {
    return evidence_ > 0 ? StatedScatter{.variance = weighted_ / evidence_, .std = 1 / std::sqrt(evidence_)}
                         : StatedScatter{};
  }

 private:
  double evidence_ = 0, weighted_ = 0;
};

// What the FRFs of a point say of a mode. They share their hits.
struct PointScatter {
  double weight = 0;  // of the FRFs in the fit of the mode
  MeanScatter pole, gain;
};

using Points = std::map<std::size_t, PointScatter>;

// The relative variance of the residue that the stated deviations show.
StatedScatter gain_scatter(const StatedGain& stated, const NoiseAtMode& noise) {
  StatedScatter gain = stated.gain;
  if (!(gain.std > 0)) return gain;
  const double excess = stated.constant.variance - noise.residual;
  const double excess_std = std::hypot(stated.constant.std, noise.residual / std::sqrt(noise.freedom));
  if (excess > kSignificantVariance * excess_std) gain.variance += excess * stated.constant_to_gain;
  gain.std = std::max(gain.std, kMinRelativeStd * std::abs(gain.variance));
  return gain;
}

// The scatter of a mode's pole: the mean of the points, each with its own hits.
StatedScatter mean_of_points(const Points& points) {
  double weights = 0, all2 = 0, known2 = 0;
  for (const auto& [point, of] : points) weights += of.weight;
  StatedScatter mean;
  for (const auto& [point, of] : points) {
    const double share2 = std::pow(of.weight / weights, 2);
    all2 += share2;
    const StatedScatter one = of.pole.mean();
    if (!(one.std > 0)) continue;
    known2 += share2;
    mean.variance += share2 * one.variance;
    mean.std = std::hypot(mean.std, share2 * one.std);
  }
  if (!(known2 > 0) || !std::isfinite(mean.variance)) return {};
  return {.variance = mean.variance * all2 / known2, .std = mean.std * all2 / known2};
}

bool is_significant(const StatedScatter& one) { return one.variance > kSignificantVariance * one.std; }

// Hits usually differ in the same proportion at all modes, as by their temperature: a mode whose lines cannot tell
// takes what `all` modes say, as far as its lines allow it.
double variance_of_hits(const StatedScatter& own, const StatedScatter& all) {
  if (is_significant(own)) return own.variance;
  if (!is_significant(all)) return 0;
  return own.std > 0 ? std::clamp(own.variance + kSignificantVariance * own.std, 0.0, all.variance) : all.variance;
}

// The residues scatter by what the channels of a point have in common, and by the rest of each.
void add_gains(const acquire::FrfRecord& given, const std::vector<Points>& points,
               const std::vector<std::vector<StatedScatter>>& gains, std::vector<identify::Mode>& modes) {
  std::map<std::size_t, MeanScatter> of_points;  // over the modes
  MeanScatter of_set;
  for (const Points& of_mode : points) {
    for (const auto& [point, of] : of_mode) {
      of_points[point].add(of.gain.mean());
      of_set.add(of.gain.mean());
    }
  }
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t o = 0; o < gains[m].size(); ++o) {
      identify::Residue& residue = modes[m].residues[o];
      const std::size_t averages = given.frfs[o].frf.averages;
      const double student = averages > 1 ? student_factor(static_cast<double>(averages - 1)) : 1;
      const StatedScatter common = points[m].at(residue.point).gain.mean();
      const StatedScatter of_point = of_points[residue.point].mean();
      // A point whose modes cannot tell takes the mean of all points.
      const bool ask_all = common.std > 0 && !is_significant(of_point);
      const double common2 = variance_of_hits(common, ask_all ? of_set.mean() : of_point);
      const double rest2 = gains[m][o].variance - common2;
      residue.relative_std = std::hypot(residue.relative_std, student * std::sqrt(common2));
      if (rest2 > kSignificantVariance * gains[m][o].std)
        residue.std = std::hypot(residue.std, student * std::sqrt(rest2) * std::abs(residue.value));
    }
  }
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
  std::vector<std::vector<NoiseAtMode>> noise(modes.size());  // [modes][FRFs]
  std::vector<NoiseWindow> windows;
  SharedTest shared;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    windows.push_back(noise_window_around(modes[m], set.lines));
    const ModeChanges changes = changes_with(modes[m].pole, set.lines, set.window_decay_per_s(), windows[m]);
    const Eigen::VectorXd influence = influence_of_lines(changes), absorbed = absorbed_shares(changes);
    for (std::size_t o = 0; o < modes[m].residues.size(); ++o) {
      noise[m].push_back(noise_at_mode(given.frfs[o].frf.std, offset, set.channels[o].frf, fits[o].value, windows[m],
                                       influence, absorbed));
      shared.add(residual_deviate(noise[m][o]));
    }
  }
  std::vector<StatedScatter> hits(modes.size());
  std::vector<Points> points(modes.size());
  std::vector<std::vector<StatedScatter>> gains(modes.size());  // [modes][FRFs]
  for (std::size_t m = 0; m < modes.size(); ++m) {
    identify::Mode& mode = modes[m];
    gains[m].resize(mode.residues.size());
    // The weights of the FRFs in the fit come from the residual. They stay, whatever is stated.
    double weights = 0, variance_of_pole = 0;
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      identify::Residue& residue = mode.residues[o];
      const double fitted = residual_variance(set.channels[o].frf, fits[o].value, windows[m]);
      const double weight = std::norm(residue.value) / fitted;
      const bool known = !given.frfs[o].frf.std.empty();
      double variance = std::max(fitted, noise[m][o].stated);
      PointScatter& point = points[m][residue.point];
      if (known && shared.is_shared(residual_deviate(noise[m][o]))) {
        variance = std::max(fitted, noise[m][o].residual);
        const auto std = std::span(given.frfs[o].frf.std).subspan(offset);
        gains[m][o] = gain_scatter(stated_gain(set, mode, o, std, variance), noise[m][o]);
        point.gain.add(gains[m][o]);
      }
      if (known) {
        const auto std = std::span(given.frfs[o].frf.std).subspan(offset);
        point.pole.add(stated_pole_scatter(set, modes, m, o, std, variance));
      }
      point.weight += weight;
      weights += weight;
      variance_of_pole += weight * variance / fitted;
      residue.std *= std::sqrt(variance / fitted);
    }
    if (!(weights > 0)) continue;
    hits[m] = mean_of_points(points[m]);
    const double ratio = std::sqrt(variance_of_pole / weights);
    if (!(ratio > 1)) continue;
    mode.freq_std_parts_Hz.noise *= ratio;
    mode.damping_std_parts.noise *= ratio;
    mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
    mode.damping_std = mode.damping_std_parts.total();
  }
  add_gains(given, points, gains, modes);
  MeanScatter of_modes;
  for (const StatedScatter& one : hits) of_modes.add(one);
  const StatedScatter all = of_modes.mean();
  for (std::size_t m = 0; m < modes.size(); ++m) add_hits(variance_of_hits(hits[m], all), modes[m]);
}

}  // namespace percuss::pipeline
