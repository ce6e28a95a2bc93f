#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"
#include "synth/spec.hpp"

namespace percuss::synth {

/// One hit as it truly was.
struct TrueHit {
  std::size_t row = 0;
  std::size_t point = 0;
  double onset_s = 0;  // from the row's start
  double width_s = 0;
  double peak_N = 0;          // 0: no pulse
  std::string flag = "good";  // good, double, weak, missing, late, reversed, clipped
  double second_delay_s = 0;  // 0: one pulse only
  double second_peak_N = 0;
  bool reversed = false;  // the force is recorded with the wrong sign
};

/// Standard deviations that no unbiased estimator beats: known force, white noise on the accelerations, unknown f, ζ,
/// residues and rigid-body line; all hits of one run.
struct CramerRaoBound {
  std::vector<double> freq_std_Hz;
  std::vector<double> damping_ratio_std;
};

/// What the record was made from. Accelerance, [point][channel]:
///   H(ω) = rigid + Σ_r residue_r (−ω²)/(ω_r² − ω² + 2jζ_rω_rω), unit 1/kg                       (1)
/// Residues and rigid line carry the sensors' signs and all gains, so that (1) is the FRF of the signals as recorded.
struct Truth {
  SynthSpec spec;
  std::vector<std::vector<std::vector<double>>> residue_per_kg;  // [point][channel][mode], modes as in spec.modes
  std::vector<std::vector<double>> rigid_per_kg;                 // [point][channel]
  std::vector<TrueHit> hits;                                     // of one run; the others repeat them
  std::vector<double> accel_noise_mps2;                          // [channel], standard deviation
  std::vector<double> accel_clean_rms_mps2;                      // [channel]
  double force_noise_N = 0;
  std::optional<CramerRaoBound> bound;  // where there is noise on every acceleration
};

struct SyntheticTest {
  acquire::Record record;
  Truth truth;
};

/// The hammer test of `spec` as a record in memory (one row per hit; continuous: one row per run), with exactly known
/// truth: closed-form modal responses, both signals through one linear-phase anti-alias filter, so that their FRF is
/// (1) below 0.44 fs. Equal spec and seed give equal samples on any number of threads. Throws InputError as check()
/// does.
SyntheticTest synthesise(const SynthSpec& spec, std::size_t threads = 0);

/// (1) at the given frequencies.
std::vector<Complex> exact_accelerance(const Truth& truth, std::size_t point, std::size_t channel,
                                       std::span<const double> freq_Hz);

}  // namespace percuss::synth
