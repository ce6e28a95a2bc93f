#include "frf_figures.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::accuracy {
namespace {

struct Sums {
  double error = 0, signal = 0, over_bound = 0, terms = 0, worst_dB = 0;

  void add(const Sums& other) {
    error += other.error;
    signal += other.signal;
    over_bound += other.over_bound;
    terms += other.terms;
    worst_dB = std::max(worst_dB, other.worst_dB);
  }
};

// The error sums of one FRF; at the resonances also the largest error in dB.
Sums error_sums(const acquire::PointFrf& found, const std::vector<Complex>& exact, const std::vector<double>& ff,
                const acquire::LineRange& lines, const synth::Truth& truth) {
  Sums sums;
  const double noise = std::pow(truth.accel_noise_mps2[found.channel], 2) * static_cast<double>(lines.samples);
  for (std::size_t k = 0; k < lines.count; ++k) {
    const double freq_Hz = lines.freq_Hz(k);
    if (freq_Hz < truth.spec.band_low_Hz || freq_Hz > truth.spec.band_high_Hz) continue;
    const double square = std::norm(found.frf.value[k] - exact[k]);
    sums.error += square;
    sums.signal += std::norm(exact[k]);
    sums.over_bound += square * ff[k] / noise;  // (1)
    ++sums.terms;
  }
  for (const synth::SynthMode& mode : truth.spec.modes) {
    const std::size_t k = lines.nearest(mode.freq_Hz);
    sums.worst_dB = std::max(sums.worst_dB, std::abs(20 * std::log10(std::abs(found.frf.value[k] / exact[k]))));
  }
  return sums;
}

Sums one_run(const acquire::Record& record, const synth::Truth& truth, frf::Estimator estimator) {
  const pipeline::Analysis analysis(
      record, {.band_Hz = {{truth.spec.band_low_Hz, truth.spec.band_high_Hz}}, .estimator = estimator, .threads = 1});
  Sums sums;
  const std::vector<double> freq_Hz = acquire::frequencies_Hz(analysis.lines());
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    sums.add(error_sums(frf, synth::exact_accelerance(truth, 0, frf.channel, freq_Hz),
                        analysis.fitted_frfs().points.front().ff, analysis.lines(), truth));
  }
  return sums;
}

}  // namespace

std::vector<Figure> frf_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth) {
  std::vector<Figure> figures;
  for (const frf::Estimator estimator : {frf::Estimator::h1, frf::Estimator::h2, frf::Estimator::hv}) {
    std::vector<Sums> each(runs.size());
    parallel_for(runs.size(), 0, [&](std::size_t i) { each[i] = one_run(runs[i].second, truth, estimator); });
    Sums all;
    for (const Sums& one : each) all.add(one);
    figures.push_back({.method = name_of(estimator),
                       .label = {},
                       .error = 100 * std::sqrt(all.error / all.signal),
                       .over_bound = std::sqrt(all.over_bound / all.terms),
                       .more = {shown_figure(all.worst_dB)}});
  }
  return figures;
}

}  // namespace percuss::accuracy
