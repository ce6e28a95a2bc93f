#include "pipeline/warnings/truncation_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identify/noise/line_noise.hpp"
#include "pipeline/stages/blow_time.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMinPretriggerSamples = 32;  // samples from a record's beginning to the pulse
constexpr double kMinRingingNoise = 2e-4;     // least noise that hides the ringing, over the largest response
constexpr std::size_t kMinNoiseLines = 512;   // fewest spectral lines for an estimate of the noise

// Largest magnitude of a channel over the accepted hits, m/s².
double largest_response_mps2(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  double largest = 0;
  for (const AnalysedHit& hit : hits) {
    if (!hit.accepted || hit.responses.size() <= channel) continue;
    const Extremes& seen = hit.responses[channel].extremes;
    largest = std::max({largest, std::abs(seen.low), std::abs(seen.high)});
  }
  return largest;
}

// Whether some response is so quiet that the cut-off part of the filter's ringing exceeds its noise.
bool ringing_exceeds_noise(const identify::FrfDataset& set, const std::vector<AnalysedHit>& hits) {
  if (set.lines.count < kMinNoiseLines) return true;
  const identify::LineNoise noise(set);
  const std::size_t line = set.lines.count / 2;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const std::vector<double>& ff = set.points[set.channels[o].point].ff;
    if (ff.empty()) continue;
    const double noise_mps2 = noise.at(o, line) * std::sqrt(ff[line] / static_cast<double>(set.lines.samples));
    if (noise_mps2 < kMinRingingNoise * largest_response_mps2(hits, set.channels[o].channel)) return true;
  }
  return false;
}

// The modes that still ring when records of these lines end. The records begin `before_blow_s` before the blow.
std::string ringing_modes(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                          double window_decay_per_s, double before_blow_s = 0) {
  std::string ringing;
  for (const identify::Mode& mode : modes) {
    const double remaining = std::pow(identify::remaining_amplitude(mode.pole, lines, window_decay_per_s),
                                      1 - before_blow_s * lines.df_Hz());
    if (remaining > kRingingAmplitude)
      ringing += fmt::format("{}{:.1f} Hz ({:.1f} %)", ringing.empty() ? "" : ", ", mode.pole.freq_Hz, remaining * 100);
  }
  return ringing;
}

}  // namespace

std::vector<Warning> pretrigger_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                         const identify::FrfDataset& set) {
  double samples = kMinPretriggerSamples;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted) samples = std::min(samples, hit.hit.onset_s * record.fs_Hz - static_cast<double>(hit.hit.first));
  }
  if (samples >= kMinPretriggerSamples || !ringing_exceeds_noise(set, hits)) return {};
  return {with_remedy(
      {"short_pretrigger",
       fmt::format("a record begins {:.0f} samples before its pulse, within the ringing of the recorder's filter: "
                   "the noise is so low that a mode's true ± may be twice as large",
                   std::max(0.0, samples))},
      fmt::format("record {:.0f} samples before the pulse", 2 * kMinPretriggerSamples))};
}

std::vector<Warning> truncation_warnings(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                                         double window_decay_per_s, const std::optional<DecayCut>& cut) {
  const std::string ringing = ringing_modes(modes, lines, window_decay_per_s);
  if (ringing.empty()) return {};
  if (cut) {
    return {with_remedy(
        {"truncated_decay",
         fmt::format("the analysis uses the first {:.3g} s of each hit, of {:.3g} s: only a steady background is seen "
                     "after them. These modes then still have this part of their amplitude: {}; the fit of the damping "
                     "allows for the missing decay",
                     cut->used_s, cut->all_s, ringing),
         {"length"}},
        fmt::format("state a length of {:.3g} s to use all samples", cut->all_s))};
  }
  return {{"truncated_decay", "these modes still ring when the samples end, with this part of their amplitude: " +
                                  ringing + "; the fit of the damping allows for the missing decay"}};
}

std::vector<Warning> frf_truncation_warnings(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                                             double window_decay_per_s, const std::optional<double>& before_blow_s) {
  const std::string ringing = ringing_modes(modes, lines, window_decay_per_s, before_blow_s.value_or(0));
  if (ringing.empty()) return {};
  const std::string spacing = fmt::format(
      "the spacing of the spectral lines corresponds to records of {:.4g} s, at whose end these modes still "
      "rang with this part of their amplitude: {}. ",
      1 / lines.df_Hz(), ringing);
  if (before_blow_s) {
    return {
        {"truncated_decay",
         spacing + fmt::format("The records begin {:.3g} s before the blow: the FRFs hold no motion in this time. The "
                               "fit allows for the missing decay",
                               *before_blow_s)}};
  }
  std::string message =
      spacing +
      "The FRFs show no time before the blow. Without it, or the force, the fit cannot allow for the missing decay: "
      "residues may be off by as much. The damping may be too high by as much where the records begin before the blow, "
      "whatever its ±";
  std::string remedy = "analyse the records, or measure FRFs over a longer time";
  std::vector<OptionId> options;
  if (window_decay_per_s == 0) {
    message += ", and by more if the recorder applied an exponential window";
    remedy += "; state an exponential window of the recorder";
    options.emplace_back("exponential");
  }
  return {with_remedy({"truncated_decay", message, options, "", acquire::Severity::warn}, remedy)};
}

}  // namespace percuss::pipeline
