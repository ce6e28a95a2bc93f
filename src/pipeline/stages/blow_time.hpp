#pragma once
#include <optional>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// A mode rings at the end of the records if more than this part of its amplitude remains there; six time constants
/// leave this part.
inline constexpr double kRingingAmplitude = 0.0025;

/// The time from the beginning of the records to the blow, s, from given FRFs whose records end while modes still
/// ring. The FRFs of such records contain no motion in this time before the blow, although the modes of untruncated
/// FRFs would still ring in it. Nothing where all modes decay, where the records begin with the blow, or where the
/// noise hides the ringing.
/// set    the FRFs, without force
/// modes  from a fit that takes the FRFs for untruncated; their residues in the order of set.channels
/// theory (3.8)
std::optional<double> time_before_blow_s(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes);

/// The set with an impulse at this time as the force of each point, so that the fit allows for the truncation.
identify::FrfDataset with_blow_after(identify::FrfDataset set, double time_s);

}  // namespace percuss::pipeline
