#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

inline constexpr std::size_t kUnit_samples = 65536;  // length of the bare transform whose time is the unit

/// Measures the default impact of model/impact/impact.hpp by both methods, over the step and over the number of modes.
/// The error is the difference of the coefficient of restitution from exact_cor(). Times are multiples of one bare
/// transform of kUnit_samples values.
TaskFigures study_impact(Extent extent, const TimingOptions& timing);

}  // namespace percuss::accuracy
