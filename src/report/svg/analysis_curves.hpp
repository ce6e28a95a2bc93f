#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The plotted curves of an FRF over Analysis::lines(). NaN marks gaps; a curve that is not known is empty.
struct FrfCurve {
  std::string name;              // "accel 1 (0°)"
  std::vector<double> level_dB;  // re 1 (m/s²)/N
  std::vector<double> phase_deg;
  std::vector<double> coherence;
  std::vector<double> above_dB;  // one standard deviation above, in dB over level_dB
  std::vector<double> fit_dB;    // of the fitted modes
};

/// Curves of the strongest FRFs, in the order of the file.
std::vector<FrfCurve> frf_curves(const pipeline::Analysis& analysis, std::size_t most = 8);

/// Equally spaced values of a hit.
struct HitSamples {
  double first = 0, step = 1;
  std::vector<double> value;
};

/// The plotted curves of a hit.
struct HitCurves {
  std::size_t index = 0;
  bool accepted = false;
  double bandwidth_Hz = 0;
  HitSamples force_N;        // over seconds from the onset; zero outside
  HitSamples response_mps2;  // of the first accelerometer over seconds from the onset; may be empty
  HitSamples spectrum_dB;    // of the force over Hz, relative to its largest line, to 1.5 times the bandwidth
  double noise_dB = 0;       // of the first accelerometer before the hit, as decay_dB; NaN: too few samples there
  HitSamples decay_dB;       // of the first accelerometer over seconds from peak force, 0 at its largest; may be empty
};

/// Curves of the first hits with a pulse.
std::vector<HitCurves> hit_curves(const pipeline::Analysis& analysis, std::size_t most = 12);

}  // namespace percuss::report
