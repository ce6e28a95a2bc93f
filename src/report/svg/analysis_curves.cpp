#include "report/svg/analysis_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/math/fft.hpp"
#include "core/units.hpp"
#include "identify/model/frf_synthesis.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kDecayPoints = 400, kSpectrumPoints = 300;
constexpr double kMaxAbove_dB = 40;  // limit of above_dB, which is unbounded near a zero of the FRF
constexpr double kBeyondBandwidth = 1.5;
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

double level_dB_of(double amplitude) { return amplitude > 0 ? 20 * std::log10(amplitude) : kGap; }

double level_of(const acquire::PointFrf& frf) {
  double sum = 0;
  for (const Complex& value : frf.frf.value) sum += std::norm(value);
  return sum;
}

// The strongest FRFs, in the order of the file.
std::vector<std::size_t> strongest_frfs_of(const std::vector<acquire::PointFrf>& frfs, std::size_t most) {
  std::vector<std::size_t> order(frfs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return level_of(frfs[a]) > level_of(frfs[b]); });
  order.resize(std::min(order.size(), most));
  std::sort(order.begin(), order.end());
  return order;
}

std::string name_of_frf(const pipeline::Analysis& analysis, const acquire::PointFrf& frf) {
  const acquire::SignalInfo& signal = analysis.record().accel[frf.channel];
  std::string name = signal.name;
  if (signal.angle_rad) name += fmt::format(" ({:.4g}°)", *signal.angle_rad * kRadian_deg);
  if (analysis.frf_points().size() == 1) return name;
  return fmt::format("point {}, {}", analysis.point_names().name(frf.point), name);
}

FrfCurve curve_of_frf(const pipeline::Analysis& analysis, const acquire::PointFrf& frf,
                      const std::vector<Complex>* fit) {
  const auto& value = frf.frf.value;
  const auto values = [&](auto value_of) {
    std::vector<double> out(value.size());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = value_of(k);
    return out;
  };
  FrfCurve curve{.name = name_of_frf(analysis, frf),
                 .level_dB = values([&](std::size_t k) { return level_dB_of(std::abs(value[k])); }),
                 .phase_deg = values([&](std::size_t k) { return std::arg(value[k]) * kRadian_deg; }),
                 .coherence = frf.frf.coherence,
                 .above_dB = {},
                 .fit_dB = {}};
  if (!frf.frf.std.empty()) {
    curve.above_dB = values([&](std::size_t k) {
      return std::min(kMaxAbove_dB, level_dB_of(1 + frf.frf.std[k] / std::max(std::abs(value[k]), 1e-300)));
    });
  }
  if (fit != nullptr && fit->size() == value.size())
    curve.fit_dB = values([&](std::size_t k) { return level_dB_of(std::abs((*fit)[k])); });
  return curve;
}

HitSamples spectrum_of(const acquire::Hit& hit, double fs_Hz) {
  constexpr std::size_t kPadding = 8;  // times the pulse: makes the spectrum nearly linear between lines
  std::vector<double> padded(fast_length_at_least(kPadding * std::max<std::size_t>(hit.gated_N.size(), 256)));
  std::copy(hit.gated_N.begin(), hit.gated_N.end(), padded.begin());
  const double df_Hz = fs_Hz / static_cast<double>(padded.size());
  const auto lines = real_dft(padded);
  double largest = 0;
  for (const Complex& line : lines) largest = std::max(largest, std::abs(line));
  const auto wanted = static_cast<std::size_t>(kBeyondBandwidth * hit.bandwidth_Hz / df_Hz) + 2;
  const std::size_t count = std::min(lines.size(), wanted), stride = count / kSpectrumPoints + 1;
  HitSamples out{.step = df_Hz * static_cast<double>(stride), .value = {}};
  for (std::size_t k = 0; k < count; k += stride) out.value.push_back(level_dB_of(std::abs(lines[k]) / largest));
  return out;
}

// The response before, during and shortly after the pulse.
HitSamples response_of(const pipeline::Analysis& analysis, const acquire::Hit& hit, std::size_t channel) {
  constexpr std::size_t kMaxSamples = 1000;
  constexpr double kPulsesShown = 20;
  const double fs_Hz = analysis.record().fs_Hz;
  const auto wanted = static_cast<std::size_t>(kPulsesShown * hit.pulse_s * fs_Hz) + 2;
  const std::size_t end = hit.first + hit.samples, count = std::min({wanted, kMaxSamples, end - hit.gate_first});
  HitSamples out{.first = static_cast<double>(hit.gate_first) / fs_Hz - hit.onset_s, .step = 1 / fs_Hz, .value = {}};
  out.value.resize(count);
  analysis.aligned_record().read_accel_mps2(hit.row, channel, hit.gate_first, out.value);
  return out;
}

struct Decay {
  HitSamples level_dB;
  double noise_dB = kGap;
};

// The response's level per block after the force's peak, and before the pulse.
Decay decay_of(const pipeline::Analysis& analysis, const acquire::Hit& hit, std::size_t channel) {
  constexpr std::size_t kMinRest = 16;  // samples for a level
  const acquire::Record& record = analysis.aligned_record();
  const std::size_t first = std::min(hit.peak, hit.first + hit.samples - 1), count = hit.first + hit.samples - first;
  std::vector<double> samples(count);
  record.read_accel_mps2(hit.row, channel, first, samples);
  double mean = 0;
  for (const double x : samples) mean += x / static_cast<double>(count);
  const std::size_t block = std::max<std::size_t>(1, count / kDecayPoints);
  HitSamples out{.step = static_cast<double>(block) / record.fs_Hz, .value = {}};
  for (std::size_t at = 0; at + block <= count; at += block) {
    double sum = 0;
    for (std::size_t i = at; i < at + block; ++i) sum += (samples[i] - mean) * (samples[i] - mean);
    out.value.push_back(level_dB_of(std::sqrt(sum / static_cast<double>(block))));
  }
  // A constant block has no level (kGap), which std::max_element does not order.
  double highest = kGap;
  for (const double level : out.value) highest = std::fmax(highest, level);
  for (double& level : out.value) level -= highest;
  Decay decay{.level_dB = std::move(out)};
  if (hit.gate_first >= hit.first + kMinRest) {
    samples.resize(hit.gate_first - hit.first);
    record.read_accel_mps2(hit.row, channel, hit.first, samples);
    double sum = 0;
    for (const double x : samples) sum += (x - mean) * (x - mean);
    decay.noise_dB = level_dB_of(std::sqrt(sum / static_cast<double>(samples.size()))) - highest;
  }
  return decay;
}

}  // namespace

std::vector<FrfCurve> frf_curves(const pipeline::Analysis& analysis, std::size_t most) {
  const auto& frfs = analysis.frfs();
  const identify::FrfDataset& set = analysis.fitted_frfs();
  std::vector<identify::SynthesisedFrf> made;
  if (!analysis.modes().empty() && set.channels.size() == frfs.size())
    made = identify::synthesised_frfs(set, analysis.modes(), set.lines);
  std::vector<FrfCurve> curves;
  for (const std::size_t i : strongest_frfs_of(frfs, most))
    curves.push_back(curve_of_frf(analysis, frfs[i], i < made.size() ? &made[i].value : nullptr));
  return curves;
}

std::vector<HitCurves> hit_curves(const pipeline::Analysis& analysis, std::size_t most) {
  std::vector<HitCurves> out;
  const auto& hits = analysis.hits();
  const double fs_Hz = analysis.record().fs_Hz;
  for (std::size_t i = 0; i < hits.size() && out.size() < most; ++i) {
    const acquire::Hit& hit = hits[i].hit;
    if (hit.gated_N.empty()) continue;
    const bool seen = !hits[i].responses.empty();
    Decay decay = seen ? decay_of(analysis, hit, 0) : Decay{};
    out.push_back({.index = i,
                   .accepted = hits[i].accepted,
                   .bandwidth_Hz = hit.bandwidth_Hz,
                   .force_N = {.first = static_cast<double>(hit.gate_first) / fs_Hz - hit.onset_s,
                               .step = 1 / fs_Hz,
                               .value = hit.gated_N},
                   .response_mps2 = seen ? response_of(analysis, hit, 0) : HitSamples{},
                   .spectrum_dB = spectrum_of(hit, fs_Hz),
                   .noise_dB = decay.noise_dB,
                   .decay_dB = std::move(decay.level_dB)});
  }
  return out;
}

}  // namespace percuss::report
