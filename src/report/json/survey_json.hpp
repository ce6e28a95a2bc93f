#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The document percuss/analysis/1 of a survey: as analysis_json, with mode types and orders from the shapes. It adds
///   modes[].shape  normalisation, collinearity, orders on the tube, values per point
///   roving, geometry, auto_mac, frac, driving_point, reciprocity
///   motion         directions and places of the points, where the geometry or the record states them
/// The survey's classifications and warnings replace the ones in `options`.
std::string survey_json(const pipeline::Survey& survey, JsonOptions options = {});

}  // namespace percuss::report
