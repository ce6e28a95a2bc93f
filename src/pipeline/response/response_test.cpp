#include "pipeline/response/response_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acquire/hits/time_selection.hpp"
#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/decay/decay_disturbance.hpp"
#include "identify/decay/decay_start.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/response/response_warnings.hpp"
#include "pipeline/response/usable_decay.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/source/band.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kAntiAlias = 0.44;                         // of fs: above it a recorder's filter shapes the response
constexpr double kMinDefaultLines = 1.5;                    // lower end of the default band, in spectral lines
constexpr double kMinLengthShare = 0.5;                     // of the median length
constexpr double kBlow_s = 0.005;                           // after the onset: the force may still act
constexpr std::size_t kMaxSamples = std::size_t{1} << 18U;  // of a transform
constexpr int kMaxAttempts = 3;                             // fits; each leaves out the disturbances the last one shows

std::vector<ResponseHit> graded(const acquire::Record& record, const AnalysisOptions& options) {
  std::vector<ResponseHit> hits;
  std::vector<double> lengths;
  for (const ResponseImpact& impact : response_impacts(record, options.hits)) {
    const UsableDecay usable = usable_decay(record, impact);
    ResponseHit hit{.impact = impact,
                    .point = record.rows[impact.row].point,
                    .onset_s = static_cast<double>(impact.first) / record.fs_Hz,
                    .accepted = true,
                    .reason = {},
                    .gated = usable.gated};
    if (usable.clipped) hit.clipped_s = static_cast<double>(usable.first - impact.first) / record.fs_Hz;
    hit.impact.first = usable.first;
    hit.impact.end = usable.end;
    lengths.push_back(static_cast<double>(usable.end - usable.first));
    hits.push_back(std::move(hit));
  }
  require_hits(options.accept_hits, hits.size(), record, "accept_hit");
  require_hits(options.reject_hits, hits.size(), record, "reject_hit");
  const double least = std::max(static_cast<double>(kMinDecaySamples), kMinLengthShare * median(lengths));
  const bool any_shown = std::any_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.impact.whole_pulse; });
  for (std::size_t h = 0; h < hits.size(); ++h) {
    // Without a visible pulse, the impact may lie anywhere in the row.
    if (any_shown && !hits[h].impact.whole_pulse) {
      hits[h].accepted = false;
      hits[h].reason = "no impact rises above the noise here, unlike in other rows";
    }
    if (static_cast<double>(hits[h].impact.end - hits[h].impact.first) < least) {
      hits[h].accepted = false;
      hits[h].reason = "too few usable samples until the next impact or the end";
    }
    const bool accept = names_hit(options.accept_hits, options.reject_hits, h) && can_be_accepted(hits[h]);
    const bool reject = names_hit(options.reject_hits, options.accept_hits, h);
    hits[h].by_user = accept || reject;
    if (accept) hits[h].accepted = true;
    if (reject) hits[h].accepted = false;
  }
  return hits;
}

// The first gap within the decay of a hit. Shortens the decay so that it ends before a second gap.
std::optional<GapInDecay> gap_of(const acquire::Record& record, ResponseHit& hit) {
  const auto blow = static_cast<std::size_t>(kBlow_s * record.fs_Hz);
  std::optional<GapInDecay> found;
  for (const acquire::SampleGap& gap : acquire::gaps_of(record)) {
    if (gap.row != hit.impact.row || gap.first + gap.count <= hit.impact.first || gap.first >= hit.impact.end) continue;
    if (found) {
      hit.impact.end = gap.first;
      found->decay.end = gap.first;
      break;
    }
    found = {.gap = gap, .decay = {.first = hit.impact.first + blow, .end = hit.impact.end}};
  }
  return found;
}

// Predicts the missing samples of the decays. If they cannot be predicted, the longer part of the decay remains.
void close_decay_gaps(ResponseTest& test) {
  std::vector<GapInDecay> gaps;
  std::vector<std::size_t> of_hit;
  const auto take_longer_part = [](ResponseHit& hit, const acquire::SampleGap& gap) {
    const std::size_t end = std::min(gap.first + gap.count, hit.impact.end);
    if (gap.first > hit.impact.first && gap.first - hit.impact.first >= hit.impact.end - end) {
      hit.impact.end = gap.first;
    } else {
      hit.impact.first = end;
    }
    hit.lost->predicted = false;
  };
  for (std::size_t h = 0; h < test.hits.size(); ++h) {
    ResponseHit& hit = test.hits[h];
    const auto at = gap_of(test.record, hit);
    if (!at) continue;
    const auto after = static_cast<double>(at->gap.first) / test.record.fs_Hz - hit.onset_s;
    hit.lost = LostSamples{.hit = h, .count = at->gap.count, .after_s = after, .predicted = true};
    if (can_predict(*at)) {
      gaps.push_back(*at);
      of_hit.push_back(h);
    } else {
      take_longer_part(hit, at->gap);
    }
  }
  std::vector<std::size_t> failed;
  test.record = with_predicted_samples(test.record, gaps, failed);
  for (const std::size_t g : failed) take_longer_part(test.hits[of_hit[g]], gaps[g].gap);
}

std::size_t common_samples(const ResponseTest& test) {
  std::size_t samples = kMaxSamples;
  bool any = false;
  for (const ResponseHit& hit : test.hits) {
    if (!hit.accepted) continue;
    any = true;
    samples = std::min(samples, hit.impact.end - hit.impact.first);
  }
  if (const auto length = acquire::selected_length(test.record, test.options.hits))
    samples = std::min(samples, *length);
  return any && samples >= kMinDecaySamples ? fast_length_at_most(samples) : 0;
}

identify::FreeDecays decays_of(const ResponseTest& test) {
  identify::FreeDecays out{.fs_Hz = test.record.fs_Hz, .channels = test.record.accel.size(), .response = {}};
  for (const ResponseHit& hit : test.hits) {
    if (!hit.accepted) continue;
    ++out.hits;
    for (std::size_t c = 0; c < out.channels; ++c) {
      std::vector<double> x(test.samples);
      test.record.read_accel_mps2(hit.impact.row, c, hit.impact.first, x);
      out.response.push_back(std::move(x));
    }
  }
  return out;
}

// Rejects the hits whose decays are disturbed. Where all are, their decays end before the disturbance. Returns whether
// anything changed.
bool leave_out_disturbances(ResponseTest& test, const std::vector<std::optional<std::size_t>>& disturbed) {
  const bool all = std::all_of(disturbed.begin(), disturbed.end(), [](const auto& at) { return at.has_value(); });
  bool changed = false;
  auto at = disturbed.begin();
  for (ResponseHit& hit : test.hits) {
    if (!hit.accepted) continue;
    const std::optional<std::size_t> sample = *at++;
    if (!sample || hit.by_user || *sample < kMinDecaySamples) continue;
    changed = true;
    if (all) {
      hit.impact.end = hit.impact.first + *sample;
      hit.shortened = true;
    } else {
      hit.accepted = false;
      hit.reason = fmt::format("another blow or a contact {:.3g} s after the impact",
                               hit.clipped_s + static_cast<double>(*sample) / test.record.fs_Hz);
    }
  }
  return changed;
}

std::pair<double, double> default_band(double fs_Hz, std::size_t samples) {
  return {kMinDefaultLines * fs_Hz / static_cast<double>(samples), kAntiAlias * fs_Hz};
}

std::pair<double, double> band_of(const ResponseTest& test, std::size_t samples) {
  const double fs_Hz = test.record.fs_Hz;
  const std::pair<double, double> band = test.options.band_Hz.value_or(default_band(fs_Hz, samples));
  require_band(band, fs_Hz, test.record.source());
  return band;
}

// The decays within the band, and the decays beyond it. The spectrum of a truncated decay has wide skirts: it falls
// only as the inverse of the distance from its frequency. If the strong decays beyond the band were not fitted, false
// decays within the band would fit their skirts, and the free motion would seem to begin late.
identify::StartedFit fit_decays(const ResponseTest& test, const identify::FreeDecays& whole, std::size_t safe) {
  identify::FreeDecayOptions options{
      .band_Hz = test.band_Hz, .start_Hz = test.options.modes.start_Hz, .search = test.options.modes.start_Hz.empty()};
  const auto all = default_band(whole.fs_Hz, test.samples - safe);
  if (options.search && (all.first < test.band_Hz.first || all.second > test.band_Hz.second)) {
    options.band_Hz = {std::min(all.first, test.band_Hz.first), std::max(all.second, test.band_Hz.second)};
    identify::StartedFit wide = identify::fit_from_earliest_start(whole, safe, options);
    // The motion beyond the band may not be a sum of decays. Then only the band is fitted.
    if (wide.fit.complete) return wide;
    options.band_Hz = test.band_Hz;
  }
  return identify::fit_from_earliest_start(whole, safe, options);
}

std::vector<identify::ModeClassification> classified(const ResponseTest& test) {
  std::vector<identify::Mode> modes;
  for (const identify::DecayMode& one : test.found.modes) modes.push_back(one.mode);
  std::vector<std::optional<double>> angles_rad;
  for (const acquire::SignalInfo& signal : test.record.accel) angles_rad.push_back(signal.angle_rad);
  const auto sensors = identify::pair_of_sensors(angles_rad);
  std::vector<std::optional<double>> overlays_dB(modes.size());
  for (std::size_t m = 0; sensors && m < modes.size(); ++m) {
    const double first = std::abs(modes[m].residues[sensors->first].value);
    const double second = std::abs(modes[m].residues[sensors->second].value);
    if (first > 0 && second > 0) overlays_dB[m] = 20 * std::log10(second / first);
  }
  return identify::classify(modes, sensors, overlays_dB, test.options.classes);
}

// Rejects all hits if no row shows an impact or anything above the noise, and the fit finds no mode and no tone.
void reject_noise(ResponseTest& test) {
  const auto is_noise = [](const ResponseHit& hit) { return !hit.accepted || (hit.impact.quiet && !hit.by_user); };
  if (!test.found.modes.empty() || !test.found.tones.empty()) return;
  if (!std::all_of(test.hits.begin(), test.hits.end(), is_noise)) return;
  for (ResponseHit& hit : test.hits) {
    if (!hit.accepted) continue;
    hit.accepted = false;
    hit.reason = "no impact rises above the noise";
  }
  test.no_impact = true;
  test.samples = 0;
}

// Keeps the `count` modes with the most energy, in ascending frequency.
void keep_most_energetic(std::vector<identify::DecayMode>& modes, std::size_t count) {
  if (modes.size() <= count) return;
  std::vector<double> energy;
  energy.reserve(modes.size());
  for (const identify::DecayMode& one : modes) energy.push_back(one.energy);
  std::sort(energy.begin(), energy.end(), std::greater<>());
  std::erase_if(modes, [&](const identify::DecayMode& one) { return one.energy < energy[count - 1]; });
}

}  // namespace

ResponseTest analyse_responses(acquire::Record record, const AnalysisOptions& options, ResponseWork work) {
  ResponseTest test{
      .record = std::move(record), .options = options, .hits = {}, .found = {}, .classifications = {}, .warnings = {}};
  const ThreadLimit limit(options.threads);
  BudgetMeter meter(budget_of(options, test.record), test.record.source());
  const BudgetScope scope(meter);
  assume_angles(test.record, test.options.classes);
  test.hits = graded(test.record, test.options);
  close_decay_gaps(test);
  test.samples = common_samples(test);
  test.fitted = work == ResponseWork::modes;
  for (int attempt = 1; test.fitted && test.possible(); ++attempt) {
    const identify::FreeDecays whole = decays_of(test);
    const std::size_t safe = identify::safe_start(test.samples, whole.fs_Hz);
    test.band_Hz = band_of(test, test.samples - safe);
    const identify::StartedFit started = fit_decays(test, whole, safe);
    if (attempt < kMaxAttempts && leave_out_disturbances(test, identify::decay_disturbances(whole, started))) {
      test.samples = common_samples(test);
      continue;
    }
    test.start_s = static_cast<double>(started.start) / whole.fs_Hz;
    test.found = identify::modes_of_decays(started.fit, whole.channels, test.band_Hz);
    reject_noise(test);
    if (test.options.modes.modes) keep_most_energetic(test.found.modes, *test.options.modes.modes);
    test.classifications = classified(test);
    break;
  }
  test.warnings = response_warnings(test);
  return test;
}

std::size_t count_impacts(const ResponseTest& test) {
  const bool decays = !test.found.modes.empty();
  const auto shown = [&](const ResponseHit& hit) {
    return hit.impact.whole_pulse || (hit.accepted && (test.fitted ? decays : !hit.impact.quiet));
  };
  return static_cast<std::size_t>(std::count_if(test.hits.begin(), test.hits.end(), shown));
}

std::vector<OptionId> stated_force_options(const AnalysisOptions& options) {
  std::vector<OptionId> out;
  if (options.estimator != frf::Estimator::h1) out.emplace_back("estimator");
  if (options.exponential_end > 0) out.emplace_back("exponential");
  if (options.delays.automatic || !options.delays.delay_s.empty()) out.emplace_back("delay");
  if (options.hits.trigger_N) out.emplace_back("trigger");
  return out;
}

}  // namespace percuss::pipeline
