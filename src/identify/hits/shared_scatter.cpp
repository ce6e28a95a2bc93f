#include "identify/hits/shared_scatter.hpp"

#include <cmath>
#include <set>

#include "core/math/random_effects.hpp"
#include "core/math/significance.hpp"
#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kMinWindows = 2;
constexpr double kMaxRatio = 2;              // of a mode's scatter to the median, either way
constexpr double kMaxLogRatio = 2;           // of the likelihoods with the mode's own scatter and with the median
constexpr double kMinPartThatAgrees = 0.75;  // of the modes that scatter significantly
constexpr double kMinProbability = 0.05;     // below it, a mode does not have the scatter
constexpr int kPasses = 30;

// Logarithm of the likelihood of the values about their unknown mean.
double log_likelihood(const RelativeHitValues& mode, double variance) {
  std::vector<double> std;
  double log_weights = 0;
  for (const double own : mode.std) {
    std.push_back(std::hypot(own, std::sqrt(variance)));
    log_weights -= 2 * std::log(std.back());
  }
  const RandomEffects about_mean = random_effects(mode.value, std, mode.value.front());
  return 0.5 * (log_weights - std::log(about_mean.own_weights) - about_mean.chi2);
}

bool agrees(const RelativeHitValues& mode, double spread) {
  if (mode.spread > spread / kMaxRatio && mode.spread < spread * kMaxRatio) return true;
  return log_likelihood(mode, mode.spread * mode.spread) - log_likelihood(mode, spread * spread) < kMaxLogRatio;
}

// The scatter that the modes with significant scatter have in common; 0: none.
double common_spread(const std::vector<RelativeHitValues>& modes) {
  std::vector<double> spreads;
  for (const RelativeHitValues& mode : modes) {
    if (mode.spread > 0) spreads.push_back(mode.spread);
  }
  if (spreads.empty()) return 0;
  const double middle = median(spreads);
  std::size_t count = 0;
  std::set<std::size_t> windows;
  for (const RelativeHitValues& mode : modes) {
    if (mode.spread <= 0 || !agrees(mode, middle)) continue;
    ++count;
    windows.insert(mode.window);
  }
  const bool most = static_cast<double>(count) >= kMinPartThatAgrees * static_cast<double>(spreads.size());
  return most && windows.size() >= kMinWindows ? middle : 0;
}

}  // namespace

SharedScatter shared_scatter(const std::vector<RelativeHitValues>& modes) {
  SharedScatter out{.spread = common_spread(modes), .probability = {}};
  if (out.spread <= 0) return out;
  out.probability.assign(modes.size(), 0);
  std::vector<double> log_ratio(modes.size());  // of the likelihoods with and without the scatter
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (modes[m].spread > 0) out.probability[m] = agrees(modes[m], out.spread) ? 1 : 0;
    if (modes[m].spread > 0 || modes[m].value.size() < 2) continue;
    log_ratio[m] = log_likelihood(modes[m], out.spread * out.spread) - log_likelihood(modes[m], 0);
  }
  // The part of the modes that have the scatter is unknown as well. Jeffreys' prior keeps it from 0 and 1.
  double part = 0.5;
  for (int pass = 0; pass < kPasses; ++pass) {
    double sum = 0.5;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (modes[m].spread <= 0) out.probability[m] = 1 / (1 + (1 - part) / part * std::exp(-log_ratio[m]));
      sum += out.probability[m];
    }
    part = sum / (static_cast<double>(modes.size()) + 1);
  }
  for (double& one : out.probability) {
    if (one < kMinProbability) one = 0;
  }
  return out;
}

double std_from_shared_scatter(const std::vector<double>& std, std::size_t hits, double spread, double probability) {
  if (!(spread > 0 && probability > 0)) return 0;
  const double factor = student_factor(static_cast<double>((std.size() < 2 ? hits : std.size()) - 1));
  if (std.size() < 2) return factor * spread * std::sqrt(probability / static_cast<double>(hits));
  double own_weights = 0, weights = 0;
  for (const double own : std) {
    own_weights += 1 / (own * own);
    weights += 1 / (own * own + spread * spread);
  }
  return factor * std::sqrt(probability * (1 / weights - 1 / own_weights));
}

}  // namespace percuss::identify
