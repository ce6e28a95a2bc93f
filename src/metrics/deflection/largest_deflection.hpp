#pragma once
#include "metrics/deflection/deflection.hpp"

namespace percuss::metrics {

/// Finds the largest deflection of `d`: the sample whose magnitude exceeds four standard deviations by most. Finds the
/// same in the direction of the first motion. Sets the peak, larger_later and forward members; NaN where no deflection
/// exceeds four standard deviations.
/// The standard deviation of the double integral grows with time. A record is weak if this standard deviation decides
/// which sample counts as the largest: late values are then a random walk, and the rule above chooses a sample too
/// early. In a weak record of a held structure, the time of the largest deflection therefore comes from a curve without
/// growing noise: the integral while the force acts, the free decays (decay_deflection) after it. The value is the
/// integral's at this time, which is unbiased; NaN if it does not exceed four of its standard deviations.
void find_largest(const ImpactSignal& signal, const DeflectionOptions& options, Deflection& d);

}  // namespace percuss::metrics
