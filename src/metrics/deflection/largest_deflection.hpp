#pragma once
#include "metrics/deflection/deflection.hpp"

namespace percuss::metrics {

/// Finds the largest deflection of `d` by magnitude, and the largest in the direction of the first motion, and sets the
/// peak, larger_later and forward members. NaN where no deflection is significant: four standard deviations.
/// The double integral's standard deviation grows with time. Its largest value late in a weak record is a random walk,
/// and the surest value comes early. So in the weak record of a held structure the time of the largest comes from a
/// curve without growing noise: the integral while the force acts, the free decays (decay_deflection) after it. The
/// value is the integral's at that time, which is unbiased.
void find_largest(const ImpactSignal& signal, const DeflectionOptions& options, Deflection& d);

}  // namespace percuss::metrics
