#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "identify/decay/decay_model.hpp"
#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

struct FreeDecayOptions {
  std::pair<double, double> band_Hz;
  std::vector<double> start_Hz{};    // frequencies that the search begins with
  std::vector<DecayRate> initial{};  // decays that the search begins with
  bool search = true;                // false: fit these and no others
  std::size_t max_decays = 200;      // a search that finds more ends there
};

/// All decays of a set of records, and the noise of their residual.
struct FreeDecayFit {
  std::vector<FittedDecay> decays;  // ascending in frequency
  std::vector<double> energy;       // [decays] over the noise, as DecayCandidate::energy
  double threshold = 0;             // the energy that noise exceeds once in 1000 searches
  Eigen::MatrixXd noise;            // [lines, hits × channels] E|R|² of the residual
  bool complete = true;             // false: the search ended at FreeDecayOptions::max_decays; the fit is rough
};

/// Finds the decays in the order of their energy, and fits them all together by maximum likelihood. Stops when the
/// residual holds no decay above the noise. A decay that no fit confirms (it runs away, or may only describe the misfit
/// of a stronger one) is left out.
FreeDecayFit fit_free_decays(const DecaySpectra& measured, const FreeDecayOptions& options);

}  // namespace percuss::identify
