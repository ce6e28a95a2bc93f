#include "pipeline/response/response_impacts.hpp"

#include <algorithm>
#include <cmath>

#include "acquire/hits/time_selection.hpp"
#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kBlock_s = 0.5e-3, kHistory_s = 20e-3;
constexpr double kContact_s = 1.5e-3;                          // a soft tip needs this long to reach its largest force
constexpr std::size_t kMinBlock = 8;                           // samples
constexpr double kRise = 10;                                   // of the power, within a contact
constexpr double kMinPower = 3e-3;                             // of the strongest block's power
constexpr double kAboveQuiet = 30;                             // times the 20 % quantile of the row's block powers
constexpr std::size_t kMinHistoryBlocks = 5;                   // longer blocks in the history before a rise
constexpr std::size_t kBlockFactor = 4, kMaxBlockFactor = 16;  // blocks in a longer block: 4, then 16
constexpr double kMinMeanRate_Hz = 5000;                       // of the means whose differences are taken
// Factor by which a longer mean must raise the ratio of the largest to the quiet power.
constexpr double kMinClarityGain = 2;
constexpr double kAtStart = 0.5;  // of the strongest block's power: a blow within the first 20 ms of a row
constexpr std::size_t kNoiseBlocks = 20;
constexpr double kAboveNoise = 1.5;   // times the largest value in these blocks before the rise
constexpr double kOnsetLevel = 0.03;  // of the largest value in the rise

using Signals = std::vector<std::vector<double>>;  // [channels][samples]

// Lengths in samples, except where stated.
struct Blocks {
  std::size_t samples = 0;
  std::size_t history = 0, contact = 0;  // in blocks
  double above_quiet = kAboveQuiet;
};

Blocks blocks_at(double fs_Hz) {
  const auto samples = std::max(kMinBlock, static_cast<std::size_t>(std::lround(kBlock_s * fs_Hz)));
  const auto whole = [&](double time_s) { return static_cast<std::size_t>(std::lround(time_s * fs_Hz)) / samples; };
  return {.samples = samples,
          .history = std::max<std::size_t>(2, whole(kHistory_s)),
          .contact = std::max<std::size_t>(1, whole(kContact_s))};
}

// Blocks that are `times` times as long: the power of noise hardly varies between them. The history before a rise has
// at least five of them, which is longer than the time in which a beat of two modes rises tenfold.
Blocks longer_blocks(const Blocks& blocks, std::size_t times) {
  return {.samples = blocks.samples * times,
          .history = std::max(kMinHistoryBlocks, blocks.history / times),
          .contact = 1,
          .above_quiet = kRise};
}

// The mean of `length` samples from n on minus the mean of as many before n; 0 if there are not enough samples.
Signals differences(const Signals& x, std::size_t length) {
  Signals out(x.size());
  for (std::size_t c = 0; c < x.size(); ++c) {
    const std::vector<double>& one = x[c];
    out[c].assign(one.size(), 0);
    for (std::size_t n = length; n + length <= one.size(); ++n) {
      double sum = 0;
      for (std::size_t i = 0; i < length; ++i) sum += one[n + i] - one[n - 1 - i];
      out[c][n] = sum / static_cast<double>(length);
    }
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

// The differences that show a blow most clearly. At a high sampling rate the differences of single samples consist of
// the noise of high frequencies, which a soft blow does not excite.
Signals clearest_differences(const Signals& x, const Blocks& blocks, double fs_Hz) {
  const auto clearness = [&](const Signals& signals) {
    const std::vector<double> power = block_power(signals, blocks.samples);
    const double quiet = quiet_level(power);
    return quiet > 0 ? extremes_of(power).high / quiet : 0;
  };
  Signals out = differences(x, 1);
  double most = clearness(out);
  for (std::size_t length = 2; fs_Hz >= kMinMeanRate_Hz * static_cast<double>(length); length *= 2) {
    Signals longer = differences(x, length);
    const double clear = clearness(longer);
    if (!(clear > kMinClarityGain * most)) continue;
    most = clear;
    out = std::move(longer);
  }
  return out;
}

// Whether no block of the row stands out of the others. The first blocks of a decay do, if the decay loses 90 % of its
// power within the row.
bool is_quiet(const Signals& differences, std::size_t block) {
  const std::vector<double> power = block_power(differences, block);
  return power.size() >= kMinHistoryBlocks && extremes_of(power).high <= kRise * quiet_level(power);
}

double median_after(const std::vector<double>& power, std::size_t b, std::size_t history) {
  const std::size_t last = std::min(b + 1 + history, power.size());
  return median({power.begin() + static_cast<std::ptrdiff_t>(b), power.begin() + static_cast<std::ptrdiff_t>(last)});
}

std::vector<std::size_t> rising_blocks(const std::vector<double>& power, const Blocks& blocks) {
  const double strongest = extremes_of(power).high, weakest = kMinPower * strongest;
  const double least = std::max(weakest, blocks.above_quiet * quiet_level(power));
  std::vector<std::size_t> out;
  for (std::size_t b = 1; b < power.size(); ++b) {
    if (power[b] < weakest) continue;
    const std::size_t rise = std::min(b, blocks.contact), from = b - std::min(b, blocks.history);
    const double before =
        *std::max_element(power.begin() + static_cast<std::ptrdiff_t>(from),
                          power.begin() + static_cast<std::ptrdiff_t>(std::max(from + 1, b + 1 - rise)));
    const bool ringing = !out.empty() && b - out.back() <= blocks.history;
    // A row that begins just before the blow and ends within the decay has no quiet part. Its blow is strong, and the
    // decay after it is strong, too. Noise is strong in one block only.
    const bool at_start = from == 0 &&
                          std::max(power[b], power[std::min(b + 1, power.size() - 1)]) > kAtStart * strongest &&
                          median_after(power, b, blocks.history) > kRise * before;
    if (power[b] > kRise * before && !ringing && (power[b] > least || at_start)) out.push_back(b);
  }
  return out;
}

// The first sample of the rise, searched from a contact time before the block `block_index` to the end of the next
// block. At this sample, a channel exceeds the fraction kOnsetLevel of its largest value in the searched part, and
// kAboveNoise times its largest value in the kNoiseBlocks blocks before this part.
std::size_t onset_in(const Signals& x, std::size_t block_index, const Blocks& blocks) {
  const std::size_t block = blocks.samples;
  const std::size_t first = std::max<std::size_t>((block_index - std::min(block_index, blocks.contact)) * block, 1);
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

// The impacts in the samples `x` of a row, ascending, without their ends; indices count from the beginning of `x`.
std::vector<ResponseImpact> impacts_in(const Signals& x, std::size_t row, const Blocks& blocks, double fs_Hz) {
  std::vector<ResponseImpact> found;
  const auto find_in = [&](const Signals& signals, const Blocks& of) {
    for (const std::size_t b : rising_blocks(block_power(signals, of.samples), of)) {
      const std::size_t first = onset_in(signals, b, of);
      const bool known = std::any_of(found.begin(), found.end(), [&](const ResponseImpact& one) {
        return std::max(one.first, first) - std::min(one.first, first) <= (of.history + 2) * of.samples;
      });
      if (!known) found.push_back({.row = row, .first = first});
    }
  };
  // A blow excites all frequencies, so the differences of the samples show it even during slow motion. If they show no
  // blow, the samples themselves are searched: the blow may excite only a slow mode, whose differences lie below the
  // noise although its samples exceed it.
  const Signals clearest = clearest_differences(x, blocks, fs_Hz);
  find_in(clearest, blocks);
  if (found.empty()) find_in(centred(x), blocks);
  // A weak blow in noise shows only in the mean power over a longer time.
  for (std::size_t times = kBlockFactor; times <= kMaxBlockFactor; times *= kBlockFactor)
    find_in(clearest, longer_blocks(blocks, times));
  std::sort(found.begin(), found.end(),
            [](const ResponseImpact& a, const ResponseImpact& b) { return a.first < b.first; });
  const bool moves =
      std::any_of(x.begin(), x.end(), [](const auto& one) { return extremes_of(one).high > extremes_of(one).low; });
  if (found.empty() && moves) {
    const bool quiet = is_quiet(clearest, blocks.samples * kMaxBlockFactor);
    found.push_back({.row = row, .first = 0, .whole_pulse = false, .quiet = quiet});
  }
  return found;
}

}  // namespace

std::vector<ResponseImpact> response_impacts(const acquire::Record& record, const acquire::HitOptions& options) {
  const Blocks blocks = blocks_at(record.fs_Hz);
  std::vector<ResponseImpact> out;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const acquire::SampleRange range = acquire::select_time_range(record, row, options);
    const std::size_t samples = range.last - range.first;
    if (samples < 4 * blocks.samples) continue;
    Signals x(record.accel.size(), std::vector<double>(samples));
    for (std::size_t c = 0; c < x.size(); ++c) record.read_accel_mps2(row, c, range.first, x[c]);
    std::vector<ResponseImpact> found = impacts_in(x, row, blocks, record.fs_Hz);
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].end = i + 1 < found.size() ? found[i + 1].first - std::min(found[i + 1].first, blocks.samples) : samples;
      found[i].first += range.first;
      found[i].end += range.first;
      out.push_back(found[i]);
    }
  }
  return out;
}

}  // namespace percuss::pipeline
