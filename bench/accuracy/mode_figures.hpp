#pragma once
#include <array>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "figures.hpp"
#include "identify/model/effort.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {

inline constexpr std::array kEfforts{identify::Effort::quick, identify::Effort::standard, identify::Effort::best};

/// The errors of the modes of each effort, over all modes and runs, without times. A true mode is found when an
/// identified mode is at most one half-power bandwidth away; nearest pairs come first, and each mode counts once.
///   error       √(mean (f̂/f − 1)²), ppm, of the modes found
///   over_bound  √(mean ((f̂ − f)/σ_f)²), σ_f the Cramér–Rao bound (synth/synthesise.hpp)                   (1)
///   more        relative error of the damping ratio, %; the same over its bound;
///               coverage of the stated 95 % intervals, %; modes found, %; spurious modes per run
std::vector<Figure> mode_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth);

}  // namespace percuss::accuracy
