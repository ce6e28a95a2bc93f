#pragma once
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/math/fft.hpp"

namespace percuss::pipeline {

/// A sinusoid that lasts from before a hit to the end of the record: hum of the mains, a machine.
struct Tone {
  double freq_Hz = 0;
  double share = 0;      // largest ratio of the amplitude in a response to the largest |x| of this response
  bool wanders = false;  // its phase changes along the record, so that no sinusoid removes it
};

/// Whether the frequency may be the fundamental of the mains: 50 or 60 Hz, or of a generator.
constexpr bool may_be_mains(double freq_Hz) { return freq_Hz > 45 && freq_Hz < 65; }

/// One response in which tones are searched: the samples of a row.
struct ToneSignal {
  std::span<const double> x;
  std::size_t hit = 0;              // the tones may have another phase at each hit
  std::span<const double> pulse_N;  // of the hit
  std::size_t pulse_first = 0;      // its first sample
  std::size_t quiet = 0;            // samples before the hit
  double largest = 0;               // |x|
  // The samples of the row just before x; may be empty. An earlier blow may still ring in them.
  std::span<const double> before{};
};

struct ToneFit {
  std::vector<Tone> tones;
  std::vector<std::vector<Complex>> amplitudes;  // [signals][tones] at sample 0 of the signal
};

/// Frequencies, in turns per sample, at which the last part of a response has a narrow peak that does not decay.
std::vector<double> tone_candidates(std::span<const double> x);

/// The candidates, of one or several responses, that are tones of the test and no modes. A tone was there before the
/// hits with the same phase, or its phase differs from hit to hit. Frequency and amplitudes come from the later part of
/// the signals, where most of the structure's motion has decayed. The signals have one length. theory (1.10)
ToneFit find_tones(std::span<const ToneSignal> signals, std::vector<double> candidates, double fs_Hz);

/// Subtracts the tones of signal `s` that do not wander.
void subtract_tones(const ToneFit& fit, std::size_t s, double fs_Hz, std::span<double> x);

}  // namespace percuss::pipeline
