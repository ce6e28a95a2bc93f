#include "report/svg/response_spectra.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math/complex.hpp"
#include "core/math/fft.hpp"
#include "identify/decay/decay_spectra.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxCharts = 6;
constexpr double kFloor_dB = -140;  // the lowest level that a chart shows

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

// Σ|X|² of the fitted modes over the hits. One mode at a time, since all columns of many modes would not fit in memory.
std::vector<double> fitted_power(const std::vector<const identify::DecayMode*>& modes, double fs_Hz,
                                 const DecayLines& lines, std::size_t channel) {
  const identify::DecaySpectra spectra{.fs_Hz = fs_Hz, .samples = lines.samples, .lines = {}};
  const auto count = static_cast<Eigen::Index>(lines.count);
  const auto hits = static_cast<Eigen::Index>(modes.front()->hits.size());
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(count, hits);
  for (const identify::DecayMode* one : modes) {
    const auto columns =
        identify::decay_values(identify::decay_rate_of(one->mode.pole), spectra, lines.first, lines.count);
    for (Eigen::Index h = 0; h < hits; ++h) {
      const Complex amplitude = one->hits[static_cast<std::size_t>(h)].value * one->mode.residues[channel].value;
      sum.col(h) += amplitude.real() * columns.col(0) + amplitude.imag() * columns.col(1);
    }
  }
  const Eigen::VectorXd power = sum.rowwise().squaredNorm();
  return {power.data(), power.data() + power.size()};
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
    for (const identify::DecayMode& one : *found) {
      modes.push_back(&one);
      for (const identify::DecayMode& companion : one.companions) modes.push_back(&companion);
    }
  std::vector<double> freq_Hz;
  for (std::size_t i = 0; i < lines.count; ++i) freq_Hz.push_back(lines.freq_Hz(i));
  std::vector<LineChart> out;
  for (std::size_t c = 0; c < std::min(kMaxCharts, test.record.accel.size()); ++c) {
    const std::vector<double> measured = measured_power(test, lines, c);
    const double largest = *std::max_element(measured.begin(), measured.end());
    if (!(largest > 0)) continue;
    LineChart chart{.title = "Free decays of " + channel_label(test, c),
                    .x = {.label = "frequency, Hz"},
                    .y = {.label = "spectrum, dB re the largest measured line"},
                    .curves = {}};
    chart.curves.push_back({"measured", freq_Hz, decibels(measured, largest)});
    chart.curves.push_back({"fit", freq_Hz, decibels(fitted_power(modes, test.record.fs_Hz, lines, c), largest)});
    out.push_back(std::move(chart));
  }
  return out;
}

}  // namespace percuss::report
