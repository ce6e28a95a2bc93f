#include "acquire/hits/decaying_lines.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kMinPeriods = 8;  // of the lower end of the band in a segment: the window separates it from drift
constexpr std::size_t kMaxSegment = std::size_t{1} << 14U;
constexpr double kAboveLineNoise = 25;   // times the median power; 1 of 3·10^7 noise lines exceeds it
constexpr double kDecayRatio = 1.5;      // of powers; the power of hum changes less
constexpr std::size_t kFloorLines = 32;  // give a median

// Samples of a segment, a power of two; 0 where two segments that resolve the band have no room.
std::size_t segment_samples(std::size_t length, std::size_t room, double low) {
  if (!(kMinPeriods / low < static_cast<double>(room / 2))) return 0;
  const std::size_t least = std::bit_ceil(static_cast<std::size_t>(std::ceil(kMinPeriods / low)));
  // A mode that has decayed far within `length` decays further within half of it.
  const std::size_t best =
      std::clamp(std::bit_floor(std::max<std::size_t>(length / 2, 1)), least, std::max(least, kMaxSegment));
  const std::size_t samples = std::min(best, std::bit_floor(std::max<std::size_t>(room / 2, 1)));
  return samples < least ? 0 : samples;
}

// Powers of the spectral lines of a segment under a Blackman–Harris window, without its mean; the first and the last
// three are 0. Hum does not leak into the lines beside its main lobe. The window is applied to the lines.
std::vector<double> line_powers(std::span<const double> x) {
  double mean = 0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  std::vector<double> rest(x.begin(), x.end());
  for (double& value : rest) value -= mean;
  const std::vector<Complex> lines = real_dft_once(rest);
  std::vector<double> power(lines.size());
  for (std::size_t k = 3; k + 3 < lines.size(); ++k) {
    const auto beside = [&](std::size_t apart) { return lines[k - apart] + lines[k + apart]; };
    power[k] = std::norm(0.35875 * lines[k] - 0.244145 * beside(1) + 0.07064 * beside(2) - 0.00584 * beside(3));
  }
  return power;
}

// Medians of k times the power of line k, over blocks of lines from `first` on: noise of sensors and of the building
// often falls with frequency. The larger of two neighbours stands for each block.
std::vector<double> noise_of_blocks(const std::vector<double>& power, std::size_t first, std::size_t end) {
  std::vector<double> medians;
  for (std::size_t begin = first; begin < end; begin += kFloorLines) {
    std::vector<double> block;
    for (std::size_t k = begin; k < std::min(end, begin + kFloorLines); ++k)
      block.push_back(static_cast<double>(k) * power[k]);
    medians.push_back(median(std::move(block)));
  }
  std::vector<double> noise = medians;
  for (std::size_t b = 0; b < noise.size(); ++b) {
    if (b > 0) noise[b] = std::max(noise[b], medians[b - 1]);
    if (b == 0 && noise.size() > 1) noise[b] = std::max(noise[b], medians[1]);
  }
  return noise;
}

}  // namespace

bool has_decaying_lines(std::size_t length, std::size_t samples, const RelativeBand& band,
                        const SampleWindow& accel_mps2) {
  if (length >= samples) return false;
  const std::size_t count = segment_samples(length, samples - length, band.low);
  if (count == 0) return true;
  const std::size_t begin = length - std::min(length, count / 4);  // most of the window's weight lies after `length`
  const std::vector<double> here = line_powers(accel_mps2(begin, count));
  const std::vector<double> at_end = line_powers(accel_mps2(samples - count, count));
  const auto lines = static_cast<double>(count);
  const auto first = static_cast<std::size_t>(std::ceil(band.low * lines));
  const std::size_t end = std::min(here.size() - 1, static_cast<std::size_t>(std::floor(band.high * lines)) + 1);
  if (first >= end) return false;
  const std::vector<double> noise = noise_of_blocks(at_end, first, end);
  for (std::size_t k = first; k < end; ++k) {
    const double steady = std::max({at_end[k - 1], at_end[k], at_end[k + 1]});
    const double floor = noise[(k - first) / kFloorLines] / static_cast<double>(k);
    if (here[k] > kDecayRatio * steady + kAboveLineNoise * floor) return true;
  }
  return false;
}

}  // namespace percuss::acquire
