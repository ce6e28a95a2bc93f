#pragma once
#include <cstdint>
#include <optional>

namespace percuss::acquire {

/// Compares the clock of a device with the computer's. Frames arrive in buffers, late by a random time. The earliest
/// arrival of each second has the least delay. The slope of a line through these arrivals is the difference of the
/// clocks.
class ClockDrift {
 public:
  explicit ClockDrift(double fs_Hz) : fs_Hz_(fs_Hz) {}

  /// `frame` frames had arrived at the time `now_s` of a clock that never jumps.
  void add(std::uint64_t frame, double now_s);

  struct Estimate {
    double relative = 0;  // rate of the device over the stated one − 1
    double standard_deviation = 0;
  };
  /// Nothing before a minute of arrivals.
  std::optional<Estimate> estimate() const;

 private:
  double fs_Hz_;
  double start_s_ = -1, second_end_s_ = 0;
  double earliest_late_s_ = 0, earliest_at_s_ = 0;
  std::uint64_t first_frame_ = 0;
  // Sums over seconds of t, lateness and their products.
  double n_ = 0, t_ = 0, y_ = 0, tt_ = 0, ty_ = 0, yy_ = 0;
};

}  // namespace percuss::acquire
