#include "report/text/method_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/io/significant_digits.hpp"
#include "core/units.hpp"
#include "report/text/fit_sentences.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

using Sentences = std::vector<std::string>;

constexpr std::size_t kMaxListedHits = 20;  // hits that were not used, each with its reason

std::string reason_of(const pipeline::AnalysedHit& hit) {
  if (hit.by_user) return "rejected by the user";
  for (const acquire::Finding& finding : hit.hit.findings) {
    if (finding.severity == acquire::Severity::reject) return finding.message;
  }
  return "its point has better hits";
}

// The time selection and the length of a hit, where the user set them.
void add_selection(const acquire::HitOptions& options, Sentences& out) {
  if (options.from_s > 0 || options.to_s) {
    out.push_back(fmt::format("The user chose the samples from {:.6g} s{}; hits elsewhere were left out.",
                              options.from_s, options.to_s ? fmt::format(" to {:.6g} s", *options.to_s) : " on"));
  }
  if (options.length_s)
    out.push_back(fmt::format("The user set the length of each hit to {:.6g} s.", *options.length_s));
}

// Where find_hits took the hits from.
std::string how_found(const pipeline::Analysis& analysis) {
  const acquire::Record& record = analysis.record();
  if (!record.continuous && record.rows.size() > 1) return "taken from the rows of the record, one from each";
  if (const auto& trigger_N = analysis.options().hits.trigger_N) {
    return fmt::format("found where the force differs from its baseline by {:.6g} N or more, as the user stated",
                       *trigger_N);
  }
  return "found where the force differs from its baseline by more than the noise (1.1), (1.2)";
}

void add_hits(const pipeline::Analysis& analysis, Sentences& out) {
  const auto& hits = analysis.hits();
  add_selection(analysis.options().hits, out);
  const std::size_t used = pipeline::accepted_hits(hits).size();
  out.push_back(fmt::format(
      "{} {}; {} used.", hits.size() == 1 ? "1 hit was" : fmt::format("{} hits were", hits.size()), how_found(analysis),
      used == hits.size() ? (used == 1 ? "it was" : "all were")
      : used == 1         ? "1 was"
                          : fmt::format("{} were", used)));
  std::size_t listed = 0, more = 0;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted) {
      if (hits[h].by_user) out.push_back(fmt::format("Hit {} was accepted by the user, whatever its findings.", h + 1));
    } else if (listed < kMaxListedHits) {
      ++listed;
      out.push_back(fmt::format("Hit {} was not used: {}.", h + 1, reason_of(hits[h])));
    } else {
      ++more;
    }
  }
  if (more > 0) out.push_back(fmt::format("{} more were not used; the table of hits says why.", counted(more, "hit")));
}

void add_signals(const pipeline::Analysis& analysis, Sentences& out) {
  const acquire::Record& record = analysis.record();
  const pipeline::AnalysisOptions& options = analysis.options();
  out.push_back(fmt::format("Force and {} were sampled at {} ({}).", counted(record.accel.size(), "response"),
                            rounded_frequency_text(record.fs_Hz), record.format));
  add_hits(analysis, out);
  if (!analysis.possible()) return;
  out.emplace_back(
      options.hits.gate_force
          ? "The force entered the transforms within a gate around each pulse, and as zero elsewhere (1.4)."
          : "The whole force record entered the transforms, with its noise.");
  const std::optional<pipeline::DecayCut> cut = analysis.decay_cut();
  if (cut) {
    out.push_back(
        fmt::format("The first {:.3g} s of each hit entered the transforms, of {:.3g} s: only a steady "
                    "background was seen after them.",
                    cut->used_s, cut->all_s));
  }
  out.push_back(
      options.exponential_end > 0
          ? fmt::format("An exponential window fell to {:g} at the end of each hit (2.2); the damping that it "
                        "adds was taken out exactly (3.5).",
                        options.exponential_end)
      : cut ? "No window was applied to the responses; the decay after these samples is part of the model (3.3)."
            : "No window was applied to the responses; the decay that a record cuts off is part of the model "
              "(3.3).");
  const auto& delays = analysis.corrected_delays();
  if (!delays.empty()) {
    out.emplace_back(options.delays.automatic ? "Delays of channels that the phases of the modes show were taken out."
                                              : "The stated delays of the channels were taken out.");
  }
}

const char* equation_of(frf::Estimator estimator) {
  return estimator == frf::Estimator::h1 ? "2.4" : estimator == frf::Estimator::h2 ? "2.5" : "2.6";
}

void add_frfs(const pipeline::Analysis& analysis, Sentences& out) {
  const acquire::LineRange& lines = analysis.lines();
  if (const acquire::FrfRecord* given = analysis.given_frfs()) {
    const std::string estimator = given->estimator.empty()
                                      ? "their estimator is not stated"
                                      : "their file states the estimator " + one_line(given->estimator, 60);
    out.push_back(fmt::format("{} of {} were given ({}), not averaged from hits here; {}.",
                              counted(given->frfs.size(), "FRF"), counted(lines.count, "line"), given->format,
                              estimator));
    if (given->decay_per_s > 0) {
      out.push_back(
          fmt::format("They were computed with an exponential window that decays by {} 1/s, as {}; the damping that it "
                      "adds was taken out exactly (3.5).",
                      significant(given->decay_per_s, 4),
                      analysis.options().exponential_end > 0 ? "the user stated" : "their file states"));
    }
    return;
  }
  const frf::Estimator estimator = analysis.options().estimator;
  const auto& frfs = analysis.frfs();
  const bool averaged = std::any_of(frfs.begin(), frfs.end(), [](const auto& one) { return one.frf.averages > 1; });
  out.push_back(
      fmt::format("{} by the estimator {} ({}){}; their lines are {} Hz apart.",
                  averaged ? "FRFs were averaged over the used hits of each point"
                           : "FRFs were computed from one hit of each point",
                  name_of(estimator), equation_of(estimator),
                  averaged ? ", with coherence (2.7) and standard deviation (2.8)"
                           : "; without a second hit, they have no coherence, and neither scatter between hits nor "
                             "errors of their place and direction enter the ±",
                  significant(lines.df_Hz(), 4)));
}

void add_deflection(const pipeline::ImpactTest& test, Sentences& out) {
  const auto any = [&](const auto& has) { return std::any_of(test.hits.begin(), test.hits.end(), has); };
  const auto by = [](metrics::DeflectionMethod method) {
    return [method](const pipeline::DeflectedHit& hit) { return hit.deflection.method == method; };
  };
  if (any(by(metrics::DeflectionMethod::drift_free))) {
    out.emplace_back(
        "The deflection is the double integral of the acceleration (7.1), without the bias and drift that the rest "
        "before the impact shows (7.3).");
  }
  if (any(by(metrics::DeflectionMethod::modal)))
    out.emplace_back("The deflection is the response of the modes to the measured force (7.8).");
  if (any([](const pipeline::DeflectedHit& hit) { return hit.deflection.rigid_motion_left_out; }))
    out.emplace_back("The rigid-body motion of a free structure is left out.");
}

void add_classes(const pipeline::Analysis& analysis, Sentences& out, bool shapes_decide) {
  const auto& all = analysis.classifications();
  const bool named = std::any_of(all.begin(), all.end(), [](const identify::ModeClassification& one) {
    return one.type != identify::ModeType::unknown;
  });
  if (shapes_decide) {
    out.emplace_back("Bending or hoop was decided from the waves of the mode shapes around the tube (5.7).");
  } else if (named) {
    out.push_back(
        fmt::format("Bending or hoop was decided from the ratio of the residues at two angles{}, with a "
                    "confidence by (6.6).",
                    analysis.options().classes.angles_assumed ? ", assumed 90° apart" : ""));
  }
}

void add_modes(const pipeline::Analysis& analysis, Sentences& out, bool shapes_decide) {
  const pipeline::AnalysisOptions& options = analysis.options();
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  out.push_back(fmt::format("Modes were sought from {} to {} Hz{}, in H1 whatever the estimator shown.",
                            hertz_text(low_Hz), hertz_text(high_Hz),
                            options.band_Hz ? "" : ", the band that the hammer excited (1.5)"));
  if (analysis.given_frfs() != nullptr)
    out.back() = fmt::format("Modes were sought from {} to {} Hz.", hertz_text(low_Hz), hertz_text(high_Hz));
  const auto& modes = analysis.modes();
  if (!options.modes.start_Hz.empty()) {
    const std::size_t count = options.modes.start_Hz.size();
    out.push_back(fmt::format("The user chose the modes at {} {}.", count, count == 1 ? "frequency" : "frequencies"));
  }
  if (options.modes.modes)
    out.push_back(fmt::format("The user limited the list to the clearest {}.", counted(*options.modes.modes, "mode")));
  const std::size_t others = analysis.fitted_modes().size() - modes.size();
  if (others > 0) {
    out.push_back(fmt::format("{} took part in the fit and {} not listed.", counted(others, "other mode"),
                              others == 1 ? "is" : "are"));
  }
  out.emplace_back(effort_sentence(options.modes.effort, modes));
  for (std::string& sentence : fit_sentences(modes)) out.push_back(std::move(sentence));
  add_classes(analysis, out, shapes_decide);
  if (!modes.empty()) {
    out.push_back(fmt::format("The fit was judged by FRFs synthesised from {}, with their FRAC (5.5).",
                              others > 0 ? "all fitted modes" : "the modes"));
  }
}

std::string cell(const std::optional<double>& value, double factor, const char* unit) {
  return value ? fmt::format("{:.4g}{}", *value * factor, unit) : "–";
}

}  // namespace

std::vector<std::string> method_sentences(const pipeline::Analysis& analysis, const MethodScope& scope) {
  Sentences out;
  if (analysis.given_frfs() == nullptr) add_signals(analysis, out);
  if (analysis.possible()) {
    add_frfs(analysis, out);
    if (scope.modes) add_modes(analysis, out, scope.shapes_decide);
    if (scope.deflection != nullptr) add_deflection(*scope.deflection, out);
  }
  return out;
}

TextTable channels_table(const pipeline::Analysis& analysis) {
  const acquire::Record& record = analysis.record();
  constexpr auto kRight = TextTable::Align::right;
  TextTable table({{"channel"}, {"name"}, {"stored in"}, {"factor", kRight}, {"angle", kRight}, {"position", kRight}});
  const auto add = [&](const std::string& channel, const acquire::SignalInfo& signal, const char* unit) {
    table.add({channel, one_line(signal.name, 100),
               signal.unit.empty() ? "–" : one_line(signal.unit, 40) + (signal.unit_assumed ? " (assumed)" : ""),
               fmt::format("{} {}", significant(signal.to_SI, 6), unit), cell(signal.angle_rad, kRadian_deg, "°"),
               cell(signal.position_m, 1, " m")});
  };
  if (analysis.given_frfs() == nullptr) add("force", record.force, "N");
  const bool given = analysis.given_frfs() != nullptr;
  for (std::size_t c = 0; c < record.accel.size(); ++c)
    add(fmt::format("response {}", c + 1), record.accel[c], given ? "(m/s²)/N" : "m/s²");
  return table;
}

}  // namespace percuss::report
