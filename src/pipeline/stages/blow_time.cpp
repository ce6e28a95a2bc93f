#include "pipeline/stages/blow_time.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMaxPart = 0.5;     // longest time before the blow, of the record's length
constexpr double kMinEvidence = 50;  // twice the logarithm of the likelihood ratio
constexpr double kMinSilence = 0.5;  // part of the expected energy that is absent before the blow
// Times over the inverse of the band's width.
constexpr double kNearBlow = 8;            // the blow's own response reaches so far before it
constexpr double kEdge = 2, kBeside = 16;  // a step is blurred so far; the motion beside it is judged over so far
// Sum of two parts of the energy: the part before a step that the modes do not explain, and the part that remains after
// it. Where a window halves the motion, each part is a quarter.
constexpr double kMaxBesideEdge = 0.35;
constexpr double kNoiseTest = 3;  // standard deviations
constexpr double kMinPower = 1e-300;
constexpr double kMinNoise = 1e-9;         // over the largest value
constexpr double kMedianOfSquare = 0.455;  // of a normal deviate of variance 1
constexpr std::size_t kMaxFrfs = 8;        // the search for the exact time uses so many FRFs
constexpr int kSteps = 12;                 // of this search to each side
constexpr double kStep = 0.125;            // over the inverse of the band's width

bool rings_at_end(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes) {
  return std::any_of(modes.begin(), modes.end(), [&](const identify::Mode& mode) {
    return identify::remaining_amplitude(mode.pole, set.lines, set.window_decay_per_s()) > kRingingAmplitude;
  });
}

// exp of a parabola through the logarithms of the noise power. Weights that change fast over the lines would spread the
// response to the blow over the time before it. shapes  power, result [lines]
std::vector<double> smooth_power(const std::vector<double>& power) {
  const auto count = static_cast<Eigen::Index>(power.size());
  const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(count, -1, 1);
  Eigen::MatrixXd terms(count, 3);
  terms << Eigen::VectorXd::Ones(count), at.matrix(), at.square().matrix();
  const Eigen::VectorXd logs = Eigen::Map<const Eigen::ArrayXd>(power.data(), count).max(kMinPower).log();
  const Eigen::ArrayXd smooth = (terms * terms.householderQr().solve(logs)).array().exp();
  return {smooth.begin(), smooth.end()};
}

// The signal of lines within a band over their noise. shapes  noise [lines]; result [samples of the record]
std::vector<double> signal_of(const Eigen::VectorXcd& spectrum, const std::vector<double>& power,
                              const acquire::LineRange& lines) {
  std::vector<Complex> one_sided(lines.samples / 2 + 1);
  for (std::size_t k = 0; k < lines.count; ++k)
    one_sided[lines.first + k] = spectrum(static_cast<Eigen::Index>(k)) / std::sqrt(power[k]);
  return inverse_real_dft(one_sided, lines.samples);
}

// The impulse responses of one FRF over the standard deviation of their noise.
struct ImpulseResponse {
  std::vector<double> measured, of_modes;  // [samples]
};

ImpulseResponse impulse_response(const std::vector<Complex>& frf, const Eigen::VectorXcd& sum,
                                 const std::vector<double>& power, const acquire::LineRange& lines) {
  ImpulseResponse of{.measured = signal_of(Eigen::Map<const Eigen::VectorXcd>(frf.data(), sum.size()), power, lines),
                     .of_modes = signal_of(sum, power, lines)};
  std::vector<double> squares;  // of the second quarter: after the response to the blow, before the record's end
  for (std::size_t n = lines.samples / 4; n < lines.samples / 2; ++n)
    squares.push_back(std::pow(of.measured[n] - of.of_modes[n], 2));
  const double largest = *std::max_element(of.measured.begin(), of.measured.end());
  const double std = std::max(std::sqrt(median(std::move(squares)) / kMedianOfSquare), kMinNoise * largest);
  for (double& value : of.measured) value /= std;
  for (double& value : of.of_modes) value /= std;
  return of;
}

// Where the impulse responses become silent before the end of their period, by (3.8).
class Silence {
 public:
  Silence(const identify::FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums, double resolution_s)
      : frfs_(static_cast<double>(set.channels.size())), ringing_(set.channels.size()) {
    const acquire::LineRange& lines = set.lines;
    samples_per_resolution_ = resolution_s * lines.fs_Hz;
    const std::size_t near_blow = std::min(lines.samples, within(kNearBlow));
    first_ = static_cast<std::size_t>((1 - kMaxPart) * static_cast<double>(lines.samples));
    end_ = std::max(first_, lines.samples - near_blow);
    for (std::vector<double>* sum : {&measured_, &of_modes_, &differences_}) sum->assign(end_ + 1, 0);
    const identify::LineNoise noise(set);
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const ImpulseResponse of = impulse_response(set.channels[o].frf, sums[o], smooth_power(noise.local(o)), lines);
      for (std::size_t n = 0; n < end_; ++n) {
        const double h = of.measured[n], p = of.of_modes[n];
        measured_[n] += h * h;
        of_modes_[n] += p * p;
        differences_[n] += (h - p) * (h - p);
        if (n >= first_) ringing_[o] += p * p;
      }
    }
  }

  // The first silent sample; nothing where the evidence is weak, or where the motion does not end at once, as under a
  // window.
  std::optional<std::size_t> begin() const {
    double evidence = 0, most = 0, expected = 0, expected_of_most = 0;
    std::size_t at = end_;
    for (std::size_t n = end_; n-- > first_;) {
      evidence += differences_[n] - measured_[n];
      expected += of_modes_[n];
      if (evidence > most) std::tie(most, at, expected_of_most) = std::tuple(evidence, n, expected);
    }
    if (!(most > kMinEvidence) || !(most > kMinSilence * expected_of_most) || at == first_) return std::nullopt;
    const std::size_t edge = within(kEdge);
    const std::optional<double> unexplained = share_before(at - std::min(at, edge));
    const bool sharp = unexplained && *unexplained + share_after(std::min(end_, at + edge)) < kMaxBesideEdge;
    return sharp ? std::optional(at) : std::nullopt;
  }

  // The indices of the FRFs that ring most, at most `count`.
  std::vector<std::size_t> most_ringing(std::size_t count) const {
    std::vector<std::size_t> order(ringing_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return ringing_[a] > ringing_[b]; });
    order.resize(std::min(order.size(), count));
    return order;
  }

 private:
  std::size_t within(double resolutions) const {
    return static_cast<std::size_t>(std::ceil(resolutions * samples_per_resolution_));
  }

  // Energies beside the step, over as many samples as tell a small part of the modes' energy from noise.
  struct Beside {
    double energy = 0, of_modes = 0, samples = 0;
    double noise() const { return kNoiseTest * std::sqrt(2 * samples); }
    bool enough(double min_samples) const { return samples >= min_samples && kMaxBesideEdge * of_modes > noise(); }
    double share() const { return of_modes > 0 ? std::max(0.0, energy - samples - noise()) / of_modes : 0; }
  };
  void add(Beside& beside, const std::vector<double>& energy, std::size_t n) const {
    beside.energy += energy[n];
    beside.of_modes += of_modes_[n];
    beside.samples += frfs_;
  }
  double min_beside() const { return frfs_ * static_cast<double>(within(kBeside)); }

  // The part of the modes' energy that the motion before this sample lacks or adds; nothing where the noise hides it.
  std::optional<double> share_before(std::size_t end) const {
    Beside beside;
    for (std::size_t n = end; n-- > 0 && !beside.enough(min_beside());) add(beside, differences_, n);
    return beside.enough(min_beside()) ? std::optional(beside.share()) : std::nullopt;
  }
  // The part of the modes' energy that the motion from this sample on has.
  double share_after(std::size_t begin) const {
    Beside beside;
    for (std::size_t n = begin; n < end_ && !beside.enough(min_beside()); ++n) add(beside, measured_, n);
    return beside.share();
  }

  double frfs_, samples_per_resolution_ = 0;
  std::size_t first_ = 0, end_ = 0;                        // samples in which silence may begin
  std::vector<double> measured_, of_modes_, differences_;  // [samples] Σ over the FRFs of h², p², (h − p)², over σ²
  std::vector<double> ringing_;                            // [FRFs] Σ p²/σ²
};

// The FRFs that ring most at the end of the records, and the modes' residues of these FRFs. One point serves all,
// because the same impulse is the force of every point.
struct Part {
  identify::FrfDataset set;
  std::vector<identify::Mode> modes;
};

Part part_of(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
             const std::vector<std::size_t>& channels) {
  Part part{.set = {.lines = set.lines, .points = {set.points.front()}}, .modes = modes};
  for (identify::Mode& mode : part.modes) mode.residues.clear();
  for (const std::size_t o : channels) {
    part.set.channels.push_back(set.channels[o]);
    part.set.channels.back().point = 0;
    for (std::size_t m = 0; m < modes.size(); ++m) part.modes[m].residues.push_back(modes[m].residues[o]);
  }
  return part;
}

// Σ|residual|² of the FRFs if the blow comes after this time.
double misfit(const Part& part, double time_s) {
  const identify::FrfDataset set = with_blow_after(part.set, time_s);
  double sum = 0;
  for (const Eigen::VectorXcd& rest : identify::residuals_from_sums(set, identify::modal_sums(set, part.modes)))
    sum += rest.squaredNorm();
  return sum;
}

}  // namespace

std::optional<double> time_before_blow_s(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes) {
  if (!rings_at_end(set, modes)) return std::nullopt;
  const acquire::LineRange& lines = set.lines;
  const double resolution_s = 1 / (static_cast<double>(lines.count) * lines.df_Hz());
  const Silence silence(set, identify::modal_sums(set, modes), resolution_s);
  const std::optional<std::size_t> begin = silence.begin();
  if (!begin) return std::nullopt;
  const Part part = part_of(set, modes, silence.most_ringing(kMaxFrfs));
  const double middle_s = static_cast<double>(lines.samples - *begin) / lines.fs_Hz;
  double best_s = middle_s, least = misfit(part, middle_s);
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double time_s = middle_s + i * kStep * resolution_s;
    if (i == 0 || time_s < 0) continue;
    const double found = misfit(part, time_s);
    if (found < least) std::tie(best_s, least) = std::pair(time_s, found);
  }
  return best_s;
}

identify::FrfDataset with_blow_after(identify::FrfDataset set, double time_s) {
  const double samples = time_s * set.lines.fs_Hz;
  const double whole = std::floor(samples), part = samples - whole;
  const frf::ForceBlock block{.offset = static_cast<std::size_t>(whole),
                              .force_N = {1 - part, part},
                              .ungated_N = {},
                              .decay_per_s = set.window_decay_per_s()};
  const auto spectrum = std::make_shared<const std::vector<Complex>>(frf::force_spectrum(block, set.lines));
  const identify::PointForce force =
      identify::point_force({block}, {frf::Spectrum(spectrum, spectrum->data())}, set.lines, 0);
  std::fill(set.points.begin(), set.points.end(), force);
  return set;
}

}  // namespace percuss::pipeline
