// Modes of the test, their types, and the modes of single hits.
#include <algorithm>
#include <optional>
#include <utility>

#include "core/parallel/parallel.hpp"
#include "identify/hits/drift_removal.hpp"
#include "identify/misfit/residual_end.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/stages/blow_time.hpp"
#include "pipeline/stages/cancelled_tones.hpp"
#include "pipeline/stages/hidden_modes.hpp"
#include "pipeline/stages/hit_scatter.hpp"
#include "pipeline/stages/single_hits.hpp"
#include "pipeline/stages/stated_noise.hpp"
#include "pipeline/stages/tone_modes.hpp"
#include "pipeline/warnings/hit_scatter_warnings.hpp"

namespace percuss::pipeline {
namespace {

constexpr int kDriftPasses = 2;  // the first pass uses residues of FRFs that still hold the drift

std::vector<Tone> joined(std::vector<Tone> tones, const std::vector<Tone>& more) {
  tones.insert(tones.end(), more.begin(), more.end());
  return tones;
}

// The mode in the band that misfits most; nullptr where none misfits much.
const identify::Mode* most_misfitting(const std::vector<identify::Mode>& modes, std::pair<double, double> band_Hz) {
  const identify::Mode* most = nullptr;
  for (const identify::Mode& mode : modes) {
    if (mode.pole.freq_Hz < band_Hz.first || mode.pole.freq_Hz > band_Hz.second) continue;
    if (much_misfit(mode) > (most ? much_misfit(*most) : 0)) most = &mode;
  }
  return most;
}

}  // namespace

// The options of a fit that finds all modes. They leave out the stated number of modes, which limits the modes within
// the band, but not the modes of its margin. They also leave out the stated frequencies: modes that no frequency names
// must take part in the fit, because the other modes would be biased without them.
identify::IdentifyOptions Analysis::all_modes() const { return {.effort = options_.modes.effort}; }

void Analysis::add_started_modes(std::vector<identify::Mode>& found) const {
  const std::vector<double>& start_Hz = options_.modes.start_Hz;
  if (start_Hz.empty()) return;
  identify::StartedModes started =
      identify::with_started_modes(fitted_frfs(), std::move(found), start_Hz, options_.modes.effort);
  found = std::move(started.modes);
  refused_starts_ = std::move(started.refused);
  joined_modes_ = std::move(started.joined);
}

void Analysis::keep_started_modes(std::vector<identify::Mode>& modes) const {
  const std::vector<double>& start_Hz = options_.modes.start_Hz;
  if (start_Hz.empty()) return;
  const auto named = identify::modes_of_starts(lines(), modes, start_Hz);
  std::erase_if(refused_starts_, [&](const identify::RefusedStart& one) {
    const auto start = std::find(start_Hz.begin(), start_Hz.end(), one.asked_Hz);
    return named[static_cast<std::size_t>(start - start_Hz.begin())].has_value();
  });
  std::vector<char> is_named(modes.size(), 0);
  for (const std::optional<std::size_t>& mode : named) {
    if (mode) is_named[*mode] = 1;
  }
  std::vector<identify::Mode> listed;
  for (std::size_t m = 0; m < modes.size(); ++m)
    (is_named[m] ? listed : unlisted_modes_).push_back(std::move(modes[m]));
  modes = std::move(listed);
}

void Analysis::remove_drift(const TestSpectra& from, const std::function<const identify::HitFrfs&()>& hits,
                            std::vector<identify::Mode>& found) const {
  for (int pass = 0; pass < kDriftPasses; ++pass) {
    const std::optional<identify::DriftTrend> drift = identify::common_drift(found);
    if (!drift) return;
    identify::SteadyTest steady = identify::without_drift(averaged_frfs(), hits(), found, drift->freq_change_per_hit);
    const auto of_steady = [&]() -> const identify::HitFrfs& { return steady.hits; };
    refined_frfs_ = std::move(steady.set);
    const identify::FrfDataset& set = *refined_frfs_;
    std::vector<identify::Mode> again = identify::identify_modes(set, all_modes());
    const auto search = [&] {
      if (may_hide_modes(set, from, all_modes(), again))
        add_hidden_modes(again, from.responses.tones, set, of_steady, options_.modes.effort);
    };
    search();
    add_started_modes(again);
    add_scatter_between_hits(set, from, of_steady, options_.modes, search, again);
    identify::describe_common_drift(*drift, hits().points.size(), found, again);
    found = std::move(again);
  }
}

void Analysis::allow_for_blow_time(std::vector<identify::Mode>& found) const {
  before_blow_s_ = time_before_blow_s(averaged_frfs(), found);
  if (!before_blow_s_) return;
  refined_frfs_ = with_blow_after(averaged_frfs(), *before_blow_s_);
  found = identify::identify_modes(*refined_frfs_, all_modes());
}

const identify::FrfDataset& Analysis::fitted_frfs() const { return refined_frfs_ ? *refined_frfs_ : averaged_frfs(); }

const identify::FrfDataset& Analysis::averaged_frfs() const {
  return within_budget(budget_, averaged_frfs_, [&] {
    const TestSpectra from = spectra();
    if (first_modes_) return std::move(first_modes_->frfs);
    const bool averaged = frfs_.ready() && options_.estimator == frf::Estimator::h1;
    const ThreadLimit limit(options_.threads);
    return source_->dataset(from, accepted_hits(from.hits), averaged ? &frfs() : nullptr);
  });
}

const std::vector<identify::Mode>& Analysis::modes() const {
  return within_budget(budget_, modes_, [&] {
    const identify::FrfDataset& given_or_averaged = averaged_frfs();
    const TestSpectra from = spectra();
    const std::vector<Tone>& tones = from.responses.tones;
    const ThreadLimit limit(options_.threads);
    return trace_.run("modes", [&] {
      const identify::IdentifyOptions all = all_modes();
      std::vector<identify::Mode> found =
          first_modes_ ? std::move(first_modes_->modes) : identify::identify_modes(given_or_averaged, all);
      const acquire::FrfRecord* const given = given_frfs();
      if (given) {
        allow_for_blow_time(found);
        add_started_modes(found);
        widen_to_stated_noise(*given, fitted_frfs(), found);
      }
      const identify::FrfDataset& averaged = before_blow_s_ ? *refined_frfs_ : given_or_averaged;
      std::optional<identify::HitFrfs> built;
      const auto hits = [&]() -> const identify::HitFrfs& {
        if (!built) built = single_hits(averaged, from, comparable_hits(from));
        return *built;
      };
      HiddenModeSearch hidden;
      const auto search = [&] {
        hidden = may_hide_modes(averaged, from, all, found) ? add_hidden_modes(found, tones, averaged, hits, all.effort)
                                                            : HiddenModeSearch{};
      };
      search();
      if (!given) add_started_modes(found);
      add_scatter_between_hits(averaged, from, hits, options_.modes, search, found);
      if (!given && averaged.points.size() > 1) remove_drift(from, hits, found);
      const identify::FrfDataset& set = fitted_frfs();
      if (!hidden.wandering.empty()) refit_modes_near_tones(found, hidden.wandering, set, hits(), all.effort);
      if (hidden.wandering.empty() && tones.empty()) searched_poles_ = hidden.unmodelled;
      remove_tone_modes(found, joined(tones, hidden.wandering), set, hits);
      add_ringing_std(earlier_ringing(), set, from, found);
      if (const identify::Mode* const most = most_misfitting(found, band_Hz()))
        residual_end_Hz_ = identify::growing_end_Hz(set, found, most->pole.freq_Hz);
      BandModes split = modes_in_band(std::move(found), frf_points(), band_Hz());
      margin_modes_ = std::move(split.below);
      margin_modes_.insert(margin_modes_.end(), split.above.begin(), split.above.end());
      keep_started_modes(split.within);
      if (options_.modes.modes && *options_.modes.modes < split.within.size()) {
        band_modes_ = split.within;
        identify::keep_clearest(split.within, *options_.modes.modes);
      }
      return std::move(split.within);
    });
  });
}

std::vector<identify::Mode> Analysis::fitted_modes() const {
  const std::vector<identify::Mode>& listed = modes();  // sets the others
  std::vector<identify::Mode> all = band_modes_.empty() ? listed : band_modes_;
  all.insert(all.end(), unlisted_modes_.begin(), unlisted_modes_.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const identify::Mode& a, const identify::Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  return all;
}

std::vector<Silence> Analysis::silent_channels() const {
  const std::vector<identify::Mode>& found = modes();
  const auto motions =
      given_frfs() == nullptr ? channel_motions(record(), hits(), responses()) : std::vector<ChannelMotion>{};
  return silences(record(), band_modes_.empty() ? found : band_modes_, motions);
}

std::vector<acquire::SignalInfo> Analysis::typing_accel() const {
  std::vector<acquire::SignalInfo> out = record().accel;
  const std::vector<Silence> silent = silent_channels();
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (tells_no_type(silent[c])) out[c].angle_rad.reset();
  }
  return out;
}

std::vector<identify::Mode> Analysis::margin_modes_below() const {
  modes();  // sets the modes of the margin
  std::vector<identify::Mode> below = margin_modes_;
  std::erase_if(below, [&](const identify::Mode& mode) { return mode.pole.freq_Hz > band_Hz().second; });
  return below;
}

const std::vector<identify::ModeClassification>& Analysis::types() const {
  return within_budget(budget_, types_, [&] {
    const std::vector<identify::Mode>& found = modes();
    const identify::FrfDataset& set = fitted_frfs();
    const std::vector<acquire::SignalInfo> accel = typing_accel();
    return trace_.run("classes", [&] {
      if (band_modes_.empty()) return classify_modes(found, set, accel, options_.classes);
      return classifications_of_part(classify_modes(band_modes_, set, accel, options_.classes), band_modes_, found);
    });
  });
}

bool Analysis::modes_are_complete() const {
  modes();
  return options_.modes.start_Hz.empty() && band_modes_.empty();
}

const std::vector<identify::ModeClassification>& Analysis::classifications() const {
  return within_budget(budget_, classifications_, [&] {
    std::vector<identify::ModeClassification> out = types();
    const identify::LowerOrders& lower = lower_orders();
    for (identify::ModeClassification& mode : out) {
      if (!options_.modes.start_Hz.empty()) mode.order = 0;  // lower modes need not be among the stated ones
      if (mode.order > 0) mode.order += mode.type == identify::ModeType::hoop ? lower.hoop : lower.bending;
    }
    const auto sensors = sensor_pair(typing_accel());
    // The lowest hoop mode of the barrel is below the band.
    if (lower.hoop > 0 && sensors) {
      const auto ratios = identify::three_over_bending(modes(), *sensors, options_.classes);
      identify::allow_three_waves(modes(), out, ratios, modes_of_lower_orders());
    }
    return out;
  });
}

const std::vector<HitMode>& Analysis::modes_per_hit() const {
  return within_budget(budget_, modes_per_hit_, [&] {
    // Modes that no starting frequency names take part in the fit of each hit, but not in the result.
    std::vector<identify::Mode> found = modes();
    const std::size_t listed = found.size();
    found.insert(found.end(), unlisted_modes_.begin(), unlisted_modes_.end());
    const TestSpectra from = spectra();
    const auto dataset_of = [&](std::size_t hit) { return source_->dataset(from, {hit}, nullptr); };
    std::vector<HitOfPoint> used;
    for (const std::size_t h : accepted_hits(from.hits)) used.push_back({.hit = h, .point = from.hits[h].point});
    return trace_.run("modes per hit", [&] {
      std::vector<HitMode> per_hit = modes_of_hits(found, used, dataset_of, options_.modes.effort);
      std::erase_if(per_hit, [&](const HitMode& one) { return one.mode >= listed; });
      return per_hit;
    });
  });
}

std::vector<std::vector<ModeInHit>> Analysis::residues_per_hit() const {
  const std::vector<identify::Mode>& within = modes();
  if (given_frfs() != nullptr || within.empty()) return {};
  std::vector<identify::Mode> all = margin_modes_below();
  const std::size_t below = all.size();
  all.insert(all.end(), within.begin(), within.end());
  all.insert(all.end(), unlisted_modes_.begin(), unlisted_modes_.end());
  const TestSpectra from = spectra();
  const std::vector<std::size_t> used = comparable_hits(from);
  if (used.size() < 2) return {};
  const ThreadLimit limit(options_.threads);
  const identify::FrfDataset& set = fitted_frfs();
  auto out = modes_in_hits(set, single_hits(set, from, used), with_point_indices(std::move(all), frf_points()));
  if (out.empty()) return out;
  for (std::vector<ModeInHit>& mode : out) {
    for (ModeInHit& hit : mode) hit.hit = used[hit.hit];
  }
  out.resize(out.size() - unlisted_modes_.size());
  out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(below));
  return out;
}

const identify::Stabilisation& Analysis::stabilisation() const {
  return within_budget(budget_, stabilisation_, [&] {
    const identify::FrfDataset& set = fitted_frfs();
    return trace_.run("stabilisation", [&] { return stabilisation_in_band(set, band_Hz()); });
  });
}

}  // namespace percuss::pipeline
