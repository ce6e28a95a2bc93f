#include "acquire/hits/contact_gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

// A hammer rings for some milliseconds, a structure for longer.
constexpr double kRingsFrom_s = 0.025, kRingsTo_s = 0.05;
constexpr double kMaxRinging = 0.03;         // of the peak: median of |force − its median|
constexpr std::size_t kMinRinging = 16;      // samples
constexpr std::size_t kMedianSamples = 200;  // give a median of noise to 9 % of its standard deviation
// Of the peak: change of the force from before the pulse to after it. A hammer that leans on the structure exceeds this
// limit, a drift of the channel does not.
constexpr double kMaxLevelChange = 0.1;
// Of the peak, against the pulse: an AC coupling of 1.6 Hz swings back by 5 % after a haversine of 10 ms, and by 20 %
// after one of 40 ms.
constexpr double kMaxUndershoot = 0.25;

// The change of the force from before the pulse to after it, as part of the peak.
double level_change(std::span<const double> before, double after_N, double peak_N) {
  const double rest_N = before.size() < kMinRinging ? 0 : median(subsampled(before, kMedianSamples));
  return (after_N - rest_N) / peak_N;
}

}  // namespace

void gate_force(Hit& hit, std::span<const double> x, const Gate& pulse, const FurtherForce& further,
                std::size_t offset) {
  std::vector<Gate> parts{{.first = pulse.first, .end = std::max(pulse.end, further.end - offset)}};
  for (const SecondPulse& contact : further.contacts) {
    if (contact.spike || contact.gate.end <= offset) continue;
    parts.push_back({.first = std::max(contact.gate.first, offset) - offset, .end = contact.gate.end - offset});
  }
  Gate all = parts.front();
  for (const Gate& part : parts) all = {.first = std::min(all.first, part.first), .end = std::max(all.end, part.end)};
  hit.gate_first = hit.first + all.first;
  hit.pulse_end = hit.first + pulse.end;
  hit.tail_end = hit.first + parts.front().end;
  hit.gated_N.assign(all.end - all.first, 0.0);
  for (const Gate& part : parts) {
    const auto from = x.subspan(part.first, part.end - part.first);
    std::copy(from.begin(), from.end(), hit.gated_N.begin() + static_cast<std::ptrdiff_t>(part.first - all.first));
  }
}

void grade_second_pulse(Hit& hit, const std::vector<SecondPulse>& contacts, double fs_Hz) {
  const auto second = std::max_element(contacts.begin(), contacts.end(),
                                       [](const SecondPulse& a, const SecondPulse& b) { return a.ratio < b.ratio; });
  if (second == contacts.end()) return;
  const double delay_s = std::abs(second->delay_samples) / fs_Hz;
  const std::string when = second->delay_samples < 0 ? fmt::format("{:.2f} ms before the main one", delay_s * 1e3)
                                                     : fmt::format("after {:.2f} ms", delay_s * 1e3);
  const char* what = second->spike ? "spike or short second hit" : "second hit";
  hit.findings.push_back({.code = FindingCode::double_hit,
                          .severity = second->ratio > kMaxSecondContact ? Severity::reject : Severity::info,
                          .value = second->ratio,
                          .message = fmt::format("{} {}, {:.{}f} % of the main one", what, when, second->ratio * 100,
                                                 second->ratio < kMaxSecondContact ? 2 : 1),
                          .delay_s = delay_s,
                          .before_main = second->delay_samples < 0});
}

void grade_lasting_force(Hit& hit, std::span<const double> x, std::size_t peak, double fs_Hz) {
  const auto begin = peak + static_cast<std::size_t>(kRingsFrom_s * fs_Hz);
  const auto end = peak + static_cast<std::size_t>(kRingsTo_s * fs_Hz);
  if (end > x.size() || end - begin < kMinRinging) return;
  const auto after = x.subspan(begin, end - begin);
  std::vector<double> sizes = subsampled(after, kMedianSamples);
  const double middle = median(sizes);
  for (double& value : sizes) value = std::abs(value - middle);
  const double rings = median(std::move(sizes)) / std::abs(x[peak]);
  const double change = level_change(x.first(hit.gate_first - hit.first), middle, x[peak]);
  if (rings < kMaxRinging && change < kMaxLevelChange && change > -kMaxUndershoot) return;
  const double ratio = std::max(rings, std::abs(change));
  hit.findings.push_back(
      {.code = FindingCode::no_pulse,
       .severity = Severity::reject,
       .value = ratio,
       .message = fmt::format("no hammer pulse: the force is still at {:.0f} % of its peak {:.0f} ms "
                              "later; is this a response in the place of the force?",
                              ratio * 100, kRingsFrom_s * 1e3),
       .options = {"force_channel"}});
}

}  // namespace percuss::acquire
