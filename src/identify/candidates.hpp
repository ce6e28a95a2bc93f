#pragma once
#include <cstddef>
#include <vector>

#include "identify/local_fit.hpp"

namespace percuss {

struct CandidateOptions {
  double prominence_dB = 3;  // above the saddles, before noise is allowed for
  double snr = 5;            // amplitude over noise at the peak
};

/// First poles from the prominent maxima of Σ|H|² over the outputs, in ascending frequency.
std::vector<Pole> candidate_poles(const FrfSet& set, const CandidateOptions& options = {});

/// A first pole from the lines around a frequency.
Pole pole_near(const FrfSet& set, double freq_Hz);

}  // namespace percuss
