#include "pipeline/findings/sample_faults.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/findings/sample_prediction.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;

constexpr std::size_t kSurroundings = 900;  // samples on either side that the prediction is fitted to
constexpr std::size_t kReach = 44;          // samples around `at` within which a fault is searched
constexpr double kOutlier = 6;              // standard deviations of the prediction errors
constexpr std::size_t kMaxVaried = 8;       // wrong samples that are not equal: a longer run may be a burst of noise
constexpr double kClearFault = 8;           // rms of the errors at a fault over the errors around
constexpr double kClearGap = 3;             // … at missing samples, whose number must fit as well
constexpr double kRepaired = 2.5;           // … at most, after a repair that explains the fault
constexpr double kDistinct = 30;            // χ² by which the best number of missing samples beats the others
constexpr std::size_t kSplices = 6;         // places tried between the last sample before a gap and the first after it

using Channels = std::span<const std::span<const double>>;

// The first sample with a forward outlier and the last with a backward outlier, in any channel.
struct Limits {
  std::optional<std::size_t> first, last;
};
Limits limits_of(const SamplePrediction& prediction, Channels channels, std::size_t at) {
  Limits out;
  for (std::size_t n = at - kReach; n <= at + kReach; ++n) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (!out.first && std::abs(forward_error(prediction, channels[c], n)) > kOutlier * prediction.forward_std[c])
        out.first = n;
      if (std::abs(backward_error(prediction, channels[c], n)) > kOutlier * prediction.backward_std[c]) out.last = n;
    }
  }
  return out;
}

// rms of the scaled forward errors over [first, first + count + order), over all channels.
double error_over(const SamplePrediction& prediction, Channels channels, std::size_t first, std::size_t count) {
  double square = 0;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t n = first; n < first + count + kPredictionOrder; ++n) {
      const double error = forward_error(prediction, channels[c], n) / prediction.forward_std[c];
      square += error * error;
    }
  }
  return std::sqrt(square / static_cast<double>(channels.size() * (count + kPredictionOrder)));
}

// A run of equal samples is wrong as a whole, also where one of them happens to be near the expected value.
void extend_constant(SampleFault& fault, Channels channels) {
  const auto equal = [&](std::size_t n, std::size_t to) {
    return std::all_of(channels.begin(), channels.end(), [&](auto x) { return x[n] == x[to]; });
  };
  while (fault.count < kMaxFault && equal(fault.first - 1, fault.first)) {
    --fault.first;
    ++fault.count;
  }
  while (fault.count < kMaxFault && equal(fault.first + fault.count, fault.first)) ++fault.count;
}

bool is_constant(const SampleFault& fault, Channels channels) {
  const double value = channels[0][fault.first];
  return std::all_of(channels.begin(), channels.end(), [&](auto x) {
    const auto run = x.subspan(fault.first, fault.count);
    return std::all_of(run.begin(), run.end(), [&](double sample) { return sample == value; });
  });
}

// Predicts the wrong samples of each channel as the repair. True if the repaired samples follow from their neighbours.
bool explain_wrong(SampleFault& fault, const SamplePrediction& prediction, Channels channels) {
  double square = 0, freedom = 0;
  fault.repair.resize(static_cast<Index>(fault.count), static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Interpolation expected = interpolate_samples(prediction, c, channels[c], fault.first, fault.count);
    fault.repair.col(static_cast<Index>(c)) = expected.samples;
    square += expected.square;
    freedom += static_cast<double>(expected.freedom);
    double size = 0;
    for (std::size_t i = 0; i < fault.count; ++i)
      size = std::max(size, std::abs(channels[c][fault.first + i] - expected.samples[static_cast<Index>(i)]));
    fault.channels.push_back(size > kOutlier * prediction.forward_std[c]);
    if (fault.channels[c]) fault.size = std::max(fault.size, size);
  }
  fault.error_after = std::sqrt(square / freedom);
  fault.constant = is_constant(fault, channels);
  return fault.error_after < kRepaired;
}

// Channels with `count` unknown samples inserted before `splice`.
std::vector<std::vector<double>> inserted(Channels channels, std::size_t splice, std::size_t count) {
  std::vector<std::vector<double>> out;
  constexpr std::size_t around = kPredictionOrder + 1;
  for (const auto x : channels) {
    std::vector<double> y(2 * around + count);
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(splice - around), around, y.begin());
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(splice), around,
                y.begin() + static_cast<std::ptrdiff_t>(around + count));
    out.push_back(std::move(y));
  }
  return out;
}

SampleFault with_missing(const SamplePrediction& prediction, Channels channels, std::size_t splice, std::size_t count) {
  SampleFault out;
  out.kind = SampleFault::Kind::missing;
  out.first = splice;
  out.count = count;
  out.channels.assign(channels.size(), true);
  out.repair.resize(static_cast<Index>(count), static_cast<Index>(channels.size()));
  const auto samples = inserted(channels, splice, count);
  double square = 0, freedom = 0;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Interpolation expected = interpolate_samples(prediction, c, samples[c], kPredictionOrder + 1, count);
    out.repair.col(static_cast<Index>(c)) = expected.samples;
    square += expected.square;
    freedom += static_cast<double>(expected.freedom);
  }
  out.error_after = std::sqrt(square / freedom);
  return out;
}

// The number and place of missing samples that restore the prediction, if one number does so much better than all
// others.
std::optional<SampleFault> explain_missing(const SamplePrediction& prediction, Channels channels, std::size_t last,
                                           std::size_t first) {
  std::vector<SampleFault> best;  // by count
  for (std::size_t count = 1; count <= kMaxFault; ++count) {
    std::optional<SampleFault> of_count;
    for (std::size_t splice = last + 1; splice <= first; ++splice) {
      SampleFault trial = with_missing(prediction, channels, splice, count);
      if (!of_count || trial.error_after < of_count->error_after) of_count = std::move(trial);
    }
    best.push_back(std::move(*of_count));
  }
  const auto found = std::min_element(best.begin(), best.end(), [](const SampleFault& a, const SampleFault& b) {
    return a.error_after < b.error_after;
  });
  if (found->error_after > kRepaired) return std::nullopt;
  const double least = found->error_after * found->error_after;
  for (auto other = best.begin(); other != best.end(); ++other) {
    const double freedom =
        static_cast<double>(2 * kPredictionOrder + other->count) * static_cast<double>(channels.size());
    if (other != found && (other->error_after * other->error_after / least - 1) * freedom < kDistinct)
      return std::nullopt;
  }
  return *found;
}

}  // namespace

std::optional<SampleFault> diagnose_samples(Channels channels, std::size_t at, const DecayRange& range) {
  static_assert(kDiagnosisRoom >= kReach + kMaxFault + 2 * kPredictionOrder);
  if (channels.empty() || at < range.first + kDiagnosisRoom || at + kDiagnosisRoom > range.end) return std::nullopt;
  const std::size_t first = std::max(range.first, at - std::min(at, kSurroundings));
  const std::size_t end = std::min(range.end, at + kSurroundings);
  const auto prediction = fit_prediction(channels, first, end, at, kReach);
  if (!prediction) return std::nullopt;
  for (const double std : prediction->forward_std) {
    if (!(std > 0)) return std::nullopt;
  }
  for (const double std : prediction->backward_std) {
    if (!(std > 0)) return std::nullopt;
  }
  const Limits limits = limits_of(*prediction, channels, at);
  if (!limits.first || !limits.last) return std::nullopt;
  SampleFault fault;
  fault.first = *limits.first;
  fault.error_before = error_over(*prediction, channels, fault.first, 0);
  if (fault.error_before < kClearGap) return std::nullopt;
  if (*limits.last >= *limits.first && *limits.last - *limits.first < kMaxFault) {
    SampleFault wrong = fault;
    wrong.kind = SampleFault::Kind::wrong;
    wrong.count = *limits.last - *limits.first + 1;
    extend_constant(wrong, channels);
    const bool clear = fault.error_before > kClearFault && (wrong.count <= kMaxVaried || is_constant(wrong, channels));
    if (clear && explain_wrong(wrong, *prediction, channels)) return wrong;
  } else if (*limits.first > *limits.last && *limits.first - *limits.last <= kSplices) {
    if (auto missing = explain_missing(*prediction, channels, *limits.last, *limits.first)) {
      missing->error_before = fault.error_before;
      return missing;
    }
  }
  return fault.error_before > kClearFault ? std::optional(fault) : std::nullopt;
}

}  // namespace percuss::pipeline
