#include "identify/decay/decay_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kRates = 12;
constexpr double kSlowest = 0.5;       // decay over the record, in nepers
constexpr double kFastest = 1.0 / 16;  // of the sampling rate
constexpr double kFalseAlarms = 1000;  // searches in which noise alone gives one decay
constexpr double kWeakest = 0.02;      // of the strongest candidate: weaker ones wait until it is fitted
constexpr double kApart_lines = 6;     // between candidates of one search, beyond three half-power bandwidths

std::vector<double> rates_per_s(const DecaySpectra& of) {
  const double slowest = kSlowest * of.line_Hz(), fastest = std::max(slowest, kFastest * of.fs_Hz);
  std::vector<double> rates;
  for (std::size_t r = 0; r < kRates; ++r)
    rates.push_back(slowest * std::pow(fastest / slowest, static_cast<double>(r) / (kRates - 1)));
  return rates;
}

struct FilterBank {
  Eigen::ArrayXd energy;  // [padded lines] largest over the rates
  Eigen::ArrayXd rate_per_s;
  double line_Hz = 0;
};

std::vector<double> whitened(const DecaySpectra& residual, const Eigen::MatrixXd& noise, Index i) {
  const Eigen::VectorXcd lines =
      residual.lines.col(i).array() / noise.col(i % noise.cols()).array().sqrt().cast<Complex>();
  std::vector<Complex> copy(lines.data(), lines.data() + lines.size());
  copy.front() = 0;  // a constant is no decay
  std::vector<double> x = inverse_real_dft(copy, residual.samples);
  for (double& value : x) value *= std::sqrt(static_cast<double>(residual.samples));
  return x;
}

FilterBank matched_filters(const DecaySpectra& residual, const Eigen::MatrixXd& noise) {
  const std::size_t padded = fast_length_at_least(2 * residual.samples);
  const auto lines = static_cast<Index>(padded / 2 + 1);
  const std::vector<double> rates = rates_per_s(residual);
  std::vector<std::vector<double>> x(static_cast<std::size_t>(residual.lines.cols()));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = whitened(residual, noise, static_cast<Index>(i));
  plan_real_dft(padded);
  std::vector<Eigen::ArrayXd> energy(rates.size());
  constexpr std::size_t kFlopsPerSample = 100;
  parallel_for_cost(rates.size(), kFlopsPerSample * padded * x.size(), [&](std::size_t r) {
    const double decay = std::exp(-rates[r] / residual.fs_Hz);
    std::vector<double> windowed(padded);
    energy[r] = Eigen::ArrayXd::Zero(lines);
    for (const std::vector<double>& one : x) {
      double weight = 1, sum = 0;
      for (std::size_t n = 0; n < one.size(); ++n) {
        windowed[n] = weight * one[n];
        sum += weight * weight;
        weight *= decay;
      }
      const auto transform = real_dft_in_scratch(windowed);
      for (Index k = 0; k < lines; ++k) energy[r](k) += std::norm(transform[static_cast<std::size_t>(k)]) / sum;
    }
  });
  FilterBank out{.energy = energy[0],
                 .rate_per_s = Eigen::ArrayXd::Constant(lines, rates[0]),
                 .line_Hz = residual.fs_Hz / static_cast<double>(padded)};
  for (std::size_t r = 1; r < rates.size(); ++r) {
    out.rate_per_s = (energy[r] > out.energy).select(rates[r], out.rate_per_s);
    out.energy = out.energy.max(energy[r]);
  }
  return out;
}

double half_power_Hz(const DecayRate& rate) { return -rate.rate_radps.real() / std::numbers::pi; }

bool apart(const DecayRate& a, const DecayRate& b, double margin_Hz, double bandwidths) {
  const double distance_Hz = std::abs(a.rate_radps.imag() - b.rate_radps.imag()) / kTwoPi;
  return distance_Hz > margin_Hz + bandwidths * (half_power_Hz(a) + half_power_Hz(b)) / 2;
}

}  // namespace

double decay_threshold(std::size_t spectra, std::size_t places) {
  const auto count = static_cast<double>(spectra);
  const double chance = std::log(kFalseAlarms * static_cast<double>(std::max<std::size_t>(places, 1)));
  return count + std::sqrt(2 * count * chance) + chance;
}

std::vector<DecayCandidate> strongest_decays(const DecaySpectra& residual, const Eigen::MatrixXd& noise,
                                             const DecaySearchLimits& limits) {
  const FilterBank bank = matched_filters(residual, noise);
  const auto first = static_cast<Index>(std::max(1.0, std::ceil(limits.band_Hz.first / bank.line_Hz)));
  const Index last =
      std::min(bank.energy.size() - 2, static_cast<Index>(std::floor(limits.band_Hz.second / bank.line_Hz)));
  const double threshold = decay_threshold(static_cast<std::size_t>(residual.lines.cols()),
                                           static_cast<std::size_t>(std::max<Index>(last - first, 1)) * kRates);
  std::vector<DecayCandidate> peaks;
  for (Index k = first; k <= last; ++k) {
    const double e = bank.energy(k);
    if (e < threshold || e < bank.energy(k - 1) || e < bank.energy(k + 1)) continue;
    const double omega = kTwoPi * bank.line_Hz * static_cast<double>(k);
    const DecayRate rate{Complex(-bank.rate_per_s(k), omega)};
    const bool refused = std::any_of(limits.refused.begin(), limits.refused.end(), [&](const DecayRate& other) {
      return !apart(rate, other, residual.line_Hz() / 2, 1);
    });
    if (!refused) peaks.push_back({.rate = rate, .energy = e});
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const DecayCandidate& a, const DecayCandidate& b) { return a.energy > b.energy; });
  std::vector<DecayCandidate> chosen;
  for (const DecayCandidate& peak : peaks) {
    if (chosen.size() >= limits.max_candidates || peak.energy < kWeakest * peaks.front().energy) break;
    if (std::all_of(chosen.begin(), chosen.end(), [&](const DecayCandidate& other) {
          return apart(peak.rate, other.rate, kApart_lines * residual.line_Hz(), 3);
        }))
      chosen.push_back(peak);
  }
  return chosen;
}

}  // namespace percuss::identify
