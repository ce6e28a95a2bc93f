#include "pipeline/channels/align_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace percuss::pipeline {
namespace {

// Taps on either side. The window's transition is 8/(2 kHalfTaps) = 0.1 of the sampling rate wide, with its middle at
// 0.5, so it begins at 0.45. The stated limit of 0.44 leaves a margin.
constexpr std::ptrdiff_t kHalfTaps = 40;

// Window of Nuttall with four terms: side lobes at −98 dB. u: −1 … 1.
double window(double u) {
  const double x = std::numbers::pi * u;
  return 0.3635819 + 0.4891775 * std::cos(x) + 0.1365995 * std::cos(2 * x) + 0.0106411 * std::cos(3 * x);
}

double sinc(double u) {
  const double x = std::numbers::pi * u;
  return std::abs(x) < 1e-6 ? 1 - x * x / 6 : std::sin(x) / x;
}

// A delay in whole samples, and the taps of the fraction beyond.
struct Shift {
  std::ptrdiff_t whole = 0;
  std::vector<double> taps;  // [2 kHalfTaps], for samples 1 − kHalfTaps … kHalfTaps from the whole one; empty: none
};

Shift shift_of(double samples) {
  Shift shift{.whole = static_cast<std::ptrdiff_t>(std::floor(samples)), .taps = {}};
  const double fraction = samples - static_cast<double>(shift.whole);
  if (fraction == 0) return shift;
  double sum = 0;
  for (std::ptrdiff_t k = 1 - kHalfTaps; k <= kHalfTaps; ++k) {
    const double u = static_cast<double>(k) - fraction;
    shift.taps.push_back(sinc(u) * window(u / static_cast<double>(kHalfTaps)));
    sum += shift.taps.back();
  }
  for (double& tap : shift.taps) tap /= sum;
  return shift;
}

}  // namespace

std::vector<ChannelDelay> stated_delays(const std::vector<double>& delay_s, const acquire::Record& record) {
  const std::size_t channels = record.accel.size();
  std::vector<ChannelDelay> out;
  if (delay_s.empty()) return out;
  if (delay_s.size() != 1 && delay_s.size() != channels) {
    throw InputError(fmt::format("{} delays for {} acceleration channels", delay_s.size(), channels), record.source(),
                     "give one per channel, or one for all", {"delay"});
  }
  for (std::size_t c = 0; c < channels; ++c)
    out.push_back({.channel = c, .delay_s = delay_s.size() == 1 ? delay_s.front() : delay_s[c]});
  for (const acquire::RowInfo& row : record.rows) {
    for (const ChannelDelay& one : out) {
      if (std::abs(one.delay_s) * record.fs_Hz < static_cast<double>(row.samples)) continue;
      throw InputError(fmt::format("a delay of {:g} s is longer than a row", one.delay_s), record.source(),
                       "give the delays in seconds", {"delay"});
    }
  }
  return out;
}

acquire::Record align_record(acquire::Record record, const std::vector<ChannelDelay>& delays) {
  std::vector<Shift> shifts(record.accel.size());
  for (const ChannelDelay& delay : delays) shifts[delay.channel] = shift_of(delay.delay_s * record.fs_Hz);
  std::vector<std::size_t> samples;
  samples.reserve(record.rows.size());
  for (const acquire::RowInfo& row : record.rows) samples.push_back(row.samples);
  const auto read = record.read_accel_mps2;
  record.contiguous.clear();
  record.read_accel_mps2 = [read, shifts, samples](std::size_t row, std::size_t channel, std::size_t first,
                                                   std::span<double> out) {
    const Shift& shift = shifts[channel];
    const auto end = static_cast<std::ptrdiff_t>(samples[row]);
    const std::ptrdiff_t taps = shift.taps.empty() ? 0 : kHalfTaps;
    const std::ptrdiff_t from =
        static_cast<std::ptrdiff_t>(first) + shift.whole - std::max<std::ptrdiff_t>(taps - 1, 0);
    const std::ptrdiff_t wanted = static_cast<std::ptrdiff_t>(out.size()) + std::max<std::ptrdiff_t>(2 * taps - 1, 0);
    const std::ptrdiff_t low = std::clamp<std::ptrdiff_t>(from, 0, end - 1);
    const std::ptrdiff_t high = std::clamp<std::ptrdiff_t>(from + wanted, low + 1, end);
    std::vector<double> held(static_cast<std::size_t>(high - low));
    read(row, channel, static_cast<std::size_t>(low), held);
    const auto at = [&](std::ptrdiff_t i) {
      return held[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(from + i, low, high - 1) - low)];
    };
    for (std::size_t n = 0; n < out.size(); ++n) {
      const auto here = static_cast<std::ptrdiff_t>(n);
      if (shift.taps.empty()) {
        out[n] = at(here);
        continue;
      }
      double sum = 0;
      for (std::ptrdiff_t k = 0; k < 2 * taps; ++k) sum += shift.taps[static_cast<std::size_t>(k)] * at(here + k);
      out[n] = sum;
    }
  };
  return record;
}

std::size_t samples_without_data(const std::vector<ChannelDelay>& delays, double fs_Hz) {
  double latest = 0;
  bool any = false;
  for (const ChannelDelay& delay : delays) {
    latest = std::max(latest, delay.delay_s * fs_Hz);
    any = any || delay.delay_s != 0;
  }
  return any ? static_cast<std::size_t>(std::ceil(latest)) + kHalfTaps : 0;
}

}  // namespace percuss::pipeline
