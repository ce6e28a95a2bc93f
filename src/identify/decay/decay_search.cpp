#include "identify/decay/decay_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/parallel/parallel.hpp"
#include "core/parallel/per_thread.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kRates = 12;
constexpr double kSlowest = 0.5;                  // decay over the record, in nepers
constexpr double kFastest = 1.0 / 16;             // of the sampling rate
constexpr double kLight = 0.12, kHeaviest = 0.5;  // damping ratios
constexpr double kSearchesPerFalseAlarm = 1000;   // one in so many searches of noise alone finds a decay
constexpr double kWeakest = 0.02;                 // of the strongest candidate: weaker ones wait until it is fitted
constexpr double kApart_lines = 6;  // between candidates of one search, in addition to three half-power bandwidths

std::vector<double> rates_per_s(const DecaySpectra& spectra) {
  const double slowest = kSlowest * spectra.df_Hz(), fastest = std::max(slowest, kFastest * spectra.fs_Hz);
  std::vector<double> rates;
  for (std::size_t r = 0; r < kRates; ++r)
    rates.push_back(slowest * std::pow(fastest / slowest, static_cast<double>(r) / (kRates - 1)));
  return rates;
}

struct FilterBank {
  Eigen::ArrayXXd energy;  // [padded lines, rates]
  std::vector<double> rates_per_s;
  double df_Hz = 0;
};

std::vector<double> whitened(const DecaySpectra& residual, const Eigen::MatrixXd& noise, Index i) {
  const Eigen::VectorXcd lines = residual.lines.col(i).array() / noise.col(i).array().sqrt().cast<Complex>();
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
  FilterBank out{.energy = Eigen::ArrayXXd::Zero(lines, static_cast<Index>(rates.size())),
                 .rates_per_s = rates,
                 .df_Hz = residual.fs_Hz / static_cast<double>(padded)};
  static const PerThread<std::vector<double>> scratch;
  constexpr std::size_t kFlopsPerSample = 100;
  parallel_for_cost(rates.size(), kFlopsPerSample * padded * x.size(), [&](std::size_t r) {
    const double decay = std::exp(-rates[r] / residual.fs_Hz);
    std::vector<double>& windowed = scratch.local();
    windowed.assign(padded, 0);
    auto of_rate = out.energy.col(static_cast<Index>(r));
    for (const std::vector<double>& one : x) {
      double weight = 1, sum = 0;
      for (std::size_t n = 0; n < one.size(); ++n) {
        windowed[n] = weight * one[n];
        sum += weight * weight;
        weight *= decay;
      }
      const auto transform = real_dft_in_scratch(windowed);
      for (Index k = 0; k < lines; ++k) of_rate(k) += std::norm(transform[static_cast<std::size_t>(k)]) / sum;
    }
  });
  return out;
}

// The candidate at a padded line: the rate with the largest energy, among those below a damping ratio.
DecayCandidate candidate_at(const FilterBank& bank, Index line, double max_damping) {
  const double omega = kTwoPi * bank.df_Hz * static_cast<double>(line);
  std::size_t best = 0;
  for (std::size_t r = 1; r < bank.rates_per_s.size() && bank.rates_per_s[r] < max_damping * omega; ++r) {
    if (bank.energy(line, static_cast<Index>(r)) > bank.energy(line, static_cast<Index>(best))) best = r;
  }
  return {.rate = {Complex(-bank.rates_per_s[best], omega)}, .energy = bank.energy(line, static_cast<Index>(best))};
}

// The maxima of the energy over the band that exceed the threshold, without the refused ones. The strongest first.
std::vector<DecayCandidate> maxima(const FilterBank& bank, double max_damping, double threshold, double margin_Hz,
                                   const DecaySearchLimits& limits) {
  const auto first = static_cast<Index>(std::max(1.0, std::ceil(limits.band_Hz.first / bank.df_Hz)));
  const Index last =
      std::min(bank.energy.rows() - 2, static_cast<Index>(std::floor(limits.band_Hz.second / bank.df_Hz)));
  std::vector<DecayCandidate> out, lines;
  for (Index k = first - 1; k <= last + 1; ++k) lines.push_back(candidate_at(bank, k, max_damping));
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    const double e = lines[i].energy;
    if (e < threshold || e < lines[i - 1].energy || e < lines[i + 1].energy) continue;
    if (std::none_of(limits.refused.begin(), limits.refused.end(),
                     [&](const DecayRate& other) { return overlap(lines[i].rate, other, 1, margin_Hz); }))
      out.push_back(lines[i]);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const DecayCandidate& a, const DecayCandidate& b) { return a.energy > b.energy; });
  return out;
}

}  // namespace

double decay_threshold(std::size_t spectra, std::size_t places) {
  const auto count = static_cast<double>(spectra);
  const double chance = std::log(kSearchesPerFalseAlarm * static_cast<double>(std::max<std::size_t>(places, 1)));
  return count + std::sqrt(2 * count * chance) + chance;
}

std::vector<DecayCandidate> strongest_decays(const DecaySpectra& residual, const Eigen::MatrixXd& noise,
                                             const DecaySearchLimits& limits) {
  const FilterBank bank = matched_filters(residual, noise);
  const double lines = (limits.band_Hz.second - limits.band_Hz.first) / bank.df_Hz;
  const double threshold = decay_threshold(static_cast<std::size_t>(residual.lines.cols()),
                                           static_cast<std::size_t>(std::max(lines, 1.0)) * kRates);
  const double margin_Hz = residual.df_Hz() / 2;
  // All modes that are not fitted yet begin at the same moment, where their sum looks like a heavily damped decay. Such
  // candidates wait until no other is left.
  std::vector<DecayCandidate> peaks = maxima(bank, kLight, threshold, margin_Hz, limits);
  if (peaks.empty()) peaks = maxima(bank, kHeaviest, threshold, margin_Hz, limits);
  std::vector<DecayCandidate> chosen;
  for (const DecayCandidate& peak : peaks) {
    if (chosen.size() >= limits.max_candidates || peak.energy < kWeakest * peaks.front().energy) break;
    if (std::all_of(chosen.begin(), chosen.end(), [&](const DecayCandidate& other) {
          return !overlap(peak.rate, other.rate, 3, kApart_lines * residual.df_Hz());
        }))
      chosen.push_back(peak);
  }
  return chosen;
}

}  // namespace percuss::identify
