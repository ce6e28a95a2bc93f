#include "pipeline/impact_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "identify/model/truncation.hpp"
#include "metrics/deflection/baseline_noise.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/impact_speed.hpp"
#include "pipeline/impacts.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/deflection_warnings.hpp"
#include "pipeline/warnings/lost_sample_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"

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

HitSignals signals_of(const acquire::Record& record, const AnalysedHit& hit, const ImpactTestOptions& options,
                      std::size_t first, std::size_t channel, const std::vector<metrics::ModalContribution>& modes) {
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
std::vector<double> flicker_strengths(const std::vector<std::vector<double>>& evidence, std::size_t channels) {
  std::vector<double> strengths;
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<double> sum;
    for (std::size_t i = c; i < evidence.size(); i += channels) {
      if (sum.empty()) {
        sum = evidence[i];
      } else if (!evidence[i].empty()) {
        std::transform(sum.begin(), sum.end(), evidence[i].begin(), sum.begin(), std::plus<>());
      }
    }
    strengths.push_back(metrics::flicker_strength(sum));
  }
  return strengths;
}

using PositionOf = std::function<std::optional<double>(int point)>;

PositionOf positions(const Analysis& analysis, const ImpactTestOptions& options) {
  const std::set<int> points = analysis.record().points();
  if (options.position_m.empty()) return [](int) { return std::optional<double>(); };
  if (options.position_m.size() != points.size()) {
    throw InputError(fmt::format("{} positions for {} points", options.position_m.size(), points.size()),
                     analysis.record().source(), "state one position for each point that was hit", {"positions"});
  }
  std::map<int, double> by_point;
  for (const int point : points) by_point.emplace(point, options.position_m[by_point.size()]);
  return [by_point](int point) { return std::optional<double>(by_point.at(point)); };
}

// Mean magnitude over the repeats that have a value, and its standard deviation; NaN when none has.
std::pair<double, double> mean_of(const std::vector<const metrics::Deflection*>& members,
                                  double metrics::Deflection::*value, double metrics::Deflection::*value_std) {
  double sum = 0, own = 0, scatter = 0, n = 0;
  for (const metrics::Deflection* d : members) {
    if (std::isnan(d->*value)) continue;
    sum += std::abs(d->*value);
    own += d->*value_std * (d->*value_std);
    ++n;
  }
  const double mean = sum / n;
  for (const metrics::Deflection* d : members) {
    if (!std::isnan(d->*value)) scatter += std::pow(std::abs(d->*value) - mean, 2);
  }
  const double from_scatter = n > 1 ? std::sqrt(scatter / (n * (n - 1))) : 0;
  return {mean, std::max(std::sqrt(own) / n, from_scatter)};
}

std::vector<PointDeflection> averaged(const std::vector<DeflectedHit>& hits, const PositionOf& position_of) {
  std::map<std::pair<int, std::size_t>, std::vector<const metrics::Deflection*>> groups;
  for (const DeflectedHit& hit : hits) groups[{hit.point, hit.channel}].push_back(&hit.deflection);
  std::vector<PointDeflection> points;
  for (const auto& [key, members] : groups) {
    PointDeflection point{.point = key.first, .channel = key.second, .hits = members.size()};
    point.position_m = position_of(key.first);
    std::tie(point.peak_m, point.std_m) =
        mean_of(members, &metrics::Deflection::peak_m, &metrics::Deflection::peak_std_m);
    std::tie(point.forward_m, point.forward_std_m) =
        mean_of(members, &metrics::Deflection::forward_m, &metrics::Deflection::forward_std_m);
    points.push_back(point);
  }
  return points;
}

// lost_samples: the impacts that are not used because they lack samples within their pulse, or too many after it.
std::vector<Warning> left_out_warnings(const std::vector<AnalysedHit>& impacts, const AnalysisOptions& options) {
  std::vector<Warning> out;
  for (std::size_t h = 0; h < impacts.size(); ++h) {
    if (is_usable_impact(impacts[h], options, h)) continue;
    for (const acquire::Finding& finding : impacts[h].hit.findings) {
      if (finding.code != acquire::FindingCode::lost_samples) continue;
      out.push_back({"lost_samples", fmt::format("hit {} is left out: {}", h + 1, finding.message), {"accept_hit"}});
    }
  }
  return out;
}

std::string without_force_remedy(metrics::DeflectionMethod method, bool mass_given) {
  std::string remedy = method == metrics::DeflectionMethod::modal ? "choose another method" : "";
  if (mass_given) remedy += std::string(remedy.empty() ? "" : " and ") + "leave out the effective mass";
  return remedy + ", or name the force's channel";
}

}  // namespace

ImpactTest deflect(const Analysis& analysis, const ImpactTestOptions& options) {
  const PositionOf position_of = positions(analysis, options);
  const ClosedGaps closed = analysis.closed_gaps();
  const acquire::Record& record = closed.record;
  const metrics::DeflectionMethod method = options.deflection.method;
  if (!record.has_force && (method == metrics::DeflectionMethod::modal || options.effective_mass_kg)) {
    throw InputError("no force was recorded", record.source(),
                     without_force_remedy(method, options.effective_mass_kg.has_value()),
                     {"method", "effective_mass", "force_channel"});
  }
  for (const acquire::SignalInfo& signal : record.accel) {
    if (signal.measures == Quantity::pressure) {
      throw InputError(one_line(signal.name, 40) + " is a pressure: it has no deflection", record.source(),
                       "name the accelerations, or find the modes alone", {"accel_channel"});
    }
  }
  const std::vector<AnalysedHit> impacts = record.has_force ? analysis.force_hits() : impacts_without_force(record);
  std::vector<std::size_t> hits;
  for (std::size_t h = 0; h < impacts.size(); ++h) {
    if (is_usable_impact(impacts[h], analysis.options(), h)) hits.push_back(h);
  }
  const bool rest = rest_recorded(record.fs_Hz, impacts, hits);
  const std::vector<bool> moving = moves_before(record, impacts, hits, analysis.options().threads);
  const bool moves = std::find(moving.begin(), moving.end(), true) != moving.end();
  const bool modal =
      method == metrics::DeflectionMethod::modal ||
      (method == metrics::DeflectionMethod::automatic && (!rest || moves) && record.has_force && analysis.possible());
  const std::size_t channels = record.accel.size();
  std::map<std::pair<int, std::size_t>, std::vector<metrics::ModalContribution>> contributions;
  for (const std::size_t h : hits) {
    for (std::size_t c = 0; c < channels; ++c) {
      auto& contribution = contributions[{impacts[h].point, c}];
      if (modal && contribution.empty())
        contribution = modal_contributions(analysis, impacts[h].point, c, options.deflection.highpass_corner_Hz);
      if (method == metrics::DeflectionMethod::modal && contribution.empty()) {
        throw InputError("no mode is known at the point of impact", fmt::format("hit {}", h + 1),
                         "choose another method, or check the findings of the hits", {"method"});
      }
    }
  }
  ImpactTest test{.speeds = impact_speeds(analysis, impacts, hits, options)};
  test.hits.resize(hits.size() * channels);
  const BudgetScope scope(analysis.budget());
  analysis.trace().run("deflection", [&] {
    const auto first_sample = [&](std::size_t i) {
      const std::size_t h = hits[i / channels];
      return moving[i / channels] ? impacts[h].hit.first
                                  : first_sample_of_impact(record, analysis.options().hits, impacts, h);
    };
    const auto signals = [&](std::size_t i) {
      const std::size_t h = hits[i / channels], c = i % channels;
      return signals_of(record, impacts[h], options, first_sample(i), c, contributions.at({impacts[h].point, c}));
    };
    const bool integrates =
        method == metrics::DeflectionMethod::automatic || method == metrics::DeflectionMethod::drift_free;
    // A hit before which the structure moves tells nothing of the noise.
    std::vector<std::vector<double>> evidence(test.hits.size());
    if (integrates) {
      parallel_for(test.hits.size(), analysis.options().threads, [&](std::size_t i) {
        if (!moving[i / channels]) evidence[i] = metrics::flicker_evidence(signals(i).impact, options.deflection);
      });
    }
    const std::vector<double> strengths = flicker_strengths(evidence, channels);
    parallel_for(test.hits.size(), analysis.options().threads, [&](std::size_t i) {
      const std::size_t h = hits[i / channels], c = i % channels;
      HitSignals hit = signals(i);
      if (integrates) hit.impact.flicker_strength = strengths[c];
      metrics::DeflectionOptions chosen = options.deflection;
      const bool by_modes =
          method == metrics::DeflectionMethod::automatic && moving[i / channels] && !hit.impact.modes.empty();
      if (by_modes) chosen.method = metrics::DeflectionMethod::modal;
      test.hits[i] = {.hit = h,
                      .channel = c,
                      .point = impacts[h].point,
                      .position_m = position_of(impacts[h].point),
                      .first_s = static_cast<double>(first_sample(i)) / record.fs_Hz,
                      .deflection = metrics::deflection_of(hit.impact, chosen)};
    });
    return 0;
  });
  test.points = averaged(test.hits, position_of);
  DeflectionResults results{.without_pulse = impacts_without_pulse(impacts, analysis.options()),
                            .impacts = impacts.size(),
                            .rest_recorded = rest,
                            .free_body = options.deflection.free_body,
                            .has_force = record.has_force,
                            .mass_known = options.effective_mass_kg.has_value()};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (moving[i]) results.moving.push_back(hits[i]);
  }
  for (const DeflectedHit& hit : test.hits) results.deflections.push_back({hit.hit, &hit.deflection});
  std::vector<Warning> warnings = deflection_warnings(results);
  for (Warning& warning : input_warnings(record)) warnings.push_back(std::move(warning));
  for (auto& more : {closed_gap_warnings(closed, impacts), left_out_warnings(impacts, analysis.options())})
    warnings.insert(warnings.end(), more.begin(), more.end());
  test.warnings = ranked(std::move(warnings));
  return test;
}

}  // namespace percuss::pipeline
