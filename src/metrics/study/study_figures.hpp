#pragma once
#include "metrics/study/study.hpp"

namespace percuss::metrics {

/// The figures of [8], and the same figures for other lengths, without statistics. Figures without bats are left out. A
/// figure of one length has one class; a figure of all lengths has a class per length and one of all bats.
std::vector<StudyFigure> study_figures_of(const std::vector<StudyBat>& bats);

/// The statements of [8], section 4.8, without statistics.
std::vector<StudyStatement> published_statements();

}  // namespace percuss::metrics
