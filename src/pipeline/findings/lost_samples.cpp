#include "pipeline/findings/lost_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/io/counted_words.hpp"
#include "pipeline/findings/sample_prediction.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kAround = 900;  // samples on either side that the prediction is fitted to
constexpr double kMaxErrorRms = 2.5;  // of the scaled errors around predicted samples that fit

// Samples of one response that take the place of those of the record.
struct PredictedSamples {
  std::size_t row = 0, channel = 0, first = 0;
  std::vector<double> samples;
};

// The part of the decay around a gap, and the gap in it.
struct Surroundings {
  DecayRange range;                   // samples of the row
  std::size_t middle = 0, reach = 0;  // middle and half-width of the gap, as samples of the range
};

Surroundings surroundings_of(const GapInDecay& at) {
  const std::size_t first = at.gap.first, end = first + at.gap.count;
  const DecayRange range{.first = std::max(at.decay.first, first - std::min(first, kAround)),
                         .end = std::min(at.decay.end, end + kAround)};
  return {.range = range, .middle = first + at.gap.count / 2 - range.first, .reach = at.gap.count / 2 + 1};
}

// The predictions of all channels; nothing if those of one do not fit.
std::optional<std::vector<PredictedSamples>> predicted(const acquire::Record& record, const GapInDecay& at) {
  const auto [range, middle, reach] = surroundings_of(at);
  std::vector<std::vector<double>> samples(record.accel.size(), std::vector<double>(range.end - range.first));
  std::vector<std::span<const double>> channels;
  for (std::size_t c = 0; c < samples.size(); ++c) {
    record.read_accel_mps2(at.gap.row, c, range.first, samples[c]);
    channels.emplace_back(samples[c]);
  }
  const auto prediction = fit_prediction(channels, 0, range.end - range.first, middle, reach);
  if (!prediction) return std::nullopt;
  std::vector<PredictedSamples> out;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    // A constant channel needs no prediction.
    if (!(prediction->forward_std[c] > 0 && prediction->backward_std[c] > 0)) continue;
    const Interpolation found =
        interpolate_samples(*prediction, c, channels[c], at.gap.first - range.first, at.gap.count);
    if (!(found.square <= kMaxErrorRms * kMaxErrorRms * static_cast<double>(found.freedom))) return std::nullopt;
    out.push_back({.row = at.gap.row,
                   .channel = c,
                   .first = at.gap.first,
                   .samples = {found.samples.begin(), found.samples.end()}});
  }
  return out;
}

void overlay(const PredictedSamples& predicted, std::size_t first, std::span<double> out) {
  const std::size_t begin = std::max(first, predicted.first);
  const std::size_t end = std::min(first + out.size(), predicted.first + predicted.samples.size());
  for (std::size_t n = begin; n < end; ++n) out[n - first] = predicted.samples[n - predicted.first];
}

}  // namespace

bool can_predict(const GapInDecay& at) {
  if (at.gap.count > kMaxFault || at.gap.first < at.decay.first || at.gap.first + at.gap.count > at.decay.end)
    return false;
  const auto [range, middle, reach] = surroundings_of(at);
  return can_fit_prediction(0, range.end - range.first, middle, reach);
}

acquire::Record with_predicted_samples(const acquire::Record& record, const std::vector<GapInDecay>& gaps,
                                       std::vector<std::size_t>& failed) {
  auto all = std::make_shared<std::vector<PredictedSamples>>();
  for (std::size_t g = 0; g < gaps.size(); ++g) {
    auto of_gap = predicted(record, gaps[g]);
    if (!of_gap) failed.push_back(g);
    if (of_gap) std::move(of_gap->begin(), of_gap->end(), std::back_inserter(*all));
  }
  acquire::Record out = record;
  if (all->empty()) return out;
  out.contiguous.clear();
  out.read_accel_mps2 = [read = record.read_accel_mps2, all](std::size_t row, std::size_t channel, std::size_t first,
                                                             std::span<double> samples) {
    read(row, channel, first, samples);
    for (const PredictedSamples& one : *all) {
      if (one.row == row && one.channel == channel) overlay(one, first, samples);
    }
  };
  return out;
}

std::string samples_text(std::size_t count) { return fmt::format("{} sample{}", count, plural(count)); }

}  // namespace percuss::pipeline
