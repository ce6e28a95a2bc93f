#include "pipeline/warnings/channel_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "acquire/record/note_codes.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinQuiet = 64;  // samples before a hit, which determine its noise to a tenth
constexpr std::size_t kMinPoints = 3;  // of a survey that shows what is usual
constexpr double kClearHeight = 30;    // standard deviations of the noise, which a clear response reaches
constexpr double kDeadShare = 0.1;     // of the hits: fewer dead ones change a ratio by less than its other errors
constexpr double kNoiseExtreme = 6;    // the same, which noise does not reach: a million samples of white noise reach 5

// Indices of the accepted hits in which the channel is constant, and the number of those in which it moves.
struct DeadHits {
  std::vector<std::size_t> hits;
  std::size_t moving = 0;
  bool many() const {
    return !hits.empty() && static_cast<double>(hits.size()) >= kDeadShare * static_cast<double>(hits.size() + moving);
  }
};

DeadHits dead_hits(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  DeadHits out;
  for (const std::size_t h : accepted_hits(hits)) {
    if (hits[h].responses.size() <= channel) continue;
    if (hits[h].responses[channel].dead) {
      out.hits.push_back(h);
    } else {
      ++out.moving;
    }
  }
  return out;
}

// The coarsest step over the accepted hits, as a fraction of the channel's largest response to the same hit.
double coarsest_step(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  double step = 0;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted && hit.responses.size() > channel) step = std::max(step, hit.responses[channel].coarse_step);
  }
  return step;
}

// The largest distance of a response from its level before the hit, over the noise there. Nothing if too few samples
// before the hit determine the noise.
std::optional<double> height_over_noise(const HitResponses& responses, std::size_t hit, std::size_t channel) {
  if (channel >= responses.of[hit].size()) return std::nullopt;
  const HitResponse& response = responses.of[hit][channel];
  if (!response.rest.before || response.rest.quiet < kMinQuiet || !(response.rest.noise > 0)) return std::nullopt;
  return response.grade.extremes.max_distance_from(*response.rest.before) / response.rest.noise;
}

// Whether the channel clearly responds to these hits, in the median.
bool responds(const std::vector<std::size_t>& hits, const HitResponses& responses, std::size_t channel) {
  std::vector<double> heights;
  for (const std::size_t h : hits) {
    if (const auto height = height_over_noise(responses, h, channel)) heights.push_back(*height);
  }
  return !heights.empty() && median(heights) >= kClearHeight;
}

// Whether none of these hits moves the channel above the noise before the hit.
bool stays_in_noise(const std::vector<std::size_t>& hits, const HitResponses& responses, std::size_t channel) {
  return !hits.empty() && std::all_of(hits.begin(), hits.end(), [&](std::size_t h) {
    const std::optional<double> height = height_over_noise(responses, h, channel);
    return height && *height < kNoiseExtreme;
  });
}

}  // namespace

bool has_reversed_phase(const acquire::Record& record) {
  return std::any_of(record.notes.begin(), record.notes.end(),
                     [](const Message& note) { return note.code == acquire::kReversedPhase; });
}

std::vector<Warning> input_warnings(const acquire::Record& record) {
  std::vector<Warning> out;
  for (const Message& note : record.notes) {
    if (note.code == acquire::kReversedPhase) {
      out.push_back(with_remedy({"reversed_phase",
                                 "the phase of the FRFs rises through the resonances, so that they are probably for "
                                 "exp(−jωt), and percuss needs exp(+jωt): modes are missing or wrong"},
                                "reverse the sign of their imaginary part (or of their phase), or exchange the two "
                                "signals of the cross spectrum in the program that computed them"));
      continue;
    }
    out.push_back({.code = "input", .message = note.text, .options = note.options});
    if (note.information) out.back().severity = acquire::Severity::info;
  }
  return out;
}

void remove_consequences_of_reversed_phase(std::vector<Warning>& warnings) {
  constexpr std::array<std::string_view, 13> kConsequences{
      "no_modes", "unclaimed_peaks",    "unmodelled_poles",   "start_refused", "start_between",
      "crowded",  "local_fits",         "model_misfit",       "frac",          "below_band",
      "reversed", "driving_point_sign", "angles_contradicted"};
  std::erase_if(warnings, [&](const Warning& warning) {
    return std::find(kConsequences.begin(), kConsequences.end(), warning.code) != kConsequences.end();
  });
}

std::vector<Warning> channel_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                      const std::vector<bool>& types_need) {
  std::vector<Warning> out;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const DeadHits dead = dead_hits(hits, c);
    if (dead.hits.empty()) continue;
    const char* const consequence = dead.moving == 0        ? "it shows no modes"
                                    : dead.hits.size() == 1 ? "this hit makes its FRFs and residues too small"
                                                            : "these hits make its FRFs and residues too small";
    const bool no_types = dead.many() && c < types_need.size() && types_need[c];
    out.push_back(with_remedy({"dead_channel",
                               fmt::format("{} is constant in {}: {}{}", one_line(record.accel[c].name, kMaxNameBytes),
                                           dead.moving > 0 ? hit_list(dead.hits) : "every accepted hit", consequence,
                                           no_types ? kNoTypesWithoutIt : ""),
                               {"accel_channel"}},
                              "check its cable, or choose the other channels"));
  }
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const double step = coarsest_step(hits, c);
    if (!(step > 0)) continue;
    out.push_back(
        with_remedy({"coarse_steps",
                     fmt::format("{} is quantised in steps of {:.2g} % of its largest response, larger than its noise: "
                                 "modes may be off by more than their ±, and weak ones may be artefacts",
                                 one_line(record.accel[c].name, kMaxNameBytes), 100 * step)},
                    "use the recorder's full range and resolution"));
  }
  return out;
}

std::vector<Warning> silent_response_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                              const HitResponses& responses) {
  std::vector<Warning> out;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    if (!stays_in_noise(accepted_hits(hits), responses, c)) continue;
    out.push_back(with_remedy({"dead_channel",
                               fmt::format("{} does not respond: after the hits, no sample exceeds {:.0f} standard "
                                           "deviations of its noise before them",
                                           one_line(record.accel[c].name, kMaxNameBytes), kNoiseExtreme),
                               {"accel_channel"}},
                              "check its cable and its mounting, or choose the other channels"));
  }
  return out;
}

std::vector<ChannelMotion> channel_motions(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                           const HitResponses& responses) {
  const std::vector<std::size_t> used = accepted_hits(hits);
  std::vector<ChannelMotion> out;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    out.push_back({.constant = dead_hits(hits, c).many(),
                   .responds = responds(used, responses, c),
                   .still = stays_in_noise(used, responses, c)});
  }
  return out;
}

std::vector<SilentPoint> silent_points(const std::vector<AnalysedHit>& hits, const HitResponses& responses) {
  std::map<int, std::vector<std::size_t>> points;
  std::size_t channels = 0;
  for (const std::size_t h : accepted_hits(hits)) {
    points[hits[h].point].push_back(h);
    channels = std::max(channels, responses.of[h].size());
  }
  std::vector<SilentPoint> out;
  if (points.size() < kMinPoints) return out;
  for (std::size_t c = 0; c < channels; ++c) {
    if (!responds(accepted_hits(hits), responses, c)) continue;
    for (const auto& [point, of_point] : points) {
      if (stays_in_noise(of_point, responses, c)) out.push_back({.point = point, .channel = c, .hits = of_point});
    }
  }
  return out;
}

std::vector<Warning> silent_point_warnings(const acquire::Record& record, const std::vector<SilentPoint>& silent,
                                           const PointNames& names) {
  std::vector<Warning> out;
  for (const SilentPoint& one : silent) {
    out.push_back(with_remedy({"dead_channel",
                               fmt::format("{} shows only noise at point {} in {}: no sample exceeds {:.0f} standard "
                                           "deviations of its noise before the hit. Its shapes are wrong there, "
                                           "unless the structure is at rest at this point",
                                           one_line(record.accel[one.channel].name, kMaxNameBytes),
                                           names.name(one.point), hit_list(one.hits), kNoiseExtreme),
                               {},
                               "",
                               acquire::Severity::warn},
                              "check its cable and its mounting, and measure this point again"));
  }
  return out;
}

}  // namespace percuss::pipeline
