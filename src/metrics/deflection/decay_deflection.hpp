#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::metrics {

/// The deflection of a held structure that moves freely after an impact, about its position of rest.
struct DecayDeflection {
  std::size_t first = 0;                    // sample from which no force acts
  std::vector<double> deflection_m, std_m;  // [samples − first]
};

/// Fits free decays to an acceleration (identify/decay) and integrates them in closed form:
///   w(t) = Re Σ a (s + ω_c)/s · exp(st)/s²                                             (1)
/// with the high-pass ω_c of the charge amplifier undone. Unlike a double integral, its standard deviation does not
/// grow with time. Nothing where fewer than 64 samples follow the onset, where no decay is above the noise, or where 40
/// or more are. `onset` is the sample of the first touch. theory (7.9)
std::optional<DecayDeflection> decay_deflection(std::span<const double> accel_mps2, double fs_Hz, std::size_t onset,
                                                double highpass_corner_Hz);

}  // namespace percuss::metrics
