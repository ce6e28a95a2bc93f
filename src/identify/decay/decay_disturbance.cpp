#include "identify/decay/decay_disturbance.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "identify/decay/noise_prediction.hpp"

namespace percuss::identify {
namespace {

constexpr double kBlock_s = 10e-3;
constexpr std::size_t kMinBlock_samples = 64;  // samples: enough for a mean square to 18 %
constexpr double kRise = 10;                   // of the mean square
constexpr std::size_t kBefore = 4;             // a disturbance rises within so many blocks
constexpr std::size_t kMinErrorBlocks = 10;    // of a record, for a median

// The sums of the squared prediction errors of a response without its decays, in blocks from the fit's start on.
std::vector<double> block_errors(const std::vector<double>& rest, const NoisePrediction& prediction,
                                 std::size_t block) {
  std::vector<double> out(rest.size() / block, 0.0);
  for (std::size_t b = 0; b < out.size(); ++b) {
    for (std::size_t n = b * block; n < (b + 1) * block; ++n) out[b] += std::pow(prediction.error(rest, n), 2);
  }
  return out;
}

std::optional<std::size_t> first_rise(const std::vector<double>& square) {
  if (square.size() < kMinErrorBlocks) return std::nullopt;
  const double typical = median(square);
  for (std::size_t b = 1; b < square.size(); ++b) {
    const auto at = square.begin() + static_cast<std::ptrdiff_t>(b);
    const double before = *std::min_element(at - static_cast<std::ptrdiff_t>(std::min(b, kBefore)), at);
    if (square[b] > kRise * std::max(before, typical)) return b;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<std::size_t>> decay_disturbances(const FreeDecays& whole, const StartedFit& fit) {
  std::vector<std::optional<std::size_t>> out(whole.hits);
  const std::size_t samples = whole.samples() - fit.start;
  const auto block = std::max(kMinBlock_samples, static_cast<std::size_t>(kBlock_s * whole.fs_Hz));
  for (std::size_t i = 0; i < whole.response.size(); ++i) {
    const auto signal = static_cast<Eigen::Index>(i);
    std::vector<double> rest(whole.response[i].begin() + static_cast<std::ptrdiff_t>(fit.start),
                             whole.response[i].end());
    subtract_decays(fit.fit, whole.fs_Hz, i, 0, rest);
    const NoisePrediction prediction = noise_prediction(fit.fit.noise.col(signal), samples);
    const auto rise = first_rise(block_errors(rest, prediction, block));
    if (!rise) continue;
    const std::size_t at = fit.start + *rise * block;
    std::optional<std::size_t>& of_hit = out[i / whole.channels];
    of_hit = std::min(of_hit.value_or(at), at);
  }
  return out;
}

}  // namespace percuss::identify
