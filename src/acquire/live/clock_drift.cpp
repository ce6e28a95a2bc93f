#include "acquire/live/clock_drift.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::acquire {
namespace {

constexpr double kMinSeconds = 60;

}  // namespace

void ClockDrift::add(std::uint64_t frame, double now_s) {
  if (start_s_ < 0) {
    start_s_ = now_s;
    second_end_s_ = now_s + 1;
    first_frame_ = frame;
    return;
  }
  const double at_s = now_s - start_s_;
  const double late_s = at_s - static_cast<double>(frame - first_frame_) / fs_Hz_;
  if (now_s >= second_end_s_) {
    if (earliest_at_s_ > 0) {
      n_ += 1;
      t_ += earliest_at_s_;
      y_ += earliest_late_s_;
      tt_ += earliest_at_s_ * earliest_at_s_;
      ty_ += earliest_at_s_ * earliest_late_s_;
      yy_ += earliest_late_s_ * earliest_late_s_;
    }
    second_end_s_ = now_s + 1;
    earliest_at_s_ = 0;
  }
  if (earliest_at_s_ > 0 && late_s >= earliest_late_s_) return;
  earliest_late_s_ = late_s;
  earliest_at_s_ = at_s;
}

std::optional<ClockDrift::Estimate> ClockDrift::estimate() const {
  if (n_ < kMinSeconds) return {};
  const double mean_t = t_ / n_, mean_y = y_ / n_;
  const double var_t = tt_ / n_ - mean_t * mean_t, cov = ty_ / n_ - mean_t * mean_y, var_y = yy_ / n_ - mean_y * mean_y;
  const double slope = cov / var_t;
  const double residual = std::max(0.0, var_y - slope * cov);
  return Estimate{.relative = -slope, .standard_deviation = std::sqrt(residual / var_t / (n_ - 2))};
}

}  // namespace percuss::acquire
