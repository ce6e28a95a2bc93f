#pragma once
#include <vector>

#include "identify/shapes/mac.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/survey_modes.hpp"

namespace percuss::pipeline {

/// The shapes of a survey in the single hits, [modes] (identify::ShapeInHits). Nothing if no point has several hits, or
/// if the hits are not known. A mode of a pair (SurveyModes::pairs) has no values: its residues are not those of the
/// analysis.
/// shapes  [modes] of `survey`
std::vector<identify::ShapeInHits> shapes_in_hits(const Analysis& analysis, const SurveyModes& survey,
                                                  const std::vector<identify::ModeShape>& shapes,
                                                  identify::Roving roving);

}  // namespace percuss::pipeline
