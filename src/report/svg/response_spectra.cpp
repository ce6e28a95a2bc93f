#include "report/svg/response_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/error.hpp"
#include "core/math/fft.hpp"
#include "core/units.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxCharts = 6;
constexpr double kFloor_dB = -140;  // of what a chart shows

// The spectral lines of the decays within the band.
struct DecayLines {
  std::size_t start = 0, samples = 0;  // of the decays, from the impact
  std::size_t first = 0, count = 0;    // lines
  double spacing_Hz = 0;

  double freq_Hz(std::size_t i) const { return static_cast<double>(first + i) * spacing_Hz; }
};

DecayLines lines_of(const pipeline::ResponseTest& test) {
  const double fs_Hz = test.record.fs_Hz;
  DecayLines out;
  out.start = static_cast<std::size_t>(std::lround(test.start_s * fs_Hz));
  out.samples = test.samples - out.start;
  out.spacing_Hz = fs_Hz / static_cast<double>(out.samples);
  out.first = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(test.band_Hz.first / out.spacing_Hz)));
  const auto last = std::min(static_cast<std::size_t>(test.band_Hz.second / out.spacing_Hz), out.samples / 2);
  out.count = last >= out.first ? last - out.first + 1 : 0;
  return out;
}

// Σ z^n over the samples of a decay, for the ratio z of one sample to the one before.
Complex geometric_sum(Complex ratio, std::size_t samples) {
  const Complex rest = 1.0 - ratio;
  if (std::abs(rest) < 1e-12) return static_cast<double>(samples);
  return (1.0 - std::pow(ratio, static_cast<double>(samples))) / rest;
}

// The transforms of Re exp(st) and Re j exp(st), sampled from t = 0 on: those of a decay with amplitude a + jb are
// a times the first plus b times the second.
struct DecayColumns {
  std::vector<Complex> of_real, of_imaginary;
};

DecayColumns columns_of(const identify::Pole& pole, double fs_Hz, const DecayLines& lines) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  const Complex s(-zeta * omega, omega * std::sqrt(std::max(0.0, 1 - zeta * zeta)));
  DecayColumns out;
  for (std::size_t i = 0; i < lines.count; ++i) {
    const Complex line(0, kTwoPi * lines.freq_Hz(i));
    const Complex here = geometric_sum(std::exp((s - line) / fs_Hz), lines.samples);
    const Complex mirrored = geometric_sum(std::exp((std::conj(s) - line) / fs_Hz), lines.samples);
    out.of_real.push_back((here + mirrored) / 2.0);
    out.of_imaginary.push_back(Complex(0, 0.5) * (here - mirrored));
  }
  return out;
}

std::vector<double> decibels(const std::vector<double>& power, double largest) {
  std::vector<double> out;
  for (const double one : power) out.push_back(std::max(kFloor_dB, 10 * std::log10(std::max(one / largest, 1e-300))));
  return out;
}

// Σ|X|² over the accepted hits of a channel.
std::vector<double> measured_power(const pipeline::ResponseTest& test, const DecayLines& lines, std::size_t channel) {
  std::vector<double> out(lines.count, 0), x(lines.samples);
  for (const pipeline::ResponseHit& hit : test.hits) {
    if (!hit.accepted) continue;
    test.record.read_accel_mps2(hit.impact.row, channel, hit.impact.first + lines.start, x);
    const auto spectrum = real_dft(x);
    for (std::size_t i = 0; i < lines.count; ++i) out[i] += std::norm(spectrum[lines.first + i]);
  }
  return out;
}

std::vector<double> fitted_power(const std::vector<const identify::DecayMode*>& modes,
                                 const std::vector<DecayColumns>& columns, std::size_t lines, std::size_t channel) {
  std::vector<double> out(lines, 0);
  for (std::size_t h = 0; h < modes.front()->hits.size(); ++h) {
    std::vector<Complex> sum(lines, 0.0);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const Complex amplitude = modes[m]->hits[h].value * modes[m]->mode.residues[channel].value;
      for (std::size_t i = 0; i < lines; ++i)
        sum[i] += amplitude.real() * columns[m].of_real[i] + amplitude.imag() * columns[m].of_imaginary[i];
    }
    for (std::size_t i = 0; i < lines; ++i) out[i] += std::norm(sum[i]);
  }
  return out;
}

}  // namespace

std::string channel_label(const pipeline::ResponseTest& test, std::size_t channel) {
  const std::string name = one_line(test.record.accel[channel].name, 24);
  return name.empty() ? fmt::format("channel {}", channel + 1) : name;
}

std::vector<LineChart> response_spectra(const pipeline::ResponseTest& test) {
  if (!test.possible() || test.found.modes.empty()) return {};
  const DecayLines lines = lines_of(test);
  if (lines.count < 2) return {};
  std::vector<const identify::DecayMode*> modes;
  for (const auto* found : {&test.found.modes, &test.found.tones})
    for (const identify::DecayMode& one : *found) modes.push_back(&one);
  std::vector<DecayColumns> columns;
  for (const identify::DecayMode* one : modes) columns.push_back(columns_of(one->mode.pole, test.record.fs_Hz, lines));
  std::vector<double> freq_Hz;
  for (std::size_t i = 0; i < lines.count; ++i) freq_Hz.push_back(lines.freq_Hz(i));
  std::vector<LineChart> out;
  for (std::size_t c = 0; c < std::min(kMaxCharts, test.record.accel.size()); ++c) {
    const std::vector<double> measured = measured_power(test, lines, c);
    const double largest = *std::max_element(measured.begin(), measured.end());
    if (!(largest > 0)) continue;
    LineChart chart{.title = "Free decays of " + channel_label(test, c),
                    .x = {.label = "frequency, Hz"},
                    .y = {.label = "spectrum, dB below its largest line"},
                    .curves = {}};
    chart.curves.push_back({"measured", freq_Hz, decibels(measured, largest)});
    chart.curves.push_back({"fit", freq_Hz, decibels(fitted_power(modes, columns, lines.count, c), largest)});
    out.push_back(std::move(chart));
  }
  return out;
}

}  // namespace percuss::report
