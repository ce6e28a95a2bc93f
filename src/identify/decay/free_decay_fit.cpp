#include "identify/decay/free_decay_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/units.hpp"
#include "identify/decay/decay_noise.hpp"
#include "identify/decay/decay_search.hpp"

namespace percuss::identify {
namespace {

constexpr int kMaxSearches = 40, kMaxRounds = 4;
constexpr DecayWindows kSearchWindows{
    .half_power_bandwidths = 8, .lines = 30, .max_lines = 1000, .accuracy = DecayAccuracy::rough};
constexpr int kSearchSweeps = 1, kFinalSweeps = 30;
constexpr double kPairApart = 0.5, kPairReach = 3;  // of a mode's decay rate
constexpr double kPairLevel = 0.01;  // energy of a mode of a pair over the other's: below it, the weaker one is misfit
constexpr int kPairSweeps = 3;
constexpr double kScatterShare = 0.9;    // of the χ² that a second pole explains
constexpr std::size_t kPairPlaces = 10;  // independent pairs per mode, for decay_threshold()
constexpr double kStartDamping = 0.01;   // of the decays near stated frequencies
// A decay within the bandwidth of a stronger one is misfit if the ratio of their energies is below this limit. In a
// single spectrum the limit is higher: no amplitudes at other hits or channels distinguish a weak mode from a stronger
// one whose frequency or damping changes while it decays. The misfit is about as wide as the mode: a peak far narrower
// is no misfit of a broad background.
constexpr double kMisfitEnergy = 1e-3, kMisfitEnergyAlone = 0.1;
constexpr double kNarrowest = 0.1;    // decay rate of a misfit over the mode's
constexpr double kFastestFit = 0.25;  // decay rate over the sampling rate: a faster decay is over in a few samples

std::size_t line_of(const FittedDecay& mode, const DecaySpectra& spectra) {
  const double line = std::round(mode.rate.rate_radps.imag() / kTwoPi / spectra.df_Hz());
  return static_cast<std::size_t>(std::clamp(line, 1.0, static_cast<double>(spectra.lines.rows() - 1)));
}

// The energy of a decay as DecayCandidate::energy gives it: Σ over hits and channels of |a|² Σ exp(2 Re s t)/4 over the
// noise's variance per sample.
double energy_of(const FittedDecay& mode, const DecaySpectra& spectra, const Eigen::MatrixXd& noise) {
  const double decay = 2 * mode.rate.rate_radps.real() / spectra.fs_Hz, n = static_cast<double>(spectra.samples);
  const double sum = std::abs(decay * n) < 1e-9 ? n : std::expm1(decay * n) / std::expm1(decay);
  const auto line = static_cast<Eigen::Index>(line_of(mode, spectra));
  double energy = 0;
  // A line's variance is N times a sample's. The matched filter passes only half of the amplitude of a real decay.
  for (Eigen::Index i = 0; i < mode.amplitude.size(); ++i)
    energy += std::norm(mode.amplitude(i)) * sum / 4 * n / noise(line, i);
  return energy;
}

std::vector<double> energies(const DecayModel& model, const DecaySpectra& spectra, const Eigen::MatrixXd& noise) {
  std::vector<double> out;
  for (const FittedDecay& mode : model.modes()) out.push_back(energy_of(mode, spectra, noise));
  return out;
}

// Whether a weak decay may be the misfit of a stronger one.
bool may_be_misfit(const DecayRate& weak, const DecayRate& strong) {
  return overlap(weak, strong) && weak.rate_radps.real() < kNarrowest * strong.rate_radps.real();
}

// Whether the fit of a decay ended at a rate that describes the end of the force, and no motion of the structure.
bool ran_away(const DecayRate& rate, double fs_Hz) { return -rate.rate_radps.real() > kFastestFit * fs_Hz; }

// The index of the first decay to leave out; the number of decays if all stay.
std::size_t unconfirmed(const DecayModel& model, const std::vector<double>& energy, double threshold,
                        double misfit_energy, double fs_Hz) {
  const auto& modes = model.modes();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (!(energy[m] >= threshold) || ran_away(modes[m].rate, fs_Hz)) return m;
    for (std::size_t other = 0; other < modes.size(); ++other) {
      if (other != m && energy[m] < misfit_energy * energy[other] && may_be_misfit(modes[m].rate, modes[other].rate))
        return m;
    }
  }
  return modes.size();
}

// Σ |R|² over the noise, without the constant, which no decay explains. For noise alone, its mean is lines × spectra.
double chi2(const DecaySpectra& residual, const Eigen::MatrixXd& noise) {
  double sum = 0;
  const Eigen::Index lines = residual.lines.rows() - 1;
  for (Eigen::Index i = 0; i < residual.lines.cols(); ++i)
    sum += (residual.lines.col(i).tail(lines).cwiseAbs2().array() / noise.col(i).tail(lines).array()).sum();
  return sum;
}

// The decrease of chi2() if each hit had a pole of its own, to first order. The mode's own noise contains its misfit,
// so that its covariance is scaled to `noise`.
double gain_of_hits(const FittedDecay& mode, const DecaySpectra& spectra, const Eigen::MatrixXd& noise) {
  const auto line = static_cast<Eigen::Index>(line_of(mode, spectra)),
             channels = static_cast<Eigen::Index>(spectra.channels);
  double sum = 0;
  for (std::size_t h = 0; h < mode.hit_step.size(); ++h) {
    const Eigen::Vector2d& step = mode.hit_step[h];
    const Eigen::Index first = static_cast<Eigen::Index>(h) * channels;
    const double scale =
        (2 * mode.noise.segment(first, channels).array() / noise.row(line).segment(first, channels).transpose().array())
            .mean();
    const double gain = scale * step.dot(mode.hit_covariance[h].inverse() * step);
    if (std::isfinite(gain)) sum += gain;
  }
  return sum / 2;  // χ² is 1 per line, and thus 1/2 for its real and for its imaginary part
}

std::pair<double, double> frequencies_Hz(const DecayRate& a, const DecayRate& b) {
  return std::minmax({a.pole().freq_Hz, b.pole().freq_Hz});
}

// Whether frequencies that differ between the hits explain most of what a second pole would.
bool scatter_explains(const FittedDecay& alone, double gain, const DecaySpectra& spectra,
                      const Eigen::MatrixXd& noise) {
  return alone.hit_step.size() > 1 && gain_of_hits(alone, spectra, noise) > kScatterShare * gain;
}

// The model with one mode in place of the modes from m on that overlap each other, if one mode whose frequency scatters
// between the hits explains them.
std::optional<DecayModel> with_one_scattered_mode(const DecayModel& model, std::size_t m, const DecaySpectra& spectra,
                                                  const Eigen::MatrixXd& noise, const std::vector<double>& energy) {
  const auto& modes = model.modes();
  std::size_t last = m, strongest = m;
  while (last + 1 < modes.size() && overlap(modes[last].rate, modes[last + 1].rate)) {
    ++last;
    if (energy[last] > energy[strongest]) strongest = last;
  }
  if (last == m) return std::nullopt;
  DecayModel trial = model;
  for (std::size_t i = last + 1; i-- > m;) {
    if (i != strongest) trial.remove(i);
  }
  trial.fit(kPairSweeps, {});
  const double gain = chi2(trial.residual(), noise) - chi2(model.residual(), noise);
  if (!scatter_explains(trial.modes()[m], gain, spectra, noise)) return std::nullopt;
  trial.set_alternative_pair(m, frequencies_Hz(modes[m].rate, modes[last].rate));
  return trial;
}

// The model with mode m split into two, half a half-power bandwidth apart at the start, if this lowers χ² by more
// than noise would. The search cannot find such a pair: one fitted mode leaves no clear peak of the other. But the
// shapes of the two modes differ. If one mode whose frequency differs between the hits fits about as well, nothing is
// returned, and `model` stores the pair as an alternative. `residual_chi2` is χ² of the model's residual.
std::optional<DecayModel> with_pair(DecayModel& model, std::size_t m, double residual_chi2, const DecaySpectra& spectra,
                                    const Eigen::MatrixXd& noise) {
  const Complex s = model.modes()[m].rate.rate_radps, apart(0, kPairApart * s.real());
  DecayModel trial = model;
  trial.remove(m);
  trial.add({s - apart});
  trial.add({s + apart});
  trial.fit(kPairSweeps, kSearchWindows);
  const double gain = residual_chi2 - chi2(trial.residual(), noise);
  const auto count = static_cast<std::size_t>(spectra.lines.cols());
  if (!(gain > decay_threshold(count + 1, kPairPlaces * model.modes().size()))) return std::nullopt;
  const bool scatters = scatter_explains(model.modes()[m], gain, spectra, noise);
  const std::vector<double> energy = energies(trial, spectra, noise);
  for (std::size_t i = 0; i + 1 < energy.size(); ++i) {
    const bool pair = std::abs(trial.modes()[i].rate.rate_radps - s) < kPairReach * -s.real() &&
                      std::abs(trial.modes()[i + 1].rate.rate_radps - s) < kPairReach * -s.real();
    const double least = std::max(kPairLevel, spectra.lines.cols() > 1 ? 0 : kMisfitEnergyAlone);
    if (!pair || !(std::min(energy[i], energy[i + 1]) > least * std::max(energy[i], energy[i + 1]))) continue;
    if (!scatters) return trial;
    model.set_alternative_pair(m, frequencies_Hz(trial.modes()[i].rate, trial.modes()[i + 1].rate));
    break;
  }
  return std::nullopt;
}

// Whether the fit of a candidate stayed near it.
bool is_modelled(const DecayRate& candidate, const DecayModel& model, const DecaySpectra& spectra) {
  return std::any_of(model.modes().begin(), model.modes().end(),
                     [&](const FittedDecay& mode) { return overlap(mode.rate, candidate, 1, spectra.df_Hz()); });
}

// The steps of fit_free_decays(), and the model that they change.
class FreeDecayFitter {
 public:
  FreeDecayFitter(const DecaySpectra& measured, const FreeDecayOptions& options)
      : measured_(measured),
        options_(options),
        misfit_energy_(measured.lines.cols() > 1 ? kMisfitEnergy : kMisfitEnergyAlone),
        rounding_(decay_rounding(measured)),
        model_(measured),
        limits_{.band_Hz = options.band_Hz, .refused = {}} {
    out_.threshold = decay_threshold(measured.hits * measured.channels, measured.samples);
    out_.noise = decay_line_noise(measured, rounding_);
  }

  FreeDecayFit run() {
    fit_starts();
    if (!search()) {
      out_.complete = false;
      return result();
    }
    if (options_.search && measured_.hits > 1) merge_scattered_modes();
    model_.set_noise(out_.noise);
    if (options_.search) split_pairs();
    model_.fit(kFinalSweeps, {});
    out_.noise = decay_line_noise(model_.residual(), rounding_);
    return result();
  }

 private:
  void fit_starts() {
    for (const double start_Hz : options_.start_Hz)
      model_.add(decay_rate_of({.freq_Hz = start_Hz, .damping_ratio = kStartDamping}));
    for (const DecayRate& rate : options_.initial) model_.add(rate);
    model_.fit(kSearchSweeps, kSearchWindows);
    if (!options_.initial.empty()) drop_unconfirmed();
  }

  // The rough fits of a search refuse some decays that a full fit of the others reveals: the residual is searched
  // again. False if the search ended at max_decays.
  bool search() {
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::size_t before = model_.modes().size();
      if (options_.search) search_residual();
      if (model_.modes().size() >= options_.max_decays) return false;
      if (round > 0 && model_.modes().size() <= before) break;
      model_.set_noise(out_.noise);
      model_.fit(kFinalSweeps, {});
      drop_unconfirmed();
      limits_.refused.clear();
      if (!options_.search) break;
    }
    return true;
  }

  void search_residual() {
    for (int pass = 0; pass < kMaxSearches && model_.modes().size() < options_.max_decays; ++pass) {
      const auto found = strongest_decays(model_.residual(), out_.noise, limits_);
      if (found.empty()) break;
      for (const DecayCandidate& one : found) model_.add(one.rate);
      model_.fit(kSearchSweeps, kSearchWindows);
      const std::size_t before = model_.modes().size() - found.size();
      drop_unconfirmed();
      if (model_.modes().size() > before) limits_.refused.clear();  // a better model may confirm them
      for (const DecayCandidate& one : found) {
        if (!is_modelled(one.rate, model_, measured_)) limits_.refused.push_back(one.rate);
      }
    }
  }

  void drop_unconfirmed() {
    for (;;) {
      out_.noise = decay_line_noise(model_.residual(), rounding_);
      out_.energy = energies(model_, measured_, out_.noise);
      const std::size_t m = unconfirmed(model_, out_.energy, out_.threshold, misfit_energy_, measured_.fs_Hz);
      if (m == model_.modes().size()) return;
      limits_.refused.push_back(model_.modes()[m].rate);
      model_.remove(m);
      model_.fit(kSearchSweeps, kSearchWindows);
    }
  }

  void merge_scattered_modes() {
    for (std::size_t m = 0; m < model_.modes().size(); ++m) {
      if (auto alone =
              with_one_scattered_mode(model_, m, measured_, out_.noise, energies(model_, measured_, out_.noise)))
        model_ = std::move(*alone);
    }
  }

  void split_pairs() {
    double residual_chi2 = chi2(model_.residual(), out_.noise);
    for (std::size_t m = 0; m < model_.modes().size(); ++m) {
      if (auto pair = with_pair(model_, m, residual_chi2, measured_, out_.noise)) {
        model_ = std::move(*pair);
        residual_chi2 = chi2(model_.residual(), out_.noise);
        ++m;
      }
    }
  }

  FreeDecayFit result() {
    out_.energy = energies(model_, measured_, out_.noise);
    out_.decays = model_.modes();
    return std::move(out_);
  }

  const DecaySpectra& measured_;
  const FreeDecayOptions& options_;
  const double misfit_energy_;
  const Eigen::VectorXd rounding_;
  DecayModel model_;
  DecaySearchLimits limits_;
  FreeDecayFit out_;
};

}  // namespace

FreeDecayFit fit_free_decays(const DecaySpectra& measured, const FreeDecayOptions& options) {
  return FreeDecayFitter(measured, options).run();
}

}  // namespace percuss::identify
