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

/// Errors of the modes that each effort finds, over all modes and runs; times are left out. A true mode is found when a
/// mode lies within its half-power bandwidth, nearest pairs first, each mode once.
///   error       √(mean (f̂/f − 1)²), ppm, of the modes found
///   over_bound  √(mean ((f̂ − f)/σ_f)²), σ_f Cramér and Rao's (synth/record.hpp: force known, all hits)     (1)
///   more        error of the damping ratio in % of it; the same over its bound; stated intervals of 95 % that hold the
///               truth, %; modes found, %; modes besides, per run
std::vector<Figure> mode_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth);

}  // namespace percuss::accuracy
