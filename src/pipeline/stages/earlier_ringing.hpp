#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/decay/decay_spectra.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/stages/frf_averages.hpp"

namespace percuss::pipeline {

/// The ringing of earlier blows that lasts into a hit.
struct EarlierRinging {
  std::size_t hit = 0;
  std::vector<identify::DecayRate> rates;  // of the modes that ring; empty: too few samples before the hit
  Eigen::MatrixXcd amplitude;              // [rates, channels] at the hit's first sample, m/s²
  Eigen::MatrixXd std;                     // [rates, channels] of its real and of its imaginary part
  double share = 0;                        // largest amplitude over the largest |x| of its response
  bool explained = false;                  // these modes explain the motion before the hit
};

/// Whether the structure may still ring when it is hit: it was struck before in the same row, or it moves before the
/// hit.
bool may_ring_at_hits(const std::vector<AnalysedHit>& hits);

/// The accepted hits into which earlier ringing lasts: it changes a residue by more than 0.3 of its standard deviation,
/// or it stands out of the noise before the hit. The ringing is measured in the samples before the hit, with the poles
/// of `modes`. It is measured where the modes, the force of the last blow in the same row and the time since then
/// predict such a change, or where a response moves before the hit. `modes` belong to `set`, the average of the
/// accepted hits. theory (3.7)
std::vector<EarlierRinging> find_earlier_ringing(const acquire::Record& record, const identify::FrfDataset& set,
                                                 const TestSpectra& spectra, const std::vector<identify::Mode>& modes);

/// The responses without the ringing in the list `ringing`, which must not be empty. The result refers to `measured`,
/// which must outlive it.
HitResponses without_ringing(const HitResponses& measured, const std::vector<EarlierRinging>& ringing,
                             const std::vector<AnalysedHit>& hits, const TransformOptions& options);

/// Adds the uncertainty of the ringing that was subtracted to the residues' standard deviations.
void add_ringing_std(const std::vector<EarlierRinging>& ringing, const identify::FrfDataset& set,
                     const TestSpectra& spectra, std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
