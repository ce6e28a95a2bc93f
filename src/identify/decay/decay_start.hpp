#pragma once
#include <cstddef>
#include <span>

#include "identify/decay/free_decay_fit.hpp"

namespace percuss::identify {

/// A sample after which no hammer or ball touches the structure, in a record that begins with an impact: 20 ms after
/// the first sample, but at most an eighth of the record. `samples`: length of the record.
std::size_t safe_start(std::size_t samples, double fs_Hz);

/// Subtracts the fitted decays from samples `x` of response `signal`. The decays start at sample `start` of x; before
/// it they are extrapolated back.
void subtract_decays(const FreeDecayFit& fit, double fs_Hz, std::size_t signal, std::size_t start, std::span<double> x);

struct StartedFit {
  FreeDecayFit fit;
  std::size_t start = 0;  // sample of the records at which the fitted decays begin
};

/// fit_free_decays from the earliest sample on at which no force acts. `safe` is a sample by which the force has
/// certainly ended.
StartedFit fit_from_earliest_start(const FreeDecays& whole, std::size_t safe, const FreeDecayOptions& options);

}  // namespace percuss::identify
