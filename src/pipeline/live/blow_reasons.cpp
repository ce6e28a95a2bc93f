#include "pipeline/live/blow_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "acquire/hits/contact_gate.hpp"
#include "acquire/hits/hits.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/findings/long_dropout.hpp"

namespace percuss::pipeline {
namespace {

using acquire::Finding, acquire::FindingCode, acquire::RowMark, acquire::Severity;

constexpr double kFullScale = 0.999;   // of the range: the converter may not reach its last step
constexpr double kLowBandwidth = 0.5;  // of the typical bandwidth
constexpr double kSilent = 8;          // standard deviations of the noise; Gaussian noise reaches 5
constexpr std::size_t kMinQuiet = 12;  // samples that give a noise level
constexpr double kMoving = 4;          // times the noise before a blow: the structure still moves
constexpr double kRinging = 0.0025;    // of the response: −52 dB, as acquire's response grade
constexpr double kSameLevel = 0.01;    // of the force: blows clipped at one level

// Whether the response moves before the blow by more than kMoving times its noise: the least motion before any blow
// so far.
bool rings_before(const BlowCircumstances& at, std::size_t channel) {
  return channel < at.rest.size() && at.rest[channel].before_mps2 > kMoving * at.rest[channel].noise_mps2;
}

BlowReason struck_again(const BlowCircumstances& at) {
  if (at.length_stated) {
    return {RowMark::struck_again, "struck again within the stated length",
            "wait between blows, or shorten the length"};
  }
  return {RowMark::struck_again, "struck again before the decay ended", "wait between blows"};
}

std::string hammer_question(const BlowContext& context) {
  return fmt::format(". Is the hammer on channel {}?", context.channels.force_number);
}

const Finding* find(const acquire::Hit& hit, FindingCode code) {
  const auto it = std::find_if(hit.findings.begin(), hit.findings.end(),
                               [&](const Finding& finding) { return finding.code == code; });
  return it == hit.findings.end() ? nullptr : &*it;
}

bool is_silent(std::span<const double> accel, std::size_t quiet) {
  const Extremes all = extremes_of(accel);
  if (all.low == all.high) return true;
  if (quiet < kMinQuiet) return false;
  const auto first = accel.first(quiet), last = accel.last(std::max(kMinQuiet, accel.size() / 20));
  const Spread before = spread_of({first.begin(), first.end()}), after = spread_of({last.begin(), last.end()});
  const double noise = std::min(before.robust_std, after.robust_std);  // the samples may begin in a slow pulse
  return noise > 0 && all.max_distance_from(before.median) < kSilent * noise;
}

BlowReason two_contacts(double ratio, double apart_s, bool smaller_first) {
  const std::string what = smaller_first
                               ? fmt::format("two contacts, the first {:.0f} % of the second and {:.0f} ms before it",
                                             ratio * 100, apart_s * 1e3)
                               : fmt::format("two contacts, the second {:.0f} % of the first and {:.0f} ms later",
                                             ratio * 100, apart_s * 1e3);
  return {RowMark::double_hit, what, "strike shorter: let the hammer bounce off"};
}

// The structure rings from the last blow, or from an earlier contact of this one.
BlowReason ringing(const BlowCircumstances& at) {
  if (at.contact_before > 0) return two_contacts(at.contact_before, at.contact_before_s, true);
  return {RowMark::still_ringing, "the structure was still ringing", "wait until it is still"};
}

// A recorder's filter removes the highest frequencies, whatever the tip.
std::string band_remedy(const BlowContext& context) {
  const double end_Hz = context.options.band_Hz->second;
  if (context.channels.description.fs_Hz < kRateOverBand * end_Hz)
    return fmt::format("record at {:.0f} Hz or more, or end the band lower", kRateOverBand * end_Hz);
  return "use a harder tip, or end the band lower";
}

}  // namespace

BlowReason judge_capture(const BlowSamples& samples, const BlowCircumstances& at, const BlowContext& context) {
  if (at.lost_samples) return {RowMark::lost_samples, "samples were lost during the blow", "repeat it"};
  if (at.row_ended) {
    return {RowMark::ended, "the row of the record ends before the length of the blows", "state a shorter length"};
  }
  // Beyond the end, samples repeat the last one.
  if (at.recording_ended) {
    if (at.struck_again) return struck_again(at);
    return {RowMark::ended, "the recording ended within the blow", "repeat it"};
  }
  if (at.no_numbers) {
    const std::size_t signal = *at.no_numbers;
    const std::string name = signal == 0 ? "the force" : name_of_channel(context.channels, signal - 1);
    return {RowMark::no_numbers, name + " has values that are no numbers", "check its cable and its input"};
  }
  const std::size_t quiet = at.pretrigger / 2;
  for (std::size_t c = 0; c + 1 < samples.size(); ++c) {
    if (!rings_before(at, c) && is_silent(samples[c + 1], quiet)) {
      return {RowMark::silent_channel, name_of_channel(context.channels, c) + " is silent",
              "check its cable and its input" + (at.none_accepted ? hammer_question(context) : "")};
    }
  }
  return {};
}

BlowReason judge_dropouts(const acquire::Hit& hit, const BlowSamples& samples, const BlowContext& context) {
  for (std::size_t c = 0; c + 1 < samples.size() && !hit.gated_N.empty(); ++c) {
    const auto dropout = find_long_dropout(samples[c + 1], hit.pulse_end);
    if (!dropout) continue;
    const double length_s = static_cast<double>(dropout->count) / context.channels.description.fs_Hz;
    return {RowMark::silent_channel,
            fmt::format("{} drops out for {:.3g} ms", name_of_channel(context.channels, c), 1e3 * length_s),
            "check its cable and its connector"};
  }
  return {};
}

BlowReason judge_range(const BlowCircumstances& at, const BlowContext& context) {
  for (std::size_t s = 0; s < at.range.size(); ++s) {
    if (at.range[s] < kFullScale) continue;
    if (s == 0)
      return {RowMark::force_overload, "the force reached full scale", "lower the gain of the hammer, or hit softer"};
    return {RowMark::response_overload, name_of_channel(context.channels, s - 1) + " reached full scale",
            "lower its gain, or hit softer"};
  }
  return {};
}

BlowReason judge_force(const acquire::Hit& hit, const BlowCircumstances& at, const BlowContext& context) {
  const auto rejected = [&](FindingCode code) {
    const Finding* const finding = find(hit, code);
    return finding != nullptr && finding->severity == Severity::reject ? finding : nullptr;
  };
  if (rejected(FindingCode::late_trigger) != nullptr)
    return {RowMark::no_pulse, "the samples begin within the pulse", "state a longer pre-trigger"};
  const bool clipped_as_before = std::abs(std::abs(hit.peak_N) - at.clipped_at_N) < kSameLevel * at.clipped_at_N;
  if (rejected(FindingCode::overload) != nullptr || rejected(FindingCode::force_clipped) != nullptr ||
      clipped_as_before)
    return {RowMark::force_overload, "the force is clipped", "lower the gain of the hammer, or hit softer"};
  if (const Finding* const second = rejected(FindingCode::double_hit)) {
    return two_contacts(second->value, second->delay_s.value_or(0), second->before_main);
  }
  if (at.contact_before > acquire::kMaxSecondContact) return two_contacts(at.contact_before, at.contact_before_s, true);
  if (at.struck_again) return struck_again(at);
  if (const Finding* const lasting = rejected(FindingCode::no_pulse); lasting != nullptr && !hit.gated_N.empty()) {
    return {
        RowMark::no_pulse,
        fmt::format("no clean pulse: the force is still at {:.0f} % of its peak 25 ms later", lasting->value * 100),
        fmt::format("look for hum, an offset or a loose part in the force, and check that the hammer is on channel {}",
                    context.channels.force_number)};
  }
  if (hit.gated_N.empty() || acquire::rejects(hit.findings)) {
    std::string remedy = "strike freely and once";
    if (at.all_rejected) remedy += hammer_question(context);
    return {RowMark::no_pulse, "no clean pulse", remedy};
  }
  const double peak_N = std::abs(hit.peak_N);
  if (at.typical_peak_N > 0 && peak_N < kWeakBlow * at.typical_peak_N) {
    return {RowMark::weak, fmt::format("too weak, {:.0f} % of the usual force", 100 * peak_N / at.typical_peak_N),
            "hit harder"};
  }
  if (context.options.band_Hz && hit.bandwidth_Hz < context.options.band_Hz->second) {
    return {RowMark::low_bandwidth,
            fmt::format("the force reaches {:.0f} Hz, the band ends at {:.0f} Hz", hit.bandwidth_Hz,
                        context.options.band_Hz->second),
            band_remedy(context)};
  }
  if (hit.bandwidth_Hz < kLowBandwidth * at.typical_bandwidth_Hz) {
    return {RowMark::low_bandwidth,
            fmt::format("the force reaches {:.0f} Hz, usually {:.0f} Hz", hit.bandwidth_Hz, at.typical_bandwidth_Hz),
            "strike squarely, and check the tip"};
  }
  return {};
}

RowMark mark_of(const AnalysedHit& hit) {
  if (hit.accepted) return RowMark::none;
  if (find(hit.hit, FindingCode::outlier) != nullptr) return RowMark::outlier;
  const bool clipped =
      find(hit.hit, FindingCode::overload) != nullptr || find(hit.hit, FindingCode::force_clipped) != nullptr;
  return clipped ? RowMark::force_overload : RowMark::no_pulse;
}

BlowReason judge_responses(const AnalysedHit& hit, const BlowCircumstances& at, const BlowContext& context) {
  for (std::size_t c = 0; c < hit.responses.size(); ++c) {
    const acquire::ResponseGrade& grade = hit.responses[c];
    if (grade.clipped_samples > 0) {
      return {RowMark::response_overload, name_of_channel(context.channels, c) + " is clipped",
              "lower its gain, or hit softer"};
    }
    if (grade.dead) {
      return {RowMark::silent_channel, name_of_channel(context.channels, c) + " is silent",
              "check its cable and its input"};
    }
    if (grade.rings_before) return ringing(at);
  }
  if (at.during_previous) return ringing(at);
  switch (mark_of(hit)) {
    case RowMark::none:
      return {};
    case RowMark::outlier:
      return {RowMark::outlier, "unlike the other blows at this point", "strike the same place in the same direction"};
    case RowMark::force_overload:
      return {RowMark::force_overload, "the force is clipped", "lower the gain of the hammer, or hit softer"};
    default:
      return {RowMark::no_pulse, "no clean pulse", "strike freely and once"};
  }
}

double motion_before(const BlowSamples& samples, const BlowCircumstances& at) {
  double largest = 0;
  for (std::size_t c = 0; c < at.rest.size(); ++c) {
    if (!rings_before(at, c)) continue;
    const std::span<const double> accel(samples[c + 1]);
    const std::size_t first = std::min(at.pretrigger, accel.size());
    const double start_mps2 = rms_about_mean(accel.subspan(first, std::min(accel.size() / 20, accel.size() - first)));
    if (start_mps2 > 0) largest = std::max(largest, at.rest[c].before_mps2 / start_mps2);
  }
  return largest;
}

BlowReason judge_motion(double motion, const BlowCircumstances& at) {
  return motion > kRinging ? ringing(at) : BlowReason{};
}

}  // namespace percuss::pipeline
