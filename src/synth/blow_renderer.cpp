#include "synth/blow_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "synth/anti_alias_filter.hpp"
#include "synth/random_stream.hpp"
#include "synth/structure.hpp"

namespace percuss::synth {
namespace {

constexpr std::uint64_t kBlowStream = 11, kSessionNoiseStream = 12;
constexpr double kBlowDecayExponent = 20;  // a decay ends below e^−20: a sixtieth of a step of 24 bits
constexpr double kOrdinaryHeadroom = 1.5;  // full scale over the largest value of an ordinary blow
constexpr double kClippedPeak = 1.8;       // relative to the full scale
constexpr double kWeakPeak = 0.04;         // relative to the usual peak
// Second pulse of a double hit: relative to the first pulse, and after it.
constexpr double kSecondPeak = 0.5, kSecondDelay_s = 0.012;

}  // namespace

BlowRenderer::BlowRenderer(const SimulatedSession& session)
    : session_(session), full_scales_(channels()), noise_(channels()), order_(session.blows.size()) {
  const SynthSpec& spec = session_.spec;
  for (const SynthMode& mode : spec.modes) poles_.push_back({mode.freq_Hz, mode.damping_ratio});
  for (std::size_t p = 0; p < spec.points.size(); ++p) {
    residues_.emplace_back();
    rigid_.emplace_back();
    for (std::size_t s = 0; s < spec.sensors.size(); ++s) {
      rigid_[p].push_back(rigid_line_per_kg(spec, p, s));
      residues_[p].emplace_back();
      for (std::size_t r = 0; r < spec.modes.size(); ++r) residues_[p][s].push_back(residue_per_kg(spec, r, p, s));
    }
  }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return session_.blows[a].onset_s < session_.blows[b].onset_s; });
  set_levels();
}

// Sets full scales and noise by the strongest blow that the spec allows, at the point where each channel moves most.
void BlowRenderer::set_levels() {
  const SynthSpec& spec = session_.spec;
  constexpr double kSeconds = 0.25;
  const auto frames = static_cast<std::size_t>(kSeconds * spec.fs_Hz);
  Active blow;
  blow.pulses = {{spec.pulse.kind, 0.01, spec.pulse.width_s, spec.pulse.peak_N * (1 + spec.pulse.peak_spread)}};
  std::vector<double> rms(channels());
  for (blow.point = 0; blow.point < spec.points.size(); ++blow.point) {
    std::vector<double> values(frames * channels());
    add_blow(blow, 0, values);
    for (std::size_t c = 0; c < channels(); ++c) {
      double squares = 0;
      for (std::size_t i = c; i < values.size(); i += channels()) {
        full_scales_[c] = std::max(full_scales_[c], kOrdinaryHeadroom * std::abs(values[i]));
        squares += values[i] * values[i];
      }
      rms[c] = std::max(rms[c], std::sqrt(squares / static_cast<double>(frames)));
    }
  }
  noise_[0] = spec.noise.force * full_scales_[0] / kOrdinaryHeadroom;
  if (spec.recorder.force_range_N) full_scales_[0] = *spec.recorder.force_range_N;
  for (std::size_t c = 1; c < channels(); ++c) {
    noise_[c] = spec.noise.accel * rms[c];
    if (spec.recorder.accel_range_mps2) full_scales_[c] = *spec.recorder.accel_range_mps2;
    if (!(full_scales_[c] > 0)) full_scales_[c] = 1;
  }
}

BlowRenderer::Active BlowRenderer::active_of(std::size_t number) const {
  const SynthSpec& spec = session_.spec;
  const SimulatedBlow& blow = session_.blows[number];
  RandomStream random{spec.seed, kBlowStream, number};
  const double between_samples_s = random.uniform() / spec.fs_Hz;
  const double width_s = spec.pulse.width_s * (1 + random.uniform(-spec.pulse.width_spread, spec.pulse.width_spread));
  double peak_N = spec.pulse.peak_N * (1 + random.uniform(-spec.pulse.peak_spread, spec.pulse.peak_spread));
  if (blow.kind == BlowKind::weak) peak_N = kWeakPeak * spec.pulse.peak_N;
  if (blow.kind == BlowKind::clipped) peak_N = kClippedPeak * full_scales_[0];
  Active out{.point = blow.point};
  out.pulses.push_back({spec.pulse.kind, blow.onset_s + between_samples_s, width_s, peak_N});
  if (blow.kind == BlowKind::double_hit) {
    Pulse second = out.pulses.front();
    second.onset_s += kSecondDelay_s;
    second.peak_N *= kSecondPeak;
    out.pulses.push_back(second);
  }
  double longest_s = 0;
  for (const SynthPole& pole : poles_)
    longest_s = std::max(longest_s, kBlowDecayExponent / (2 * std::numbers::pi * pole.freq_Hz * pole.damping_ratio));
  out.last_frame = (out.pulses.back().onset_s + width_s + longest_s) * spec.fs_Hz + kFilterHalfWidth + 1;
  return out;
}

void BlowRenderer::activate(double last_frame) {
  for (; next_blow_ < order_.size(); ++next_blow_) {
    const double onset = session_.blows[order_[next_blow_]].onset_s * session_.spec.fs_Hz;
    if (onset - kFilterHalfWidth - 2 > last_frame) return;
    active_.push_back(active_of(order_[next_blow_]));
  }
}

void BlowRenderer::add_blow(const Active& blow, std::uint64_t first, std::span<double> out) const {
  const std::size_t count = out.size() / channels(), sensors = session_.spec.sensors.size();
  const double gain = session_.spec.recorder.force_gain;
  for (const Pulse& pulse : blow.pulses) {
    const PulseBasis basis = pulse_basis(pulse, session_.spec.fs_Hz, poles_, static_cast<std::size_t>(first), count);
    const auto add = [&](const std::vector<double>& values, double scale, std::size_t channel) {
      const std::size_t skipped = basis.first - static_cast<std::size_t>(first);
      for (std::size_t i = 0; i < values.size(); ++i) out[(skipped + i) * channels() + channel] += scale * values[i];
    };
    add(basis.force_N, gain, 0);
    for (std::size_t a = 0; a < session_.accels; ++a) {
      const std::size_t sensor = a % sensors;
      double direct = rigid_[blow.point][sensor];
      for (std::size_t r = 0; r < poles_.size(); ++r) {
        const double residue = residues_[blow.point][sensor][r];
        direct += residue;
        add(basis.regular_N[r], residue * gain, 1 + a);
      }
      add(basis.force_N, direct * gain, 1 + a);
    }
  }
}

void BlowRenderer::render(std::uint64_t first, std::span<double> out) {
  const std::size_t count = out.size() / channels();
  const auto last_frame = static_cast<double>(first + count);
  std::fill(out.begin(), out.end(), 0.0);
  activate(last_frame);
  std::erase_if(active_, [&](const Active& blow) { return blow.last_frame < static_cast<double>(first); });
  for (const Active& blow : active_) add_blow(blow, first, out);
  std::vector<double> noise(count);
  for (std::size_t c = 0; c < channels(); ++c) {
    std::fill(noise.begin(), noise.end(), 0.0);
    if (noise_[c] > 0) RandomStream{session_.spec.seed, kSessionNoiseStream, first, c}.add_normal(noise_[c], noise);
    const bool silent = std::find(session_.silent_channels.begin(), session_.silent_channels.end(), c) !=
                        session_.silent_channels.end();
    const SynthRecorder& recorder = session_.spec.recorder;
    const auto clip = c == 0 ? recorder.force_clip_N : recorder.accel_clip_mps2;
    const double limit = std::min(full_scales_[c], clip.value_or(full_scales_[c]));
    const double step = recorder.bits > 0 ? std::ldexp(full_scales_[c], 1 - recorder.bits) : 0;
    for (std::size_t i = 0; i < count; ++i) {
      double& value = out[i * channels() + c];
      value = std::clamp(silent ? noise[i] : value + noise[i], -limit, limit);
      if (step > 0) value = step * std::nearbyint(value / step);
    }
  }
}

}  // namespace percuss::synth
