#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// The ball on the beam (model/impact.hpp, its defaults) by both methods, over their step and over the number of modes;
/// errors of the coefficient of restitution against exact_cor(). A model has no records: times are over one bare
/// transform of kUnit_samples values.
inline constexpr std::size_t kUnit_samples = 65536;
Family study_impact(Extent extent, const TimingOptions& turns);

}  // namespace percuss::accuracy
