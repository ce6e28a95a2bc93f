#include "pipeline/stages/earlier_ringing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "identify/decay/known_decays.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/stages/single_hits.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;

constexpr double kMaterial = 0.3;           // standard deviations of a residue: a smaller change does not matter
constexpr double kClearRinging = 5;         // standard deviations of the energy of noise, above its mean
constexpr double kGone = 1e-7;              // of its first amplitude: a decay that has ended
constexpr double kExplained = 0.9;          // of the energy before the hit
constexpr double kTimeConstants = 2;        // of the slowest decay: the samples before the hit that measure it
constexpr std::size_t kMinRinging = 256;    // samples
constexpr std::size_t kMaxRinging = 32768;  // samples

// The amplitude of the decay that a hit's force excites, per unit of the residue:
// s²/(jω_d) Σ f[n] exp(−s n Δ) Δ. It holds at the gate's first sample.
Complex excitation(const acquire::Hit& hit, Complex rate_radps, double fs_Hz) {
  const Complex step = std::exp(-rate_radps / fs_Hz);
  Complex sum = 0, power = 1;
  for (const double force_N : hit.gated_N) {
    sum += force_N * power;
    power *= step;
  }
  return rate_radps * rate_radps / Complex(0, rate_radps.imag()) * sum / fs_Hz;
}

// The samples before a hit that measure the ringing.
struct Before {
  std::size_t first = 0, count = 0;
};

class RingingSearch {
 public:
  RingingSearch(const acquire::Record& record, const identify::FrfDataset& set, const TestSpectra& spectra,
                const std::vector<identify::Mode>& modes)
      : record_(record), set_(set), spectra_(spectra), modes_(modes) {
    for (const identify::Mode& mode : modes) rates_.push_back(identify::decay_rate_of(mode.pole));
  }

  std::optional<EarlierRinging> at(std::size_t hit) const {
    const LastBlow last = last_blow_before(spectra_.hits, hit);
    const std::vector<bool> expected = expected_after(last, hit);
    const bool any_expected = std::find(expected.begin(), expected.end(), true) != expected.end();
    const bool moves = may_ring_before(spectra_.hits[hit]);
    if (!any_expected && !moves) return std::nullopt;
    EarlierRinging ringing{.hit = hit, .rates = {}, .amplitude = {}, .std = {}};
    const Before before = samples_before(last, hit, any_expected ? expected : std::vector<bool>(expected.size(), true));
    measure(ringing, before, last, expected);
    return any_expected || !ringing.rates.empty() ? std::optional(std::move(ringing)) : std::nullopt;
  }

 private:
  const acquire::Hit& hit_of(std::size_t h) const { return spectra_.hits[h].hit; }

  // [modes] whether the last blow's ringing changes a residue by more than kMaterial of its standard deviation.
  std::vector<bool> expected_after(const LastBlow& last, std::size_t hit) const {
    std::vector<bool> expected(modes_.size());
    if (!last.hit) return expected;
    const double wait_s = static_cast<double>(hit_of(hit).gate_first - hit_of(*last.hit).gate_first) / set_.lines.fs_Hz;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const Complex s = rates_[m].rate_radps;
      const double left = std::exp(s.real() * wait_s) * std::abs(excitation(hit_of(*last.hit), s, set_.lines.fs_Hz)) /
                          std::abs(excitation(hit_of(hit), s, set_.lines.fs_Hz));
      double largest = 0, std = 0;
      for (const identify::Residue& residue : modes_[m].residues) {
        largest = std::max(largest, std::abs(residue.value));
        std = std == 0 ? residue.std : std::min(std, residue.std);
      }
      expected[m] = left * largest > kMaterial * std;
    }
    return expected;
  }

  Before samples_before(const LastBlow& last, std::size_t hit, const std::vector<bool>& ringing) const {
    const std::size_t begin = hit_of(hit).gate_first, free = begin > last.end ? begin - last.end : 0;
    const std::size_t guard = std::min(kFilterBeforePulse, free / 4);
    double slowest = set_.lines.fs_Hz;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      if (ringing[m]) slowest = std::min(slowest, -rates_[m].rate_radps.real());
    }
    const double wanted = kTimeConstants * set_.lines.fs_Hz / std::max(slowest, 1e-6);
    const auto most = static_cast<std::size_t>(
        std::clamp(wanted, static_cast<double>(kMinRinging), static_cast<double>(kMaxRinging)));
    const std::size_t count = fast_length_at_most(std::min(free - guard, most));
    return {.first = begin - guard - count, .count = count};
  }

  identify::DecaySpectra spectra_of(const Before& before, std::size_t row) const {
    identify::FreeDecays decays{.fs_Hz = record_.fs_Hz, .hits = 1, .channels = record_.accel.size(), .response = {}};
    std::vector<double> buffer;
    for (std::size_t c = 0; c < decays.channels; ++c) {
      const auto x = record_.read_accel_mps2.view_or_read(row, c, before.first, before.count, buffer);
      decays.response.emplace_back(x.begin(), x.end());
    }
    return identify::decay_spectra(decays);
  }

  void measure(EarlierRinging& ringing, const Before& before, const LastBlow& last,
               const std::vector<bool>& expected) const {
    if (before.count < kMinRinging) return;
    const acquire::Hit& hit = hit_of(ringing.hit);
    std::vector<std::size_t> fitted;  // modes
    std::vector<identify::DecayRate> rates;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const double since_s =
          last.hit ? static_cast<double>(before.first - std::min(before.first, hit_of(*last.hit).peak)) / record_.fs_Hz
                   : 0;
      if (std::exp(rates_[m].rate_radps.real() * since_s) < kGone) continue;
      fitted.push_back(m);
      rates.push_back(rates_[m]);
    }
    for (const Tone& tone : spectra_.responses.tones) {
      if (!tone.wanders) rates.push_back({Complex(0, kTwoPi * tone.freq_Hz)});
    }
    const identify::DecaySpectra measured = spectra_of(before, hit.row);
    const auto line = [&](double freq_Hz) {
      return std::min(static_cast<std::size_t>(std::max(1.0, freq_Hz / measured.df_Hz())), before.count / 2);
    };
    const std::size_t low = line(set_.lines.freq_Hz(0)), high = line(set_.lines.freq_Hz(set_.lines.count - 1));
    const identify::KnownDecays fit = identify::fit_known_decays(rates, measured, low, high - low + 1);
    if (fit.amplitude.size() == 0) return;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      if (expected[fitted[i]] || is_clear(fit, static_cast<Index>(i))) kept.push_back(i);
    }
    ringing.explained = fit.explained > kExplained;
    const double to_hit_s = (static_cast<double>(hit.first) - static_cast<double>(before.first)) / record_.fs_Hz;
    const double length_s = static_cast<double>(before.count) / record_.fs_Hz;
    const auto channels = static_cast<Index>(record_.accel.size());
    ringing.amplitude.resize(static_cast<Index>(kept.size()), channels);
    ringing.std.resize(static_cast<Index>(kept.size()), channels);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const auto row = static_cast<Index>(k), at = static_cast<Index>(kept[k]);
      const identify::Mode& mode = modes_[fitted[kept[k]]];
      const Complex s = rates[kept[k]].rate_radps;
      ringing.rates.push_back(rates[kept[k]]);
      const Complex growth = std::exp(s * to_hit_s);
      ringing.amplitude.row(row) = growth * fit.amplitude.row(at);
      // The error of the pole acts from the middle of the samples that measure the ringing to the middle of its decay
      // during the hit.
      const double acts_s = length_s / 2 - 1 / (2 * std::min(s.real(), -1e-6));
      const double pole_std = std::hypot(kTwoPi * mode.freq_std_Hz, std::abs(s) * mode.damping_std) * acts_s;
      for (Index c = 0; c < channels; ++c) {
        const double amplitude = std::abs(ringing.amplitude(row, c));
        ringing.std(row, c) = std::hypot(std::abs(growth) * std::sqrt(fit.variance(at, c)), amplitude * pole_std);
        const auto& extremes = spectra_.responses.of[ringing.hit][static_cast<std::size_t>(c)].grade.extremes;
        ringing.share = std::max(ringing.share, amplitude / extremes.max_distance_from(0));
      }
    }
  }

  // Whether the energy over all channels stands out of the noise.
  static bool is_clear(const identify::KnownDecays& fit, Index mode) {
    const auto channels = static_cast<double>(fit.amplitude.cols());
    const double energy = (fit.amplitude.row(mode).cwiseAbs2().array() / fit.variance.row(mode).array()).sum() / 2;
    return energy > channels + kClearRinging * std::sqrt(channels);
  }

  const acquire::Record& record_;
  const identify::FrfDataset& set_;
  const TestSpectra& spectra_;
  const std::vector<identify::Mode>& modes_;
  std::vector<identify::DecayRate> rates_;  // [modes]
};

}  // namespace

bool may_ring_at_hits(const std::vector<AnalysedHit>& hits) {
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted && (may_ring_before(hits[h]) || last_blow_before(hits, h).hit)) return true;
  }
  return false;
}

std::vector<EarlierRinging> find_earlier_ringing(const acquire::Record& record, const identify::FrfDataset& set,
                                                 const TestSpectra& spectra, const std::vector<identify::Mode>& modes) {
  if (modes.empty()) return {};
  const RingingSearch search(record, set, spectra, modes);
  const std::vector<std::size_t> used = accepted_hits(spectra.hits);
  std::vector<std::optional<EarlierRinging>> found(used.size());
  parallel_for(used.size(), 0, [&](std::size_t u) { found[u] = search.at(used[u]); });
  std::vector<EarlierRinging> out;
  for (auto& one : found) {
    if (one) out.push_back(std::move(*one));
  }
  return out;
}

HitResponses without_ringing(const HitResponses& measured, const std::vector<EarlierRinging>& ringing,
                             const std::vector<AnalysedHit>& hits, const TransformOptions& options) {
  const acquire::LineRange& lines = options.lines;
  const std::size_t channels = measured.of[ringing.front().hit].size();
  HitResponses out{.of = measured.of,
                   .lines = UninitializedArray<Complex>(ringing.size() * channels * lines.count),
                   .faults = measured.faults,
                   .tones = measured.tones};
  const identify::DecaySpectra window{
      .fs_Hz = lines.fs_Hz, .samples = lines.samples, .hits = 1, .channels = channels, .lines = {}};
  parallel_for(ringing.size(), options.threads, [&](std::size_t r) {
    const EarlierRinging& one = ringing[r];
    const acquire::Hit& hit = hits[one.hit].hit;
    std::vector<std::span<Complex>> left;
    for (std::size_t c = 0; c < channels; ++c) {
      left.push_back(out.lines.part((r * channels + c) * lines.count, lines.count));
      const auto before = measured.of[one.hit][c].spectrum;
      std::copy(before.begin(), before.end(), left[c].begin());
      out.of[one.hit][c].spectrum = left[c];
    }
    // The exponential window is 1 at the peak.
    const double decay = options.window_decay_per_s;
    const double at_first = std::exp(decay * static_cast<double>(hit.peak - hit.first) / lines.fs_Hz);
    for (std::size_t m = 0; m < one.rates.size(); ++m) {
      const Eigen::MatrixX2cd values =
          identify::decay_values({one.rates[m].rate_radps - decay}, window, lines.first, lines.count);
      for (std::size_t c = 0; c < channels; ++c) {
        const Complex a = at_first * one.amplitude(static_cast<Index>(m), static_cast<Index>(c));
        Eigen::Map<Eigen::VectorXcd>(left[c].data(), values.rows()) -=
            values.col(0) * a.real() + values.col(1) * a.imag();
      }
    }
  });
  return out;
}

void add_ringing_std(const std::vector<EarlierRinging>& ringing, const identify::FrfDataset& set,
                     const TestSpectra& spectra, std::vector<identify::Mode>& modes) {
  const auto places = places_of_points(spectra);
  for (const EarlierRinging& one : ringing) {
    const AnalysedHit& hit = spectra.hits[one.hit];
    const std::size_t point = places.at(hit.point);
    for (std::size_t i = 0; i < one.rates.size(); ++i) {
      for (identify::Mode& mode : modes) {
        if (!identify::overlap(one.rates[i], identify::decay_rate_of(mode.pole), 0.5)) continue;
        const std::size_t line = set.lines.nearest(mode.pole.freq_Hz);
        // The weight of this hit in the average of its point: an error of the hit enters the average by this factor.
        const double part = std::norm(spectra.force[one.hit].get()[line]) / set.points[point].ff[line];
        const double per_residue =
            std::abs(excitation(hit.hit, identify::decay_rate_of(mode.pole).rate_radps, set.lines.fs_Hz));
        for (identify::Residue& residue : mode.residues) {
          if (residue.point != point) continue;
          const double std = one.std(static_cast<Index>(i), static_cast<Index>(residue.channel));
          residue.std = std::hypot(residue.std, part * std / per_residue);
        }
        break;
      }
    }
  }
}

}  // namespace percuss::pipeline
