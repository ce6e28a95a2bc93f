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
#include "pipeline/source/modes_beyond.hpp"
#include "pipeline/source/record_source.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kToneReach = 2;  // times the length of the transforms; later, the phase of hum may have wandered
// Of the samples: transforms of a smaller part are reported as cut. Fast lengths alone use 0.99 or more.
constexpr double kMaxUsedPart = 0.97;

// The FRFs with the window that the user states: it falls to `end` within their records, 1/df.
acquire::FrfRecord with_stated_window(acquire::FrfRecord frfs, double end) {
  if (!(end > 0)) return frfs;
  const double decay_per_s = frf::decay_for_end(end, 1 / frfs.lines.df_Hz());
  return acquire::with_exponential_window(std::move(frfs), decay_per_s);
}

}  // namespace

Analysis::Analysis(acquire::Record record, AnalysisOptions options)
    : source_(std::make_shared<RecordSource>(std::move(record))),
      options_(std::move(options)),
      budget_(budget_of(options_, source_->record()), source_->record().source()) {}

Analysis::Analysis(acquire::FrfRecord frfs, AnalysisOptions options)
    : source_(std::make_shared<FrfSource>(with_stated_window(std::move(frfs), options.exponential_end))),
      options_(std::move(options)),
      budget_(budget_of(options_, source_->record()), source_->record().source()) {
  const auto refuse = [&](const char* choice, const char* option) {
    throw InputError(std::string(choice) + " needs records in time, not FRFs", record().source(), "leave it out",
                     {option});
  };
  if (options_.estimator != frf::Estimator::h1) refuse("an estimator other than H1", "estimator");
  if (options_.delays.automatic || !options_.delays.delay_s.empty()) refuse("a correction of delays", "delay");
}

const PointNames& Analysis::point_names() const {
  return point_names_.get([&] { return PointNames(record(), points(), options_.geometry_points); });
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

const LineChoice& Analysis::line_choice() const {
  return within_budget(budget_, line_choice_, [&] {
    const LineRequest request{.band_Hz = band_Hz(),
                              .band_given = options_.band_Hz.has_value(),
                              .length_given = options_.hits.length_s.has_value(),
                              .missing_samples = samples_without_data(corrected_delays(), record().fs_Hz),
                              .threads = options_.threads};
    return source_->choose_lines(request, force_hits(), trace_);
  });
}

const acquire::LineRange& Analysis::lines() const {
  return given_frfs() != nullptr ? line_choice().lines : read_spectra().lines;
}

std::optional<DecayCut> Analysis::decay_cut() const {
  if (given_frfs() != nullptr || options_.hits.length_s) return std::nullopt;
  const auto used = static_cast<double>(line_choice().lines.samples);
  const double fs_Hz = record().fs_Hz;
  const auto all =
      static_cast<double>(common_samples(record(), force_hits(), samples_without_data(corrected_delays(), fs_Hz)));
  if (used > kMaxUsedPart * all) return std::nullopt;
  return DecayCut{.used_s = used / fs_Hz, .all_s = all / fs_Hz};
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
  if (given_frfs() != nullptr || !(options_.exponential_end > 0)) return source_->window_decay_per_s();
  return frf::decay_for_end(options_.exponential_end,
                            static_cast<double>(line_choice().lines.samples) / record().fs_Hz);
}

TransformOptions Analysis::transform_options(const acquire::LineRange& lines) const {
  TransformOptions out{.lines = lines, .window_decay_per_s = window_decay_per_s(), .threads = options_.threads};
  if (const std::optional<DecayCut> cut = decay_cut()) {
    const double all = cut->all_s * record().fs_Hz;
    out.tone_samples = std::min(kToneReach * out.lines.samples, static_cast<std::size_t>(std::llround(all)));
  }
  return out;
}

const Analysis::ReadSpectra& Analysis::read_spectra() const {
  return within_budget(budget_, read_spectra_, [&] {
    const TransformOptions options = transform_options(line_choice().lines);
    ReadSpectra out{.lines = {}, .responses = read_responses(aligned_record(), force_hits(), options, trace_)};
    out.lines = end_spectra_past_modes(out.responses, force_hits(), band_Hz(), line_choice().end_Hz, options);
    return out;
  });
}

const HitResponses& Analysis::responses() const { return read_spectra().responses; }

const std::vector<AnalysedHit>& Analysis::gated_hits() const {
  if (given_frfs() != nullptr || !any_tail(force_hits())) return force_hits();
  return within_budget(budget_, gated_hits_, [&] {
    std::vector<AnalysedHit> out = force_hits();
    choose_gate(out, responses(), transform_options(lines()));
    return out;
  });
}

const std::vector<frf::Spectrum>& Analysis::force_spectra() const {
  return within_budget(budget_, force_spectra_,
                       [&] { return pipeline::force_spectra(gated_hits(), transform_options(lines()), trace_); });
}

const std::vector<AnalysedHit>& Analysis::hits() const {
  return within_budget(budget_, hits_, [&] { return compute_hits(); });
}

std::vector<AnalysedHit> Analysis::compute_hits() const {
  std::vector<AnalysedHit> out = possible() ? gated_hits() : force_hits();
  if (!possible()) return out;
  grade_by_responses(out, responses());
  if (!any_accepted(out)) return out;
  const std::vector<ComparedHit> compared = spectra_of_hits(out, force_spectra(), responses(), lines().count);
  const ThreadLimit limit(options_.threads);
  trace_.run("agreement", [&] {
    grade_agreement(out, compared, record().rows);
    vote_first_motion(out);
  });
  return out;
}

std::optional<FileDisagreement> Analysis::file_disagreement() const {
  if (record().files.size() < 2 || given_frfs() != nullptr || !any_accepted(hits())) return std::nullopt;
  return disagreeing_file(record(), hits(), spectra_of_hits(hits(), force_spectra(), responses(), lines().count));
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

void Analysis::compute_modes_and_frfs() const {
  frfs();  // first: the fit reuses the H1 estimates
  modes();
}

}  // namespace percuss::pipeline
