#pragma once
#include "metrics/study/study.hpp"

namespace percuss::metrics {

/// The figures of [8] and their kind for other lengths, empty ones left out, without statistics. (A figure of one
/// length holds one class; one of all lengths a class per length, and that of all.)
std::vector<StudyFigure> study_figures_of(const std::vector<StudyBat>& bats);

/// The statements of [8], section 4.8, without statistics.
std::vector<StudyStatement> published_statements();

}  // namespace percuss::metrics
