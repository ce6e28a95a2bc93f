#include "pipeline/warnings/role_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "acquire/hits/pulse_shape.hpp"
#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "pipeline/hits/responding_channel.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxExamined = 16;  // hits of a channel
// Share of the energy around a pulse that lies within it. A hammer with a noise of 1 % of its peak has 0.97, the
// response of a bat at the struck point up to 0.93 and elsewhere below 0.5.
constexpr double kMinPulseShare = 0.95;
constexpr double kMaxOpposite = 0.3;    // largest sample of the other sign over the peak: ringing of a steep filter
constexpr double kPulsesAround = 20;    // lengths of the pulse on either side, over which its energy is compared
constexpr double kRinging_s = 0.025;    // least time on either side: after the pulse, a response still moves
constexpr double kMinRinging = 10;      // mean square of the force after the pulse over the one before it
constexpr std::size_t kMinBefore = 16;  // samples before the pulse that show the noise
constexpr std::size_t kFinalPart = 10;  // the last tenth of a row shows its final level, at most kMaxFinal samples
constexpr std::size_t kMaxFinal = 4096;

bool lacks_pulse(const AnalysedHit& hit) {
  return !hit.accepted && !hit.by_user && acquire::has_finding(hit.hit.findings, acquire::FindingCode::no_pulse);
}

// The record with a response in the place of the force.
acquire::Record with_force_from(const acquire::Record& record, std::size_t channel) {
  acquire::Record out = record;
  out.contiguous.clear();
  out.read_force_N = [&record, channel](std::size_t row, std::size_t first, std::span<double> samples) {
    record.read_accel_mps2(row, channel, first, samples);
  };
  return out;
}

double mean_square(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum += value * value;
  return x.empty() ? 0 : sum / static_cast<double>(x.size());
}

// Part of a row around a pulse, in samples of the row.
struct PulseRange {
  std::size_t begin = 0, first = 0, end = 0, last = 0;  // [begin, first) before, [first, end) pulse, [end, last) after
};

PulseRange range_around(const acquire::Hit& hit, std::size_t row_samples, double fs_Hz) {
  const double around_s = std::max(kPulsesAround * hit.pulse_s, kRinging_s);
  const auto reach = static_cast<std::size_t>(around_s * fs_Hz) + 1;
  const std::size_t end = std::min(std::max(hit.pulse_end, hit.peak + 1), row_samples);
  return {.begin = hit.gate_first - std::min(hit.gate_first, reach),
          .first = hit.gate_first,
          .end = end,
          .last = std::min(row_samples, end + reach)};
}

// The samples [range.begin, range.last) around their level before the pulse; if too few samples precede the pulse,
// around their median.
template <class Read>
std::vector<double> samples_around(const PulseRange& range, Read read) {
  std::vector<double> x(range.last - range.begin);
  read(range.begin, std::span(x));
  const std::size_t quiet = range.first - range.begin;
  const auto before = std::span<const double>(x).first(quiet);
  const double rest =
      quiet < kMinBefore ? median(x) : std::accumulate(before.begin(), before.end(), 0.0) / static_cast<double>(quiet);
  for (double& value : x) value -= rest;
  return x;
}

// Energy within the pulse over the energy around it, without the noise.
double pulse_share(std::span<const double> x, const PulseRange& range) {
  const auto before = x.first(range.first - range.begin), pulse = x.subspan(before.size(), range.end - range.first);
  const double noise = before.size() < kMinBefore ? 0 : mean_square(before);
  const auto energy = [&](std::span<const double> part) {
    return (mean_square(part) - noise) * static_cast<double>(part.size());
  };
  const double within = energy(pulse), around = within + std::max(0.0, energy(x.subspan(range.end - range.begin)));
  return around > 0 ? within / around : 0;
}

// Whether a signal rises and falls like a hammer's force: to one side, and with little motion after it.
bool is_pulse(std::span<const double> x, const PulseRange& range) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double larger = std::max(*high, -*low), smaller = std::min(*high, -*low);
  return smaller <= kMaxOpposite * larger && pulse_share(x, range) >= kMinPulseShare;
}

// Mean square of the force at the end of a row, about its mean.
double final_level(const acquire::Record& record, std::size_t row) {
  const std::size_t samples = record.rows[row].samples;
  std::vector<double> x(std::min(kMaxFinal, samples / kFinalPart));
  record.read_force_N(row, samples - x.size(), x);
  const double deviation = x.empty() ? 0 : rms_about_mean(x);
  return x.size() < kMinBefore ? std::numeric_limits<double>::infinity() : deviation * deviation;
}

// Whether the force moves after the pulse of another signal: more than before the pulse, or than at the end of the row
// (`final_square`), since a short pre-trigger holds only the ringing of the filter.
bool rings_after(std::span<const double> force, const PulseRange& range, double final_square) {
  const auto before = force.first(range.first - range.begin), after = force.subspan(range.end - range.begin);
  const double quiet = before.size() < kMinBefore ? final_square : std::min(final_square, mean_square(before));
  return after.size() >= kMinBefore && mean_square(after) > kMinRinging * quiet;
}

// The share of examined hits at which the response shows a hammer's pulse and the force rings after it.
double hammer_share(const acquire::Record& record, std::size_t channel, const acquire::HitOptions& options) {
  const std::vector<acquire::Hit> hits = acquire::find_hits(
      with_force_from(record, channel), {.from_s = options.from_s, .to_s = options.to_s, .gate_force = true});
  const std::size_t examined = std::min(kMaxExamined, hits.size());
  std::size_t hammers = 0;
  for (std::size_t i = 0; i < examined; ++i) {
    const acquire::Hit& hit = hits[i * hits.size() / examined];
    if (hit.gated_N.empty()) continue;
    const PulseRange range = range_around(hit, record.rows[hit.row].samples, record.fs_Hz);
    const auto accel = samples_around(
        range, [&](std::size_t first, std::span<double> out) { record.read_accel_mps2(hit.row, channel, first, out); });
    if (!is_pulse(accel, range)) continue;
    const auto force = samples_around(
        range, [&](std::size_t first, std::span<double> out) { record.read_force_N(hit.row, first, out); });
    if (!is_pulse(force, range) && rings_after(force, range, final_level(record, hit.row))) ++hammers;
  }
  return examined > 0 ? static_cast<double>(hammers) / static_cast<double>(examined) : 0;
}

bool states_unit(const acquire::SignalInfo& signal, Quantity quantity) {
  const auto unit = parse_unit(signal.unit);
  return !signal.unit_assumed && unit && unit->quantity == quantity;
}

// "force and accel 2": the accelerations once the hammer and the force have changed places.
std::string accelerations_without(const acquire::Record& record, std::size_t hammer) {
  constexpr std::size_t kListed = 6;
  const std::string force = one_line(record.force.name, kMaxNameBytes);
  if (record.accel.size() > kListed) return force + " in its place among the accelerations";
  std::string list;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const char* const between = c == 0 ? "" : c + 1 == record.accel.size() ? " and " : ", ";
    list += between + (c == hammer ? force : one_line(record.accel[c].name, kMaxNameBytes));
  }
  return list + (record.accel.size() == 1 ? " as the acceleration" : " as the accelerations");
}

}  // namespace

std::vector<Warning> role_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                   const acquire::HitOptions& options) {
  const auto lacking = static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), lacks_pulse));
  if (!record.has_force || 2 * lacking <= hits.size()) return {};
  constexpr double kMinHammerShare = 0.5;
  std::optional<std::size_t> hammer;
  double largest = kMinHammerShare;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const double share = hammer_share(record, c, options);
    if (share <= largest) continue;
    largest = share;
    hammer = c;
  }
  const std::string force = one_line(record.force.name, kMaxNameBytes);
  if (hammer) {
    const std::string response = one_line(record.accel[*hammer].name, kMaxNameBytes);
    Warning warning{
        "swapped_channels",
        fmt::format("{} looks like the hammer and {} like a response: the channels are swapped", response, force),
        {"force_channel", "accel_channel"}};
    std::string remedy = fmt::format("name {} as the force, and {}", response, accelerations_without(record, *hammer));
    // The units of the file belong to the roles that it states, and the reader refuses them for other roles.
    if (states_unit(record.force, Quantity::force) || states_unit(record.accel[*hammer], Quantity::acceleration)) {
      warning.options.insert(warning.options.end(), {"force_unit", "unit", "force_scale", "accel_scale"});
      remedy +=
          "; state the units, too, because those of the file belong to its own roles. If the plugs were exchanged, the "
          "recorder scaled each signal with the sensitivity of the other sensor, and no unit is right: state the "
          "scales "
          "(N and m/s² per number of the file) instead";
    }
    return {with_remedy(std::move(warning), remedy)};
  }
  if (lacking < hits.size() || options.trigger_N) return {};
  const auto moving = responding_channel(record, hits.front().hit);
  const std::string responds =
      moving ? fmt::format(", while {} responds", one_line(record.accel[*moving].name, kMaxNameBytes)) : "";
  return {with_remedy(
      {"no_pulse",
       fmt::format("{} shows no hammer pulse at {}{}: the hammer's channel seems dead", force,
                   hits.size() == 1 ? std::string("the only hit") : fmt::format("any of {} hits", hits.size()),
                   responds),
       {"force_channel"}},
      "check the hammer's cable, its sensitivity and the trigger, and which channel is the force")};
}

}  // namespace percuss::pipeline
