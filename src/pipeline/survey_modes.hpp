#pragma once
#include <cstddef>
#include <vector>

#include "identify/shapes/repeated_pair.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

/// The modes of a survey: the modes of its analysis, but with two modes of nearly one frequency in place of each mode
/// whose residues are not of rank one (identify::repeated_pair). Ascending.
struct SurveyModes {
  std::vector<identify::Mode> modes;
  std::vector<std::size_t> of_analysis;  // [modes] index into Analysis::modes()
  struct Pair {
    std::size_t first = 0;  // index into `modes`; the second follows
    bool resolved = false;  // see identify::RepeatedPair
    double split_std_Hz = 0;
  };
  std::vector<Pair> pairs;
};

/// driving  points by number. `roving`: only the residues of a roving hammer form one matrix of points and sensors.
SurveyModes survey_modes(const Analysis& analysis, identify::Roving roving,
                         const std::vector<identify::DrivingPoint>& driving);

/// The types of the survey's modes by two sensors. Without a pair, they are Analysis::classifications().
std::vector<identify::ModeClassification> classify_by_sensors(const Analysis& analysis, const SurveyModes& survey);

/// The modes of the pairs that are not resolved.
std::vector<std::size_t> unresolved_modes(const SurveyModes& survey);

/// repeated_modes: pairs that are not resolved.
std::vector<Warning> repeated_mode_warnings(const SurveyModes& survey, bool driving_point);

/// Corrects the warnings of an analysis that took two modes for one; does nothing if no pair is resolved. moving_modes,
/// hits_differ, local_fits and model_misfit are replaced by the warnings of the survey's modes. clock_mismatch is
/// removed if fewer than four modes have no partner.
void remove_consequences_of_pairs(const Analysis& analysis, const SurveyModes& survey, std::vector<Warning>& warnings);

}  // namespace percuss::pipeline
