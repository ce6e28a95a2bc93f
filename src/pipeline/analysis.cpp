#include "pipeline/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/windows.hpp"
#include "pipeline/hits/gate_choice.hpp"
#include "pipeline/hits/hit_consistency.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/source/frf_source.hpp"
#include "pipeline/source/record_source.hpp"
#include "pipeline/stages/cancelled_tones.hpp"
#include "pipeline/stages/hidden_modes.hpp"
#include "pipeline/stages/hit_scatter.hpp"
#include "pipeline/stages/mains_modes.hpp"
#include "pipeline/stages/single_hits.hpp"
#include "pipeline/stages/stated_noise.hpp"

namespace percuss::pipeline {
Analysis::Analysis(acquire::Record record, AnalysisOptions options)
    : source_(std::make_shared<RecordSource>(std::move(record))),
      options_(std::move(options)),
      budget_(budget_of(options_, source_->record()), source_->record().source()) {}

Analysis::Analysis(acquire::FrfRecord frfs, AnalysisOptions options)
    : source_(std::make_shared<FrfSource>(std::move(frfs))),
      options_(std::move(options)),
      budget_(budget_of(options_, source_->record()), source_->record().source()) {
  const auto refuse = [&](const char* choice, const char* option) {
    throw InputError(std::string(choice) + " needs records in time, not FRFs", record().source(), "leave it out",
                     {option});
  };
  if (options_.exponential_end > 0) refuse("an exponential window", "exponential");
  if (options_.estimator != frf::Estimator::h1) refuse("an estimator other than H1", "estimator");
  if (options_.delays.automatic || !options_.delays.delay_s.empty()) refuse("a correction of delays", "delay");
}

const std::vector<AnalysedHit>& Analysis::force_hits() const {
  return within_budget(budget_, force_hits_, [&] {
    const ThreadLimit limit(options_.threads);
    return trace_.run("hits", [&] {
      const HitDemands demands{.accept = options_.accept_hits,
                               .reject = options_.reject_hits,
                               .high_Hz = options_.band_Hz ? std::optional(options_.band_Hz->second) : std::nullopt};
      return grade_by_force(source_->find_hits(options_.hits), record(), demands);
    });
  });
}

bool Analysis::possible() const { return source_->has_frfs(hits_.ready() ? hits() : force_hits()); }

std::pair<double, double> Analysis::band_Hz() const {
  return options_.band_Hz ? *options_.band_Hz : source_->default_band_Hz(force_hits());
}

const acquire::LineRange& Analysis::lines() const {
  return within_budget(budget_, lines_, [&] {
    const LineRequest request{.band_Hz = band_Hz(),
                              .band_given = options_.band_Hz.has_value(),
                              .length_given = options_.hits.length_s.has_value(),
                              .missing_samples = samples_without_data(corrected_delays(), record().fs_Hz),
                              .threads = options_.threads};
    return source_->choose_lines(request, force_hits(), trace_);
  });
}

acquire::LineRange Analysis::band_lines() const {
  const auto [low_Hz, high_Hz] = band_Hz();
  const acquire::LineRange& all = lines();
  acquire::LineRange band = frf::lines_in_band(all.fs_Hz, all.samples, low_Hz, high_Hz);
  const std::size_t first = std::max(band.first, all.first);
  const std::size_t end = std::min(band.first + band.count, all.first + all.count);
  band.first = first;
  band.count = end > first ? end - first : 0;
  return band;
}

double Analysis::window_decay_per_s() const {
  if (!(options_.exponential_end > 0)) return source_->window_decay_per_s();
  return frf::decay_for_end(options_.exponential_end, static_cast<double>(lines().samples) / record().fs_Hz);
}

TransformOptions Analysis::transform_options() const {
  return {.lines = lines(), .window_decay_per_s = window_decay_per_s(), .threads = options_.threads};
}

const HitResponses& Analysis::responses() const {
  return within_budget(budget_, responses_,
                       [&] { return read_responses(aligned_record(), force_hits(), transform_options(), trace_); });
}

const std::vector<AnalysedHit>& Analysis::gated_hits() const {
  if (given_frfs() != nullptr || !any_tail(force_hits())) return force_hits();
  return within_budget(budget_, gated_hits_, [&] {
    std::vector<AnalysedHit> out = force_hits();
    choose_gate(out, responses(), transform_options());
    return out;
  });
}

const std::vector<frf::Spectrum>& Analysis::force_spectra() const {
  return within_budget(budget_, force_spectra_,
                       [&] { return pipeline::force_spectra(gated_hits(), transform_options(), trace_); });
}

const std::vector<AnalysedHit>& Analysis::hits() const {
  return within_budget(budget_, hits_, [&] { return compute_hits(); });
}

std::vector<AnalysedHit> Analysis::compute_hits() const {
  std::vector<AnalysedHit> out = possible() ? gated_hits() : force_hits();
  if (!possible()) return out;
  grade_by_responses(out, responses());
  if (!any_accepted(out)) return out;
  const std::vector<HitSpectra> compared = spectra_of_hits(out, force_spectra(), responses(), lines().count);
  const ThreadLimit limit(options_.threads);
  trace_.run("agreement", [&] {
    grade_agreement(out, compared);
    vote_first_motion(out);
  });
  return out;
}

std::optional<FileDisagreement> Analysis::file_disagreement() const {
  if (record().files.size() < 2 || given_frfs() != nullptr || !any_accepted(hits())) return std::nullopt;
  return disagreeing_file(record(), hits(), spectra_of_hits(hits(), force_spectra(), responses(), lines().count));
}

TestSpectra Analysis::measured_spectra() const {
  return {.lines = lines(),
          .hits = hits(),
          .force = force_spectra(),
          .responses = responses(),
          .window_decay_per_s = window_decay_per_s()};
}

namespace {

// The first poles are fitted to responses that still contain the ringing of earlier blows. Strong ringing biases these
// poles, and then also the ringing that is extrapolated with them. Both are computed again until the poles stand still.
constexpr int kRingingPasses = 8;
constexpr double kStrongRinging = 3e-3;  // of the largest response
constexpr double kStill = 0.2;           // standard deviations of a pole

bool stand_still(const std::vector<identify::Mode>& before, const std::vector<identify::Mode>& now) {
  return std::equal(before.begin(), before.end(), now.begin(), now.end(),
                    [](const identify::Mode& a, const identify::Mode& b) {
                      return std::abs(a.pole.freq_Hz - b.pole.freq_Hz) < kStill * b.freq_std_Hz &&
                             std::abs(a.pole.damping_ratio - b.pole.damping_ratio) < kStill * b.damping_std;
                    });
}

bool rings_strongly(const std::vector<EarlierRinging>& ringing) {
  return std::any_of(ringing.begin(), ringing.end(),
                     [](const EarlierRinging& one) { return one.share > kStrongRinging; });
}

}  // namespace

const std::vector<EarlierRinging>& Analysis::earlier_ringing() const {
  return within_budget(budget_, earlier_ringing_, [&] {
    if (given_frfs() != nullptr || !may_ring_at_hits(hits())) return std::vector<EarlierRinging>{};
    const TestSpectra from = measured_spectra();
    const ThreadLimit limit(options_.threads);
    FirstModes first{.frfs = source_->dataset(from, accepted_hits(from.hits), nullptr), .modes = {}};
    first.modes = trace_.run("modes", [&] { return identify::identify_modes(first.frfs, all_modes()); });
    std::vector<EarlierRinging> ringing = trace_.run(
        "earlier ringing", [&] { return find_earlier_ringing(aligned_record(), first.frfs, from, first.modes); });
    std::vector<identify::Mode> known = first.modes;
    if (ringing.empty()) first_modes_ = std::move(first);
    for (int pass = 1; pass < kRingingPasses && rings_strongly(ringing); ++pass) {
      const HitResponses settled = without_ringing(responses(), ringing, hits(), transform_options());
      const TestSpectra quiet{.lines = from.lines,
                              .hits = from.hits,
                              .force = from.force,
                              .responses = settled,
                              .window_decay_per_s = from.window_decay_per_s};
      const identify::FrfDataset set = source_->dataset(quiet, accepted_hits(quiet.hits), nullptr);
      auto modes = trace_.run("modes", [&] { return identify::identify_modes(set, all_modes()); });
      ringing = trace_.run("earlier ringing", [&] { return find_earlier_ringing(aligned_record(), set, from, modes); });
      if (stand_still(known, modes)) break;
      known = std::move(modes);
    }
    return ringing;
  });
}

TestSpectra Analysis::spectra() const {
  if (earlier_ringing().empty()) return measured_spectra();
  const HitResponses& settled = within_budget(budget_, settled_responses_, [&] {
    return without_ringing(responses(), earlier_ringing(), hits(), transform_options());
  });
  return {.lines = lines(),
          .hits = hits(),
          .force = force_spectra(),
          .responses = settled,
          .window_decay_per_s = window_decay_per_s()};
}

// The number of modes that the options state limits the modes within the band, not the modes of its margin.
identify::IdentifyOptions Analysis::all_modes() const {
  identify::IdentifyOptions all = options_.modes;
  all.modes.reset();
  return all;
}

std::vector<int> Analysis::frf_points() const {
  std::set<int> points;
  for (const FrfGroup& group : source_->groups(hits())) points.insert(group.point);
  return {points.begin(), points.end()};
}

const std::vector<acquire::PointFrf>& Analysis::frfs() const {
  return within_budget(budget_, frfs_, [&] {
    const std::vector<FrfGroup> groups = source_->groups(hits());
    const TestSpectra from = spectra();
    const ThreadLimit limit(options_.threads);
    return trace_.run("frf", [&] {
      std::vector<acquire::PointFrf> frfs(groups.size());
      const std::size_t hits_per_frf = groups.empty() ? 0 : groups.front().hits.size();
      parallel_for_cost(groups.size(), average_cost_flops(from.lines.count, hits_per_frf),
                        [&](std::size_t i) { frfs[i] = source_->frf(groups[i], from, options_.estimator); });
      return frfs;
    });
  });
}

const identify::FrfDataset& Analysis::fitted_frfs() const {
  return within_budget(budget_, fitted_frfs_, [&] {
    const TestSpectra from = spectra();
    if (first_modes_) return std::move(first_modes_->frfs);
    const bool averaged = frfs_.ready() && options_.estimator == frf::Estimator::h1;
    const ThreadLimit limit(options_.threads);
    return source_->dataset(from, accepted_hits(from.hits), averaged ? &frfs() : nullptr);
  });
}

const std::vector<identify::Mode>& Analysis::modes() const {
  return within_budget(budget_, modes_, [&] {
    const identify::FrfDataset& set = fitted_frfs();
    const TestSpectra from = spectra();
    const std::vector<Tone>& tones = from.responses.tones;
    const bool hums =
        std::any_of(tones.begin(), tones.end(), [](const Tone& tone) { return may_be_mains(tone.freq_Hz); });
    const ThreadLimit limit(options_.threads);
    return trace_.run("modes", [&] {
      const identify::IdentifyOptions all = all_modes();
      std::vector<identify::Mode> found =
          first_modes_ ? std::move(first_modes_->modes) : identify::identify_modes(set, all);
      if (const acquire::FrfRecord* given = given_frfs()) widen_to_stated_noise(*given, set, found);
      std::optional<identify::HitFrfs> built;
      const auto hits = [&]() -> const identify::HitFrfs& {
        if (!built) built = single_hits(set, from, comparable_hits(from));
        return *built;
      };
      HiddenModes hidden;
      const auto search = [&] {
        hidden = may_hide_modes(set, from, all, found) ? add_hidden_modes(found, tones, set, hits, all.effort)
                                                       : HiddenModes{};
      };
      search();
      add_scatter_between_hits(set, from, hits, options_.modes, search, found);
      if (!hidden.wandering.empty()) refit_modes_near_tones(found, hidden.wandering, set, hits(), all.effort);
      if (hidden.wandering.empty() && !hums) searched_poles_ = hidden.unmodelled;
      if (hums) remove_mains_modes(found, tones, set, hits());
      add_ringing_std(earlier_ringing(), set, from, found);
      BandModes split = modes_in_band(std::move(found), frf_points(), band_Hz());
      margin_modes_ = std::move(split.below);
      if (options_.modes.modes && *options_.modes.modes < split.within.size()) {
        band_modes_ = split.within;
        identify::keep_clearest(split.within, *options_.modes.modes);
      }
      return std::move(split.within);
    });
  });
}

void Analysis::compute_modes_and_frfs() const {
  frfs();  // first: the fit reuses the H1 estimates
  modes();
}

const std::vector<identify::ModeClassification>& Analysis::types() const {
  return within_budget(budget_, types_, [&] {
    const std::vector<identify::Mode>& found = modes();
    const identify::FrfDataset& set = fitted_frfs();
    return trace_.run("classes", [&] {
      if (band_modes_.empty()) return classify_modes(found, set, record().accel, options_.classes);
      return classifications_of_part(classify_modes(band_modes_, set, record().accel, options_.classes), band_modes_,
                                     found);
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
    return out;
  });
}

const std::vector<HitMode>& Analysis::modes_per_hit() const {
  return within_budget(budget_, modes_per_hit_, [&] {
    const std::vector<identify::Mode>& found = modes();
    const TestSpectra from = spectra();
    const auto dataset_of = [&](std::size_t hit) { return source_->dataset(from, {hit}, nullptr); };
    std::vector<HitOfPoint> used;
    for (const std::size_t h : accepted_hits(from.hits)) used.push_back({.hit = h, .point = from.hits[h].point});
    return trace_.run("modes per hit", [&] { return modes_of_hits(found, used, dataset_of, options_.modes.effort); });
  });
}

const identify::Stabilisation& Analysis::stabilisation() const {
  return within_budget(budget_, stabilisation_, [&] {
    const identify::FrfDataset& set = fitted_frfs();
    return trace_.run("stabilisation", [&] { return stabilisation_in_band(set, band_Hz()); });
  });
}

}  // namespace percuss::pipeline
