// percuss_deflection_chart [FILE.svg]
// Prints and draws the run time and the error of every method of deflection_of, for several sampling rates. A held beam
// with three modes gets a hit of 2.5 ms. The record passes an anti-alias filter and has a bias, a drift and noise of a
// thousandth of the acceleration's RMS. The error is the largest over twelve noise realisations. The residues for
// `modal` have errors of a thousandth. Truth is the band-limited deflection from the filtered force.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <random>
#include <vector>

#include "core/io/atomic_file.hpp"
#include "core/math/statistics.hpp"
#include "metrics/deflection/deflection.hpp"
#include "report/svg/line_chart.hpp"
#include "synth/pulse.hpp"

namespace percuss {
namespace {

constexpr double kRest_s = 0.1, kLength_s = 1.2;
constexpr int kNoises = 12;
constexpr double kResidueError = 1e-3;  // of the modes for the method modal

struct Test {
  std::vector<double> force_N, accel_mps2, truth_m;
  std::vector<metrics::ModalContribution> modes;
};

Test struck_beam(double fs_Hz) {
  const std::vector<synth::SynthPole> poles{{14.5, 0.012}, {90, 0.01}, {322, 0.008}};
  const std::array residues{3.2, 1.1, -0.8};
  const auto samples = static_cast<std::size_t>(kLength_s * fs_Hz);
  const synth::PulseBasis basis =
      synth::pulse_basis({.onset_s = kRest_s, .width_s = 0.0025, .peak_N = 800}, fs_Hz, poles, 0, samples);
  Test test{
      .force_N = std::vector<double>(samples), .accel_mps2 = std::vector<double>(samples), .truth_m = {}, .modes = {}};
  for (std::size_t m = 0; m < poles.size(); ++m) {
    test.modes.push_back({.pole = {poles[m].freq_Hz, poles[m].damping_ratio}, .residue_per_kg = residues.at(m)});
    for (std::size_t i = 0; i < basis.regular_N[m].size(); ++i) {
      const double force_N = i < basis.force_N.size() ? basis.force_N[i] : 0;
      test.accel_mps2[basis.first + i] += residues.at(m) * (basis.regular_N[m][i] + force_N);
    }
  }
  for (std::size_t i = 0; i < basis.force_N.size(); ++i) test.force_N[basis.first + i] = basis.force_N[i];
  test.truth_m = metrics::modal_deflection(test.force_N, fs_Hz, test.modes, 0).deflection_m;
  return test;
}

double largest(const std::vector<double>& x) { return extremes_of(x).max_distance_from(0); }

struct Point {
  double error = 0, seconds = 0;
};

Point measured(const Test& clean, double fs_Hz, metrics::DeflectionMethod method) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  const double noise = 1e-3 * rms(clean.accel_mps2);
  Point point{.seconds = 1e9};
  for (int n = 0; n < kNoises; ++n) {
    std::vector<double> accel = clean.accel_mps2;
    const double bias = 0.3 * gauss(random), drift = 0.1 * gauss(random);
    for (std::size_t i = 0; i < accel.size(); ++i)
      accel[i] += bias + drift * static_cast<double>(i) / fs_Hz + noise * gauss(random);
    std::vector<metrics::ModalContribution> modes = clean.modes;
    for (metrics::ModalContribution& mode : modes) mode.residue_per_kg *= 1 + kResidueError * gauss(random);
    const metrics::ImpactSignal signal{
        .fs_Hz = fs_Hz, .accel_mps2 = accel, .onset_s = kRest_s, .force_N = clean.force_N, .modes = modes};
    const auto start = std::chrono::steady_clock::now();
    const metrics::Deflection found = metrics::deflection_of(signal, {.method = method});
    point.seconds =
        std::min(point.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    point.error = std::max(point.error, std::abs(std::abs(found.peak_m) / largest(clean.truth_m) - 1));
  }
  return point;
}

void chart(const char* path) {
  report::LineChart chart{.title = "Deflection: time against error",
                          .x = {.label = "time for a record of 1.2 s, ms", .logarithmic = true},
                          .y = {.label = "error of the largest deflection, %", .logarithmic = true},
                          .curves = {}};
  fmt::print("{:<16}{:>10}{:>12}{:>14}\n", "method", "rate, Hz", "time, ms", "error, %");
  for (const metrics::DeflectionMethod method :
       {metrics::DeflectionMethod::small_interval, metrics::DeflectionMethod::frequency,
        metrics::DeflectionMethod::drift_free, metrics::DeflectionMethod::modal}) {
    report::ChartCurve curve{.name = name_of(method), .x = {}, .y = {}, .marks = true};
    for (const double fs_Hz : {2000.0, 5000.0, 10000.0, 20000.0, 50000.0}) {
      const Point point = measured(struck_beam(fs_Hz), fs_Hz, method);
      fmt::print("{:<16}{:>10.0f}{:>12.3f}{:>14.2g}\n", name_of(method), fs_Hz, 1e3 * point.seconds, 100 * point.error);
      curve.x.push_back(1e3 * point.seconds);
      curve.y.push_back(100 * point.error);
    }
    chart.curves.push_back(std::move(curve));
  }
  if (path != nullptr) write_file(path, report::line_chart_svg(chart), true);
}

}  // namespace
}  // namespace percuss

int main(int argc, char** argv) {
  try {
    percuss::chart(argc > 1 ? argv[1] : nullptr);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
  return 0;
}
