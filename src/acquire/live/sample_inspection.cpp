#include "acquire/live/sample_inspection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::acquire {
namespace {

// The largest number of 16 bits is this far below full scale; converters with more bits are closer.
constexpr double kFullScaleStep = 1.0 / 32768;

}  // namespace

SampleInspection::SampleInspection(const StreamFormat& format)
    : channels_(format.channels),
      limits_(channels_, format.full_scale),
      second_frames_(static_cast<std::uint64_t>(std::max(1.0, std::ceil(format.fs_Hz)))),
      no_numbers_(channels_),
      overloads_(channels_) {
  if (!format.full_scales.empty()) limits_ = format.full_scales;
  for (double& limit : limits_)
    limit = limit > 0 ? limit * (1 - kFullScaleStep) : std::numeric_limits<double>::infinity();
}

void SampleInspection::add(std::uint64_t first_frame, std::span<const double> values,
                           std::vector<CaptureFinding>& findings) {
  if (first_frame >= second_end_) {
    finish(findings);
    second_end_ = first_frame + second_frames_;
  }
  const auto count = [](Count& kind, std::uint64_t frame) {
    if (kind.samples++ == 0) kind.first_frame = frame;
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double size = std::abs(values[i]);
    const std::size_t channel = i % channels_;
    if (size < limits_[channel]) continue;  // false for NaN
    if (!std::isfinite(size)) {
      count(no_numbers_[channel], first_frame + i / channels_);
    } else {
      count(overloads_[channel], first_frame + i / channels_);
    }
  }
}

void SampleInspection::finish(std::vector<CaptureFinding>& findings) {
  const auto take = [&](std::vector<Count>& counts, CaptureFault fault) {
    for (std::size_t c = 0; c < channels_; ++c) {
      if (counts[c].samples > 0)
        findings.push_back({.fault = fault, .frame = counts[c].first_frame, .count = counts[c].samples, .channel = c});
      counts[c] = {};
    }
  };
  take(no_numbers_, CaptureFault::not_a_number);
  take(overloads_, CaptureFault::overload);
}

}  // namespace percuss::acquire
