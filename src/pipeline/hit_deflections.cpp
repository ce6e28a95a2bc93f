#include "pipeline/hit_deflections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "identify/model/truncation.hpp"
#include "metrics/deflection/baseline_noise.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/impacts.hpp"

namespace percuss::pipeline {
namespace {

std::vector<metrics::ModalContribution> modal_contributions(const Analysis& analysis, int point, std::size_t channel,
                                                            double corner_Hz) {
  std::vector<metrics::ModalContribution> contributions;
  for (const identify::Mode& mode : analysis.modes()) {
    for (const identify::Residue& residue : mode.residues) {
      if (static_cast<int>(residue.point) != point || residue.channel != channel) continue;
      // The residue contains the amplifier's high-pass, s/(s + ω_c) at the pole.
      const Complex s = identify::terms_of(mode.pole).s;
      const Complex correction = (s + kTwoPi * corner_Hz) / s;
      contributions.push_back({.pole = mode.pole,
                               .residue_per_kg = residue.value * correction,
                               .residue_std_per_kg = residue.std * std::abs(correction),
                               .gain_std = residue.relative_std});
    }
  }
  return contributions;
}

// The signals of one hit at one accelerometer, from the sample `first` on.
struct HitSignals {
  std::vector<double> accel, force;
  metrics::ImpactSignal impact;  // refers to them
};

HitSignals signals_of_hit(const acquire::Record& record, const AnalysedHit& hit, const ImpactTestOptions& options,
                          std::size_t first, std::size_t channel,
                          const std::vector<metrics::ModalContribution>& modes) {
  const std::size_t samples = hit.hit.first + hit.hit.samples - first;
  HitSignals out{.accel = std::vector<double>(samples), .force = {}, .impact = {}};
  record.read_accel_mps2(hit.hit.row, channel, first, out.accel);
  if (!modes.empty() || options.effective_mass_kg) {
    out.force.resize(samples);
    for (std::size_t i = 0; i < hit.hit.gated_N.size(); ++i) {
      const std::size_t at = hit.hit.gate_first + i - first;
      if (at < out.force.size()) out.force[at] = hit.hit.gated_N[i];
    }
  }
  out.impact = {.fs_Hz = record.fs_Hz,
                .accel_mps2 = out.accel,
                .onset_s = hit.hit.onset_s - static_cast<double>(first) / record.fs_Hz,
                .force_N = out.force,
                .force_noise_N = hit.hit.noise_N,
                .rigid_per_kg = options.effective_mass_kg ? 1 / *options.effective_mass_kg : 0,
                .modes = modes};
  return out;
}

// The strength of each sensor's 1/f noise, from all its hits. evidence: hit by hit, channel by channel.
std::vector<double> flicker_strengths(const std::vector<metrics::FlickerEvidence>& evidence, std::size_t channels) {
  std::vector<double> strengths;
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<double> sum;
    for (std::size_t i = c; i < evidence.size(); i += channels) {
      const std::vector<double>& log_gains = evidence[i].log_gains;
      if (sum.empty()) {
        sum = log_gains;
      } else if (!log_gains.empty()) {
        std::transform(sum.begin(), sum.end(), log_gains.begin(), sum.begin(), std::plus<>());
      }
    }
    strengths.push_back(metrics::flicker_strength(sum));
  }
  return strengths;
}

// Reads the signals of the deflections. Deflection i is of the used impact i / channels and of the channel i %
// channels.
class SignalReader {
 public:
  SignalReader(const Analysis& analysis, const TestImpacts& impacts, const PlaceModes& modes,
               const ImpactTestOptions& options)
      : analysis_(analysis), impacts_(impacts), modes_(modes), options_(options) {}

  const acquire::Record& record() const { return analysis_.closed_gaps().record; }
  std::size_t channels() const { return record().accel.size(); }
  std::size_t size() const { return impacts_.used.size() * channels(); }
  std::size_t hit(std::size_t i) const { return impacts_.used[i / channels()]; }
  bool moving(std::size_t i) const { return impacts_.moving[i / channels()]; }
  int point(std::size_t i) const { return impacts_.all[hit(i)].point; }
  std::size_t first_sample(std::size_t i) const {
    return moving(i) ? impacts_.all[hit(i)].hit.first
                     : first_sample_of_impact(record(), analysis_.options().hits, impacts_.all, hit(i));
  }
  HitSignals signals(std::size_t i) const {
    const std::size_t channel = i % channels();
    return signals_of_hit(record(), impacts_.all[hit(i)], options_, first_sample(i), channel,
                          modes_.at({point(i), channel}));
  }
  // From the rest before the first blow in the row; nothing for this blow itself.
  std::optional<metrics::SensorLevel> level(std::size_t i) const {
    std::size_t blow = hit(i);
    while (const auto before = last_blow_before(impacts_.all, blow).hit) blow = *before;
    if (blow == hit(i)) return std::nullopt;
    const acquire::Hit& first = impacts_.all[blow].hit;
    const std::size_t end = first.gate_first - std::min(first.gate_first, kFilterBeforePulse);
    const std::size_t begin = first_sample_of_impact(record(), analysis_.options().hits, impacts_.all, blow);
    if (begin >= end) return std::nullopt;
    std::vector<double> rest(end - begin);
    record().read_accel_mps2(first.row, i % channels(), begin, rest);
    return metrics::sensor_level(rest, record().fs_Hz);
  }

 private:
  const Analysis& analysis_;
  const TestImpacts& impacts_;
  const PlaceModes& modes_;
  const ImpactTestOptions& options_;
};

// The evidence of 1/f noise in the signals of each deflection. Empty if the structure moved before the hit: the samples
// before it then do not show the noise alone.
std::vector<metrics::FlickerEvidence> flicker_evidence_of(const SignalReader& reader,
                                                          const metrics::DeflectionOptions& options,
                                                          std::size_t threads) {
  std::vector<metrics::FlickerEvidence> evidence(reader.size());
  parallel_for(evidence.size(), threads, [&](std::size_t i) {
    if (!reader.moving(i)) evidence[i] = metrics::flicker_evidence(reader.signals(i).impact, options);
  });
  return evidence;
}

}  // namespace

PlaceModes modes_for_deflections(const Analysis& analysis, const TestImpacts& impacts,
                                 const metrics::DeflectionOptions& options) {
  const acquire::Record& record = analysis.closed_gaps().record;
  const bool only_modal = options.method == metrics::DeflectionMethod::modal;
  const bool moves = std::find(impacts.moving.begin(), impacts.moving.end(), true) != impacts.moving.end();
  const bool modal = only_modal || (options.method == metrics::DeflectionMethod::automatic &&
                                    (!impacts.rest_recorded || moves) && record.has_force && analysis.possible());
  PlaceModes modes;
  for (const std::size_t h : impacts.used) {
    const int point = impacts.all[h].point;
    for (std::size_t c = 0; c < record.accel.size(); ++c) {
      auto& at_place = modes[{point, c}];
      if (modal && at_place.empty()) at_place = modal_contributions(analysis, point, c, options.highpass_corner_Hz);
      if (only_modal && at_place.empty()) {
        throw InputError("no mode is known at the point of impact", fmt::format("hit {}", h + 1),
                         "choose another method, or check the findings of the hits", {"method"});
      }
    }
  }
  return modes;
}

std::vector<DeflectedHit> hit_deflections(const Analysis& analysis, const TestImpacts& impacts, const PlaceModes& modes,
                                          const ImpactTestOptions& options) {
  const SignalReader reader(analysis, impacts, modes, options);
  const std::size_t threads = analysis.options().threads, channels = reader.channels();
  const metrics::DeflectionMethod method = options.deflection.method;
  const bool automatic = method == metrics::DeflectionMethod::automatic;
  const bool integrates = automatic || method == metrics::DeflectionMethod::drift_free;
  std::vector<metrics::FlickerEvidence> evidence(reader.size());
  if (integrates) evidence = flicker_evidence_of(reader, options.deflection, threads);
  const std::vector<double> strengths = flicker_strengths(evidence, channels);
  std::vector<DeflectedHit> out(reader.size());
  parallel_for(out.size(), threads, [&](std::size_t i) {
    HitSignals hit = reader.signals(i);
    if (integrates) hit.impact.flicker_strength = strengths[i % channels];
    if (integrates || options.effective_mass_kg) hit.impact.level = reader.level(i);
    hit.impact.motion = std::exchange(evidence[i].motion, nullptr);  // as large as the deflection that it becomes
    metrics::DeflectionOptions chosen = options.deflection;
    chosen.moves_before = reader.moving(i);
    if (automatic && reader.moving(i) && !hit.impact.modes.empty()) chosen.method = metrics::DeflectionMethod::modal;
    out[i] = {.hit = reader.hit(i),
              .channel = i % channels,
              .point = reader.point(i),
              .first_s = static_cast<double>(reader.first_sample(i)) / reader.record().fs_Hz,
              .deflection = metrics::deflection_of(hit.impact, chosen)};
  });
  return out;
}

}  // namespace percuss::pipeline
