#pragma once
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/shapes/circumferential_orders.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "identify/shapes/shape_checks.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// The results that a survey's warnings are made from; [modes] unless stated otherwise.
struct SurveyResults {
  const std::vector<acquire::SignalInfo>& accel;  // [channels]
  bool has_samples = false;                       // of time signals: to_SI is per stored unit of the channel
  const std::vector<identify::Mode>& modes;
  bool has_geometry = false;
  identify::Roving roving = identify::Roving::hammer;
  const std::vector<identify::ModeShape>& shapes;
  const std::vector<std::optional<identify::TubeShape>>& tubes;
  const std::vector<identify::ModeClassification>& classifications;
  std::vector<identify::DrivingPointCheck> driving_checks;
  std::vector<identify::ReciprocityCheck> reciprocity;
  const std::vector<identify::SynthesisedFrf>& synthesis;  // [FRF channels]; `point` is an index into frf_points
  std::vector<int> frf_points;
  const PointNames& names;
  std::vector<std::size_t> repeated{};  // modes whose shapes are chosen so that some sensor does not see them
};

/// no_geometry, sensor_on_node, driving_point_sign, reciprocity, frac, double_peak.
std::vector<Warning> survey_warnings(const SurveyResults& survey);

/// A strong FRF that the modes do not explain: FRAC below 0.99, level within 20 dB of the strongest.
bool poorly_explained(const identify::SynthesisedFrf& frf);
/// Noise explains the misfit: without the noise share of the residual, 1 − FRAC is at most 1 %.
bool noise_alone(const identify::SynthesisedFrf& frf);

}  // namespace percuss::pipeline
