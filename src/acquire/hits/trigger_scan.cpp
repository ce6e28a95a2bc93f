#include "acquire/hits/trigger_scan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "core/parallel/per_thread.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 18;  // samples per task
constexpr std::size_t kPart = std::size_t{1} << 15;   // samples per read: 256 KiB stay in the cache
// A block of the envelope has the largest power of two of samples within 10 ms, but at least 8 and at most 64. Short
// blocks keep neighbouring hits apart at low sampling rates.
constexpr double kBlock_s = 0.01, kMinBlock = 8, kMaxBlock = 64;
constexpr std::size_t kNoiseSamples = 1024;  // per chunk: give a standard deviation to 4 %

std::size_t samples_per_block(double fs_Hz) {
  return std::bit_floor(static_cast<std::size_t>(std::clamp(kBlock_s * fs_Hz, kMinBlock, kMaxBlock)));
}

struct Envelope {
  std::size_t block = 0;  // samples
  std::vector<Extremes> blocks;
  std::vector<double> chunk_median, chunk_noise;
};

Envelope envelope_of(const Record& record, std::size_t row, std::size_t first, std::size_t last) {
  // Chunks of equal size: a short last chunk would count as much as the others in the median over chunks.
  const std::size_t chunks = (last - first + kChunk - 1) / kChunk;
  const std::size_t block = samples_per_block(record.fs_Hz);
  const std::size_t size = ((last - first) / chunks / block + 1) * block;
  const std::size_t used = (last - first + size - 1) / size;
  std::vector<std::vector<Extremes>> blocks(used);
  Envelope envelope{.block = block,
                    .blocks = {},
                    .chunk_median = std::vector<double>(used),
                    .chunk_noise = std::vector<double>(used)};
  parallel_for_cost(used, size, [&](std::size_t c) {
    static const PerThread<std::vector<double>> buffers;  // one per thread, not one per chunk
    std::vector<double>& buffer = buffers.local();
    std::vector<double> subset;
    const std::size_t begin = first + c * size, end = std::min(begin + size, last);
    for (std::size_t at = begin; at < end; at += kPart) {
      const auto part = record.read_force_N.view_or_read(row, at, std::min(kPart, end - at), buffer);
      const std::vector<Extremes> part_blocks = block_extremes(part, block);
      blocks[c].insert(blocks[c].end(), part_blocks.begin(), part_blocks.end());
      const std::size_t part_samples = std::max<std::size_t>(1, kNoiseSamples * part.size() / (end - begin));
      for (const double value : subsampled(part, part_samples)) subset.push_back(value);
    }
    const Spread spread = spread_of(std::move(subset));
    envelope.chunk_median[c] = spread.median;
    envelope.chunk_noise[c] = spread.robust_std;
  });
  for (const auto& part : blocks) envelope.blocks.insert(envelope.blocks.end(), part.begin(), part.end());
  return envelope;
}

// Reads a block again, to find the sample of the envelope's maximum.
std::size_t index_of_max(const Record& record, std::size_t row, std::size_t begin, std::size_t end, double baseline) {
  std::vector<double> buffer;
  const auto x = record.read_force_N.view_or_read(row, begin, end - begin, buffer);
  const auto further = [&](double a, double b) { return std::abs(a - baseline) < std::abs(b - baseline); };
  return begin + static_cast<std::size_t>(std::max_element(x.begin(), x.end(), further) - x.begin());
}

std::size_t largest_in(const std::vector<double>& distance, std::size_t first, std::size_t end) {
  const auto begin = distance.begin();
  const auto largest =
      std::max_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end));
  return static_cast<std::size_t>(largest - begin);
}

// The largest block of each event, ascending.
std::vector<std::size_t> event_blocks(const std::vector<double>& distance, std::size_t block, double trigger_N,
                                      double separation_s, double fs_Hz) {
  // The number of blocks between two blocks whose samples are all at least time_s apart.
  const auto blocks_in = [&](double time_s) {
    return (static_cast<std::size_t>(time_s * fs_Hz) + block - 1) / block + 1;
  };
  const std::size_t apart = blocks_in(separation_s), own = std::min(apart, blocks_in(kOwnHit_s));
  std::vector<std::size_t> events;
  for (std::size_t b = 0; b < distance.size();) {
    if (distance[b] < trigger_N) {
      ++b;
      continue;
    }
    std::size_t end = std::min(b + apart, distance.size()), best = largest_in(distance, b, end);
    // An earlier pulse that is a separate hit comes first.
    while (best >= b + own) {
      const std::size_t before = largest_in(distance, b, best - own + 1);
      if (distance[before] < kOwnHitFraction * distance[best]) break;
      best = before;
    }
    events.push_back(best);
    // Continue at a hit of its own, or after the separation from the largest block: the decay is not a second event.
    const std::size_t next = std::min(std::max(best + apart, end), distance.size());
    b = std::min(best + own, next);
    while (b < next && distance[b] < kOwnHitFraction * distance[best]) ++b;
  }
  return events;
}

}  // namespace

TriggerScan scan_for_triggers(const Record& record, std::size_t row, const TriggerOptions& options) {
  TriggerScan scan;
  const std::size_t last = std::min(options.last, record.rows.at(row).samples);
  if (options.first >= last) return scan;
  const Envelope envelope = envelope_of(record, row, options.first, last);
  scan.baseline_N = median(envelope.chunk_median);
  scan.noise_N = median(envelope.chunk_noise);
  std::vector<double> distance(envelope.blocks.size());
  for (std::size_t b = 0; b < distance.size(); ++b) distance[b] = envelope.blocks[b].max_distance_from(scan.baseline_N);
  const auto largest = std::max_element(distance.begin(), distance.end());
  scan.largest_N = *largest;
  const std::size_t begin = options.first + static_cast<std::size_t>(largest - distance.begin()) * envelope.block;
  scan.largest_first = begin;
  scan.largest_end = std::min(begin + envelope.block, last);
  scan.trigger_N =
      options.trigger_N.value_or(std::max(kTriggerNoise * scan.noise_N, kTriggerFraction * scan.largest_N));
  if (!(scan.largest_N > 0)) return scan;

  for (const std::size_t block :
       event_blocks(distance, envelope.block, scan.trigger_N, options.separation_s, record.fs_Hz)) {
    const std::size_t begin_sample = options.first + block * envelope.block;
    scan.events.push_back(
        index_of_max(record, row, begin_sample, std::min(begin_sample + envelope.block, last), scan.baseline_N));
  }
  return scan;
}

}  // namespace percuss::acquire
