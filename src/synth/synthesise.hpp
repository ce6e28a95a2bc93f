#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"
#include "synth/spec.hpp"

namespace percuss::synth {

/// The true parameters of one hit.
struct TrueHit {
  std::size_t row = 0;
  std::size_t point = 0;
  double onset_s = 0;  // from the start of the row
  double width_s = 0;
  double peak_N = 0;          // 0: no pulse
  std::string flag = "good";  // good, double, weak, missing, late, reversed, clipped
  double second_delay_s = 0;  // 0: one pulse only
  double second_peak_N = 0;
  bool reversed = false;  // the force is recorded with the wrong sign
};

/// The smallest standard deviations of an unbiased estimator from all hits of one run. The force is known, the
/// accelerations have white noise, and f, ζ, residues and rigid-body accelerance are unknown.
struct CramerRaoBound {
  std::vector<double> freq_std_Hz;        // [modes]
  std::vector<double> damping_ratio_std;  // [modes]
};

/// The exact parameters of a record. Accelerance, [point][channel]:
///   H(ω) = rigid + Σ_r residue_r (−ω²)/(ω_r² − ω² + 2jζ_rω_rω), unit 1/kg                       (1)
/// Residues and rigid-body accelerance include the sensors' signs and all gains: (1) is the FRF of the recorded
/// signals.
struct Truth {
  SynthSpec spec;
  std::vector<std::vector<std::vector<double>>> residue_per_kg;  // [point][channel][mode], modes as in spec.modes
  std::vector<std::vector<double>> rigid_per_kg;                 // [point][channel]
  std::vector<TrueHit> hits;                                     // of one run; every run repeats them
  std::vector<double> accel_noise_mps2;                          // [channel], standard deviation
  std::vector<double> accel_clean_rms_mps2;                      // [channel]
  double force_noise_N = 0;
  std::optional<CramerRaoBound> bound;  // present with at least one mode and noise on every acceleration
};

struct SyntheticTest {
  acquire::Record record;
  Truth truth;
};

/// Synthesises the hammer test of `spec` as a record (one row per hit; continuous: one row per run) with exact truth.
/// The modal responses are closed forms. One linear-phase anti-alias filter acts on both signals, so their FRF is (1)
/// below 0.44 fs. Equal spec and seed give equal samples on any number of threads.
/// errors  InputError, as validate().
SyntheticTest synthesise(const SynthSpec& spec, std::size_t threads = 0);

/// Evaluates (1) at the given frequencies.
std::vector<Complex> exact_accelerance(const Truth& truth, std::size_t point, std::size_t channel,
                                       std::span<const double> freq_Hz);

}  // namespace percuss::synth
