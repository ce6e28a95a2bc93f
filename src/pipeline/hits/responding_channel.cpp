#include "pipeline/hits/responding_channel.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kBlocks = 64;                      // of a hit, whose levels show whether a channel responds
constexpr std::size_t kMaxRead = std::size_t{1} << 20U;  // samples of a hit that are read for these blocks
constexpr double kMinResponseRatio = 10;                 // rms of the loudest block over the rms of the quietest block

double sum_of_squares(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum += value * value;
  return sum;
}

}  // namespace

std::optional<std::size_t> responding_channel(const acquire::Record& record, const acquire::Hit& hit) {
  std::vector<double> x(std::min(hit.samples, kMaxRead));
  for (std::size_t c = 0; c < record.accel.size() && x.size() >= kBlocks; ++c) {
    record.read_accel_mps2(hit.row, c, hit.first, x);
    const double rest = median(x);
    for (double& value : x) value -= rest;
    double loudest = 0, quietest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < kBlocks; ++b) {
      const std::size_t first = b * x.size() / kBlocks, end = (b + 1) * x.size() / kBlocks;
      const auto block = std::span<const double>(x).subspan(first, end - first);
      const double level = sum_of_squares(block) / static_cast<double>(block.size());
      loudest = std::max(loudest, level);
      quietest = std::min(quietest, level);
    }
    if (loudest > kMinResponseRatio * kMinResponseRatio * quietest) return c;
  }
  return std::nullopt;
}

}  // namespace percuss::pipeline
