#pragma once
#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
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
#include "pipeline/stated_driving_points.hpp"
#include "pipeline/survey_geometry.hpp"
#include "pipeline/survey_modes.hpp"
#include "pipeline/warnings/survey_warnings.hpp"

namespace percuss::pipeline {

struct SurveyOptions {
  std::optional<acquire::Geometry> geometry;         // default: the record's own
  std::optional<identify::Roving> roving{};          // default: as the record states, else the hammer
  std::vector<identify::DrivingPoint> driving;       // empty: those of the record, else points of a tube with a sensor
  std::vector<StatedDrivingPoint> stated_driving{};  // further ones, in the numbers that a user sees
  std::string geometry_source{};                     // file of the geometry, for messages; empty: none
};

/// A test of many points: mode shapes from the modes' residues and the points' positions. Costly results are computed
/// when first demanded, and kept. `analysis` must outlive it. Not for use by several threads at once.
class Survey {
 public:
  /// errors  InputError: a measured point that the given geometry lacks; a driving point that was not measured; a
  /// direction of a point in the geometry that differs from the record's; one direction in the geometry for a place
  /// that was measured in several.
  Survey(const Analysis& analysis, SurveyOptions options);

  const Analysis& analysis() const { return analysis_; }
  const SurveyOptions& options() const { return options_; }
  const std::optional<acquire::Geometry>& geometry() const { return geometry_; }
  const std::vector<identify::DrivingPoint>& driving_points() const { return driving_; }
  identify::Roving roving() const { return roving_; }
  /// The numbers of the places of the measured points. A place that was struck in several directions has several
  /// points.
  std::set<int> places() const;
  /// The place of a point in the geometry.
  int place_of(std::size_t point) const;
  /// The point of geometry() at the place of a measured point; nullptr without one.
  const acquire::GeometryPoint* geometry_point(std::size_t point) const;
  /// The stated places and directions of the points: with a roving hammer of the struck points (channel 0), else of the
  /// roving sensors. Sorted. If the record and its set-up state no direction of a point, the geometry's is taken.
  const std::vector<acquire::PointMotion>& motions() const { return motions_; }
  /// Whether the geometry states the direction of a measured point.
  bool geometry_has_directions() const { return geometry_has_directions_; }
  /// The number that the geometry's file has for a point of geometry(), whose numbers are the record's.
  int stated_number(int point) const;

  /// The analysis's modes, with two modes of nearly one frequency in the place of one whose residues need two shapes.
  /// All results of the survey are about these.
  const std::vector<identify::Mode>& modes() const { return split_modes().modes; }
  const SurveyModes& split_modes() const;
  /// [modes]; a value is positive along the positive direction that the geometry or the record states, if any.
  const std::vector<identify::ModeShape>& shapes() const;
  /// [modes]; nothing where the geometry is no tube.
  const std::vector<std::optional<identify::TubeShape>>& tubes() const;
  /// From the shapes where they decide, else from two sensors as Analysis::classifications().
  const std::vector<identify::ModeClassification>& classifications() const;
  const std::vector<std::vector<identify::Mac>>& macs() const;  // [modes][modes]
  /// Spectral lines of the analysis's band, without its margin.
  acquire::LineRange band() const;
  /// [channels of Analysis::fitted_frfs()]; `point` is an index into Analysis::frf_points().
  const std::vector<identify::SynthesisedFrf>& synthesis() const;
  const Eigen::MatrixXd& indicator() const;  // CMIF [lines of band(), singular values]
  std::vector<identify::DrivingPointCheck> driving_checks() const;
  std::vector<identify::ReciprocityCheck> reciprocity() const;
  /// The analysis's warnings and the survey's own, most serious first.
  std::vector<Warning> warnings() const;

 private:
  bool is_tube() const;
  void place_points();
  void find_motions();
  void find_driving_points();
  void find_driving_signs();
  std::optional<identify::TubeShape> shape_on_tube(const identify::ModeShape& shape) const;
  std::vector<identify::ModeClassification> classify_by_shapes() const;
  identify::LowerOrders lower_orders(const std::vector<identify::ModeClassification>& found) const;

  const Analysis& analysis_;
  SurveyOptions options_;
  identify::Roving roving_;
  std::optional<acquire::Geometry> geometry_;
  MatchedPoints matched_;
  std::vector<acquire::PointMotion> motions_;
  bool geometry_has_directions_ = false;
  std::vector<Warning> geometry_warnings_;  // also about the numbers of driving points
  identify::TubeGeometry tube_places_;
  std::vector<identify::DrivingPoint> driving_;
  Lazy<SurveyModes> split_modes_;
  Lazy<std::vector<identify::ModeShape>> shapes_;
  Lazy<std::vector<std::optional<identify::TubeShape>>> tubes_;
  Lazy<std::vector<identify::ModeClassification>> classifications_;
  Lazy<std::vector<std::vector<identify::Mac>>> macs_;
  Lazy<Eigen::MatrixXd> indicator_;
};

}  // namespace percuss::pipeline
