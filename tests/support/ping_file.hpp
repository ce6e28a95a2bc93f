#pragma once
#include <string>
#include <vector>

// What a microphone records after a blow, as a WAV file.
namespace percuss::test {

/// A decaying sine; full scale is an amplitude of 1.
struct PingMode {
  double freq_Hz, damping_ratio, amplitude;
};
extern const std::vector<PingMode> kPing;
inline constexpr double kBlow_s = 0.21;  // time of the blow

/// One second at 44.1 kHz: the modes kPing from kBlow_s on, with 1 ms of rise, and white noise of this standard
/// deviation. The frequencies are `factor` times those of kPing.
std::vector<double> ping(double noise, double factor = 1);

/// A WAV file of 16 bits and one channel at 44.1 kHz, as recorders write it. `x` lies between −1 and 1.
std::string wav_of(const std::vector<double>& x);

}  // namespace percuss::test
