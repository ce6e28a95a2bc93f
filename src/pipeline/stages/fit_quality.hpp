#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/model/mode.hpp"
#include "identify/start/unmodelled_peaks.hpp"

namespace percuss::pipeline {

/// How well the modes and residual terms explain one FRF over the band:
///   H = Σ modes + lower + upper (jω)² + upper4 (jω)⁴ + upper6 (jω)⁶, with jω + σ under an exponential window
struct FrfFit {
  std::size_t point = 0;  // index into FrfDataset::points
  std::size_t channel = 0;
  double frac = 0;  // 1: equal up to one factor
  Complex lower;    // of the modes below the band and the rigid body, 1/kg
  Complex upper;    // of the modes above the band, m/N
  Complex upper4;   // their next term, m·s²/N
  Complex upper6;   // … m·s⁴/N
};

struct FitQuality {
  std::vector<FrfFit> frfs;       // [FRFs] in the order of FrfDataset::channels
  std::vector<double> mode_frac;  // [modes] over all FRFs, within three half-power bandwidths of each mode
};

/// `made`: the FRFs of all fitted modes over `band`, which lies within set.lines. `modes`: the modes whose FRAC is
/// wanted.
FitQuality fit_quality(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                       const std::vector<identify::SynthesisedFrf>& made, const acquire::LineRange& band);

/// Peaks that no mode models and that stand clearly out of the noise (identify::clear_of_noise), down to 65 dB below
/// the largest line; the largest first.
/// beyond  modes of the margin (identify::unmodelled_peaks)
std::vector<identify::UnmodelledPeak> unexplained_peaks_of(const identify::FrfDataset& set,
                                                           const std::vector<identify::Mode>& modes,
                                                           const std::vector<identify::Mode>& beyond = {});

}  // namespace percuss::pipeline
