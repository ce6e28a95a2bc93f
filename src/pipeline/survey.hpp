#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "core/lazy.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/shapes/circumferential_orders.hpp"
#include "identify/shapes/mac.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "identify/shapes/shape_checks.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

struct SurveyOptions {
  std::optional<acquire::Geometry> geometry;  // absent: the record's own
  identify::Roving roving = identify::Roving::hammer;
  std::vector<identify::DrivingPoint> driving;  // the user's; absent: points that lie where a sensor sits
};

/// A test of many points: what the modes' residues, and where their points lie, say of the structure. Computed as far
/// as asked and kept; `analysis` must outlive it. Not for use by several threads at once.
class Survey {
 public:
  /// errors  InputError: a point that was hit stands nowhere in the geometry given; a driving point that was not
  /// measured.
  Survey(const Analysis& analysis, SurveyOptions options);

  const Analysis& analysis() const { return analysis_; }
  const SurveyOptions& options() const { return options_; }
  const std::optional<acquire::Geometry>& geometry() const { return geometry_; }
  const std::vector<identify::DrivingPoint>& driving_points() const { return driving_; }

  const std::vector<identify::ModeShape>& shapes() const;  // [modes]
  const std::vector<std::optional<identify::TubeShape>>& tubes()
      const;  // [modes]; nothing where the geometry is no tube
  /// Named from the shapes where these tell, else from two sensors as analyze names them.
  const std::vector<identify::ModeClassification>& classifications() const;
  const std::vector<std::vector<identify::Mac>>& macs() const;  // [modes][modes]
  /// Lines of the band asked for.
  frf::LineRange band() const;
  const std::vector<identify::SynthesisedFrf>& synthesis()
      const;                                 // [outputs], point as an index into the analysis's frf_points()
  const Eigen::MatrixXd& indicator() const;  // CMIF [lines of band(), values]
  std::vector<identify::DrivingPointCheck> driving_checks() const;
  std::vector<identify::ReciprocityCheck> reciprocity() const;
  /// The analysis' warnings and the survey's own.
  std::vector<Warning> warnings() const;

 private:
  void place_points();
  void find_driving_points();
  std::vector<identify::ModeClassification> classify_by_shapes() const;

  const Analysis& analysis_;
  SurveyOptions options_;
  std::optional<acquire::Geometry> geometry_;
  identify::TubeGeometry places_;
  std::vector<identify::DrivingPoint> driving_;
  Lazy<std::vector<identify::ModeShape>> shapes_;
  Lazy<std::vector<std::optional<identify::TubeShape>>> tubes_;
  Lazy<std::vector<identify::ModeClassification>> verdicts_;
  Lazy<std::vector<std::vector<identify::Mac>>> macs_;
  Lazy<std::vector<identify::SynthesisedFrf>> synthesis_;
  Lazy<Eigen::MatrixXd> indicator_;
};

/// An FRF that the modes do not explain although it is strong: FRAC below 0.99 within 20 dB of the strongest.
bool poorly_explained(const identify::SynthesisedFrf& frf);
/// … and what no mode could explain is all that is missing: less than 1 % is left but what changes from line to line.
bool noise_alone(const identify::SynthesisedFrf& frf);

/// Warnings of a survey: sensors that sit on nodes, wrong signs, broken reciprocity, FRFs that the modes do not
/// explain.
std::vector<Warning> survey_warnings(const Survey& survey);

}  // namespace percuss::pipeline
