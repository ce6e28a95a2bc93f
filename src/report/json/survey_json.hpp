#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The document percuss/analysis/1 of a survey: as analysis_json, with families and orders as the shapes tell them, and
///   modes[].shape  normalisation, collinearity, orders on the tube, values per point
///   roving, geometry, auto_mac, frac, driving_point, reciprocity
/// verdicts and warnings of `options` are the survey's, whatever is given.
std::string survey_json(const pipeline::Survey& survey, JsonOptions options = {});

}  // namespace percuss::report
