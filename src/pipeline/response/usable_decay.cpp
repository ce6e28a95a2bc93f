#include "pipeline/response/usable_decay.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "acquire/hits/clipping.hpp"
#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kGate_s = 5e-3;          // of constant samples
constexpr double kBeforeGate_s = 20e-3;   // of motion before them
constexpr double kGateSteps = 10;         // of the resolution: a motion that dies out ends within them
constexpr std::size_t kMinConstant = 64;  // samples

// One past the last sample at a limit; 0 where no sample is clipped.
std::size_t end_of_clipping(std::span<const double> x) {
  const std::vector<Extremes> blocks = block_extremes(x, acquire::kClippingBlock);
  if (acquire::count_clipped_samples(x, blocks, x, median({x.begin(), x.end()})) == 0) return 0;
  const Extremes limits = extremes_of(blocks);
  std::size_t end = x.size();
  while (end > 0 && x[end - 1] != limits.low && x[end - 1] != limits.high) --end;
  return end;
}

// The first of many constant samples after a motion; x.size() where there are none.
std::size_t begin_of_gate(std::span<const double> x, double fs_Hz) {
  const auto least = std::max(kMinConstant, static_cast<std::size_t>(kGate_s * fs_Hz));
  const auto before = static_cast<std::size_t>(kBeforeGate_s * fs_Hz);
  for (std::size_t first = 0; first + least < x.size();) {
    std::size_t end = first + 1;
    while (end < x.size() && x[end] == x[first]) ++end;
    if (end - first >= least) {
      const std::span<const double> motion = x.subspan(first - std::min(first, before), std::min(first, before));
      const double moves = motion.empty() ? 0 : extremes_of(motion).max_distance_from(x[first]);
      if (moves > kGateSteps * acquire::resolution_of(x)) return first;
    }
    first = end;
  }
  return x.size();
}

}  // namespace

UsableDecay usable_decay(const acquire::Record& record, const ResponseImpact& impact) {
  UsableDecay out{.first = impact.first, .end = impact.end};
  std::vector<double> x(impact.end - impact.first);
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    record.read_accel_mps2(impact.row, c, impact.first, x);
    const std::size_t clipped = end_of_clipping(x), gate = begin_of_gate(x, record.fs_Hz);
    out.clipped = out.clipped || clipped > 0;
    out.gated = out.gated || gate < x.size();
    out.first = std::max(out.first, impact.first + clipped);
    out.end = std::min(out.end, impact.first + gate);
  }
  out.end = std::max(out.end, out.first);
  return out;
}

}  // namespace percuss::pipeline
