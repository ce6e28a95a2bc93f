#include "pipeline/response/response_impacts.hpp"

#include <algorithm>
#include <cmath>

#include "acquire/hits/time_selection.hpp"
#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kBlock_s = 0.5e-3, kHistory_s = 20e-3;
constexpr std::size_t kMinBlock = 8;  // samples
constexpr double kRise = 10;          // of the power, in one block
constexpr double kWeakest = 3e-3;     // of the strongest block's power
constexpr double kAboveQuiet = 30;    // of the power in the quietest fifth of the row
constexpr double kAtStart = 0.5;      // of the strongest block's power: a blow within the first 20 ms of a row
constexpr std::size_t kNoiseBlocks = 20;
constexpr double kAboveNoise = 1.5;   // times the largest value in these blocks before the rise
constexpr double kOnsetLevel = 0.03;  // of the largest value in the rise

using Signals = std::vector<std::vector<double>>;  // [channels][samples]

Signals differences(const Signals& x) {
  Signals out = x;
  for (std::size_t c = 0; c < x.size(); ++c) {
    out[c].front() = 0;
    for (std::size_t n = 1; n < x[c].size(); ++n) out[c][n] = x[c][n] - x[c][n - 1];
  }
  return out;
}

// The signals without their offsets. Decays swing about the offset, so it is the median.
Signals centred(const Signals& x) {
  Signals out = x;
  for (std::vector<double>& channel : out) {
    const double offset = median(channel);
    for (double& value : channel) value -= offset;
  }
  return out;
}

// The power in blocks, as the sum over channels of each channel's share of its largest block.
std::vector<double> block_power(const Signals& x, std::size_t block) {
  std::vector<double> out(x.front().size() / block, 0.0);
  for (const std::vector<double>& channel : x) {
    std::vector<double> power(out.size(), 0.0);
    for (std::size_t b = 0; b < power.size(); ++b) {
      for (std::size_t n = b * block; n < (b + 1) * block; ++n) power[b] += channel[n] * channel[n];
    }
    const double largest = extremes_of(power).high;
    for (std::size_t b = 0; b < power.size() && largest > 0; ++b) out[b] += power[b] / largest;
  }
  return out;
}

double quiet_level(std::vector<double> power) {
  const auto at = power.begin() + static_cast<std::ptrdiff_t>(power.size() / 5);
  std::nth_element(power.begin(), at, power.end());
  return *at;
}

double median_after(const std::vector<double>& power, std::size_t b, std::size_t history) {
  const std::size_t last = std::min(b + 1 + history, power.size());
  return median({power.begin() + static_cast<std::ptrdiff_t>(b), power.begin() + static_cast<std::ptrdiff_t>(last)});
}

std::vector<std::size_t> rising_blocks(const std::vector<double>& power, std::size_t history) {
  const double strongest = extremes_of(power).high, weakest = kWeakest * strongest;
  const double least = std::max(weakest, kAboveQuiet * quiet_level(power));
  std::vector<std::size_t> out;
  for (std::size_t b = 1; b < power.size(); ++b) {
    if (power[b] < weakest) continue;
    const std::size_t from = b - std::min(b, history);
    const double before = *std::max_element(power.begin() + static_cast<std::ptrdiff_t>(from),
                                            power.begin() + static_cast<std::ptrdiff_t>(b));
    const bool ringing = !out.empty() && b - out.back() <= history;
    // A row that begins just before the blow and ends within the decay has no quiet part. Its blow is strong, and the
    // decay after it is strong, too. Noise is strong in one block only.
    const bool at_start = from == 0 &&
                          std::max(power[b], power[std::min(b + 1, power.size() - 1)]) > kAtStart * strongest &&
                          median_after(power, b, history) > kRise * before;
    if (power[b] > kRise * before && !ringing && (power[b] > least || at_start)) out.push_back(b);
  }
  return out;
}

// The first sample of the rise, searched in three blocks: the block before `block_index`, this block and the next one.
// At this sample a channel exceeds the noise before the three blocks, and the fraction kOnsetLevel of its largest value
// in them.
std::size_t onset_in(const Signals& x, std::size_t block_index, std::size_t block) {
  const std::size_t first = std::max<std::size_t>((block_index - 1) * block, 1);
  const std::size_t last = std::min((block_index + 2) * block, x.front().size());
  const std::size_t before = first - std::min(first - 1, kNoiseBlocks * block);
  std::size_t onset = last;
  for (const std::vector<double>& channel : x) {
    const auto largest_in = [&](std::size_t from, std::size_t to) {
      double largest = 0;
      for (std::size_t n = from; n < to; ++n) largest = std::max(largest, std::abs(channel[n]));
      return largest;
    };
    const double level = std::max(kOnsetLevel * largest_in(first, last), kAboveNoise * largest_in(before, first));
    for (std::size_t n = first; n < onset && level > 0; ++n) {
      if (std::abs(channel[n]) > level) onset = n;
    }
  }
  return onset < last ? onset : block_index * block;
}

}  // namespace

std::vector<ResponseImpact> response_impacts(const acquire::Record& record, const acquire::HitOptions& options) {
  const auto block = std::max(kMinBlock, static_cast<std::size_t>(std::lround(kBlock_s * record.fs_Hz)));
  const auto history =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(kHistory_s * record.fs_Hz)) / block);
  std::vector<ResponseImpact> out;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const acquire::SampleRange range = acquire::select_time_range(record, row, options);
    const std::size_t samples = range.last - range.first;
    if (samples < 4 * block) continue;
    Signals x(record.accel.size(), std::vector<double>(samples));
    for (std::size_t c = 0; c < x.size(); ++c) record.read_accel_mps2(row, c, range.first, x[c]);
    std::vector<ResponseImpact> found;
    const auto find_in = [&](const Signals& signals) {
      for (const std::size_t b : rising_blocks(block_power(signals, block), history))
        found.push_back({.row = row, .first = onset_in(signals, b, block)});
    };
    // A blow excites all frequencies, so the differences of the samples show it even during slow motion. If they show
    // no blow, the samples themselves are searched: the blow may excite only a slow mode, whose differences lie below
    // the noise although its samples exceed it.
    find_in(differences(x));
    if (found.empty()) find_in(centred(x));
    const bool moves =
        std::any_of(x.begin(), x.end(), [](const auto& one) { return extremes_of(one).high > extremes_of(one).low; });
    if (found.empty() && moves) found.push_back({.row = row, .first = 0, .whole_pulse = false});
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].last = i + 1 < found.size() ? found[i + 1].first - std::min(found[i + 1].first, block) : samples;
      found[i].first += range.first;
      found[i].last += range.first;
      out.push_back(found[i]);
    }
  }
  return out;
}

}  // namespace percuss::pipeline
