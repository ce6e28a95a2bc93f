#include "pipeline/survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "identify/classify/asymmetry_split.hpp"
#include "identify/start/cmif.hpp"
#include "pipeline/radial_shape.hpp"
#include "pipeline/shapes_in_hits.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "pipeline/warnings/reference_warnings.hpp"
#include "pipeline/warnings/three_wave_warnings.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kSamePlace_m = 2e-3;               // distance within which a hit and a sensor are at one point …
constexpr double kSameAngle_rad = 2 * kDegree_rad;  // … and around the tube
constexpr double kMinSoleProbability = 0.9;         // confidence below which an alternative is named

// The mode type of the second most energetic order.
identify::ModeType second_type(const identify::TubeShape& tube) {
  int second = -1;
  for (int n = 0; n < static_cast<int>(tube.energy.size()); ++n) {
    if (n == tube.order) continue;
    if (second < 0 || tube.energy[static_cast<std::size_t>(n)] > tube.energy[static_cast<std::size_t>(second)])
      second = n;
  }
  return second == 1   ? identify::ModeType::bending
         : second == 2 ? identify::ModeType::hoop
                       : identify::ModeType::unknown;
}

void classify_by_tube(identify::ModeClassification& classification, const identify::TubeShape& tube) {
  const identify::ModeType type = mode_type_of(tube);
  const bool sure = tube.confidence >= kMinSoleProbability;
  if (type == identify::ModeType::unknown && !sure && classification.type != identify::ModeType::unknown)
    return;  // the two sensors decided it
  classification.type = type;
  classification.confidence = tube.confidence;
  classification.alternative.reset();
  classification.possible_three_waves = false;
  classification.order_uncertain = false;
  if (!sure) classification.alternative = second_type(tube);
}

bool same_pattern(const std::optional<identify::TubeShape>& a, const std::optional<identify::TubeShape>& b) {
  if (!a || !b) return true;
  return a->order == b->order && (!a->sign_changes || !b->sign_changes || a->sign_changes == b->sign_changes);
}

std::optional<identify::PatternPlane> plane_of(const std::optional<identify::TubeShape>& tube) {
  if (!tube || !tube->plane_rad) return std::nullopt;
  return identify::PatternPlane{*tube->plane_rad, tube->plane_std_rad, tube->order};
}

constexpr double kSameLine = 0.99;  // cosine of 8°

double cosine_between(const acquire::Direction& a, const acquire::Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Whether the directions are parallel or opposite, within 8°.
bool on_one_line(const acquire::Direction& a, const acquire::Direction& b) {
  return std::abs(cosine_between(a, b)) > kSameLine;
}

}  // namespace

Survey::Survey(const Analysis& analysis, SurveyOptions options)
    : analysis_(analysis),
      options_(std::move(options)),
      roving_(options_.roving.value_or(analysis.record().sensor_roves ? identify::Roving::sensor
                                                                      : identify::Roving::hammer)),
      geometry_(options_.geometry ? options_.geometry : acquire::geometry_of_record(analysis.record().geometry)) {
  place_points();
  find_motions();
  find_driving_points();
  find_driving_signs();
}

int Survey::place_of(std::size_t point) const {
  return acquire::place_of_point(analysis_.record().motions, static_cast<int>(point));
}

std::set<int> Survey::places() const {
  std::set<int> out;
  for (const int point : analysis_.points()) out.insert(place_of(static_cast<std::size_t>(point)));
  return out;
}

bool Survey::is_tube() const {
  return geometry_ && geometry_->tube && analysis_.options().classes.object != identify::ObjectKind::other;
}

void Survey::place_points() {
  if (!geometry_) return;
  const std::set<int> measured = places();
  const acquire::Record& record = analysis_.record();
  // A geometry numbers places. In a record with directions, several files may belong to one place.
  const std::vector<std::string> files =
      record.motions.empty() ? files_of_points(record, analysis_.points()) : std::vector<std::string>{};
  if (options_.geometry) {
    matched_ = match_point_numbers(*geometry_, measured, files);
    geometry_warnings_ = matched_.warnings;
  }
  for (const acquire::GeometryPoint& p : geometry_->points) {
    if (is_tube()) tube_places_[static_cast<std::size_t>(p.point)] = {p.position_m, p.angle_rad};
  }
  const auto add = [&](std::vector<Warning> more) {
    geometry_warnings_.insert(geometry_warnings_.end(), more.begin(), more.end());
  };
  add(narrow_arc(*geometry_));
  if (!options_.geometry) return;
  require_points(*geometry_, measured, options_.geometry_source.empty() ? record.source() : options_.geometry_source,
                 matched_, files);
  add(missing_points(*geometry_, measured, matched_, record.files.size()));
}

void Survey::find_motions() {
  const acquire::Record& record = analysis_.record();
  const bool sensors = roving_ == identify::Roving::sensor;
  if (record.sensor_roves == sensors) motions_ = record.motions;
  const auto is_stated = [](const acquire::GeometryPoint& p) { return p.along.has_value(); };
  if (!geometry_ || std::none_of(geometry_->points.begin(), geometry_->points.end(), is_stated)) return;
  const auto axis = sensors && !record.accel.empty() ? record.accel.front().axis : record.force.axis;
  const auto refuse = [&](int point, const std::string& problem, const char* remedy) {
    throw InputError(fmt::format("the geometry states one direction of point {}, {}", stated_number(point), problem),
                     options_.geometry_source.empty() ? record.source() : options_.geometry_source, remedy,
                     {"geometry"});
  };
  std::map<int, acquire::PointMotion> given;
  std::map<int, int> directions;  // points at each place
  for (const int point : analysis_.points()) ++directions[place_of(static_cast<std::size_t>(point))];
  for (const int point : analysis_.points()) {
    const acquire::GeometryPoint* const at = geometry_point(static_cast<std::size_t>(point));
    if (at == nullptr || !at->along) continue;
    if (sensors && record.accel.size() > 1) {
      refuse(at->point, fmt::format("where {} sensors measured", record.accel.size()),
             "remove the column, and state the directions of the channels in a set-up");
    }
    if (directions[at->point] > 1)
      refuse(at->point, "which was struck in several", "remove the column: the record states the directions");
    // The record's direction counts, since the reader changed the signs of values along negative ones.
    const acquire::PointMotion* const stated = acquire::find_motion(motions_, point, 0);
    const auto own = stated != nullptr && stated->along ? stated->along : axis;
    if (own && !on_one_line(*own, *at->along))
      refuse(at->point, "the record or its set-up another one", "remove the column, or the direction in the set-up");
    given[point] = {.point = point, .channel = 0, .place = at->point, .along = own ? own : at->along};
  }
  geometry_has_directions_ = !given.empty();
  std::erase_if(motions_, [&](const auto& motion) { return given.contains(motion.point) && motion.channel == 0; });
  for (const auto& [point, motion] : given) motions_.push_back(motion);
  acquire::sort_motions(motions_);
}

const acquire::GeometryPoint* Survey::geometry_point(std::size_t point) const {
  return geometry_ ? acquire::find_point(*geometry_, place_of(point)) : nullptr;
}

int Survey::stated_number(int point) const {
  const auto stated = matched_.stated.find(point);
  return stated != matched_.stated.end() ? stated->second : point;
}

void Survey::find_driving_points() {
  const auto& accel = analysis_.record().accel;
  const auto points = analysis_.points();
  driving_ = options_.driving;
  if (!options_.stated_driving.empty()) {
    const acquire::Record& record = analysis_.record();
    std::set<int> stated;
    for (const auto& [point, number] : matched_.stated) stated.insert(number);
    DrivingPoints found =
        driving_points_of(options_.stated_driving,
                          {.points = points,
                           .files = files_of_points(record, points),
                           .geometry_from_one = matched_.numbers == GeometryNumbers::from_one && record.motions.empty(),
                           .geometry = std::move(stated)},
                          record.source());
    driving_.insert(driving_.end(), found.points.begin(), found.points.end());
    geometry_warnings_.insert(geometry_warnings_.end(), found.warnings.begin(), found.warnings.end());
  }
  for (const identify::DrivingPoint& at : driving_) {
    if (points.contains(static_cast<int>(at.point)) && at.channel < accel.size()) continue;
    const PointNames& names = analysis_.point_names();
    throw InputError(
        fmt::format("point {} with channel {} was not measured", names.name(static_cast<int>(at.point)), at.channel),
        analysis_.record().source(),
        fmt::format("choose POINT:CHANNEL from points {} to {} and channels 0 to {}", names.name(*points.begin()),
                    names.name(*points.rbegin()), accel.size() - 1),
        {"driving_point"});
  }
  if (driving_.empty()) {
    for (const acquire::DrivingPlace& at : analysis_.record().driving) {
      if (points.contains(at.point) && at.channel < accel.size())
        driving_.push_back({.point = static_cast<std::size_t>(at.point), .channel = at.channel});
    }
  }
  if (!driving_.empty() || roving_ != identify::Roving::hammer) return;
  for (const auto& [point, place] : tube_places_) {
    for (std::size_t c = 0; c < accel.size(); ++c) {
      if (!accel[c].position_m || !accel[c].angle_rad || !points.contains(static_cast<int>(point))) continue;
      const double around = std::remainder(*accel[c].angle_rad - place.angle_rad, 2 * std::numbers::pi);
      if (std::abs(*accel[c].position_m - place.position_m) <= kSamePlace_m && std::abs(around) <= kSameAngle_rad)
        driving_.push_back({.point = point, .channel = c});
    }
  }
}

// A geometry may state blows along −z beside a sensor along +z. The values keep their signs, so the residue is
// negative.
void Survey::find_driving_signs() {
  const acquire::Record& record = analysis_.record();
  const bool sensors = roving_ == identify::Roving::sensor;
  for (identify::DrivingPoint& at : driving_) {
    const auto* moving = acquire::find_motion(motions_, static_cast<int>(at.point), sensors ? at.channel : 0);
    const auto& fixed = sensors ? record.force.axis : record.accel[at.channel].axis;
    if (moving == nullptr || !moving->along || !fixed) continue;
    if (cosine_between(*moving->along, *fixed) < -kSameLine) at.sign = -1;
  }
}

const SurveyModes& Survey::split_modes() const {
  return within_budget(analysis_.budget(), split_modes_, [&] { return survey_modes(analysis_, roving_, driving_); });
}

const std::vector<identify::ModeShape>& Survey::shapes() const {
  return within_budget(analysis_.budget(), shapes_, [&] {
    const auto& listed = modes();
    return analysis_.trace().run("shapes", [&] {
      std::vector<identify::ModeShape> shapes;
      shapes.reserve(listed.size());
      for (const identify::Mode& mode : listed)
        shapes.push_back(identify::shape_of(mode, {.roving = roving_, .driving = driving_}));
      return shapes;
    });
  });
}

const std::vector<std::optional<identify::TubeShape>>& Survey::tubes() const {
  return within_budget(analysis_.budget(), tubes_, [&] {
    std::vector<std::optional<identify::TubeShape>> tubes;
    for (const identify::ModeShape& shape : shapes()) tubes.push_back(shape_on_tube(shape));
    return tubes;
  });
}

const std::vector<identify::ModeClassification>& Survey::classifications() const {
  return within_budget(analysis_.budget(), classifications_, [&] { return classify_by_shapes(); });
}

// Uses the radial part of the shape if the directions of the roving hammer or sensor are stated. Otherwise takes the
// whole shape as radial.
std::optional<identify::TubeShape> Survey::shape_on_tube(const identify::ModeShape& shape) const {
  if (motions_.empty() || tube_places_.empty()) return identify::tube_shape(shape, tube_places_);
  return identify::tube_shape(radial_shape(shape, motions_, *geometry_), tube_places_);
}

// The orders below the band. The modes there are classified by their shapes, where they have one on the tube.
identify::LowerOrders Survey::lower_orders(const std::vector<identify::ModeClassification>& found) const {
  const std::vector<identify::Mode>& below = analysis_.modes_below();
  std::vector<identify::ModeClassification> types(below.size());
  for (std::size_t m = 0; m < below.size(); ++m) {
    const identify::ModeShape shape = identify::shape_of(below[m], {.roving = roving_, .driving = driving_});
    if (const auto tube = shape_on_tube(shape)) classify_by_tube(types[m], *tube);
  }
  return identify::lower_orders(below, types, modes(), found, analysis_.options().classes);
}

std::vector<identify::ModeClassification> Survey::classify_by_shapes() const {
  std::vector<identify::ModeClassification> classifications = classify_by_sensors(analysis_, split_modes());
  const bool any = std::any_of(tubes().begin(), tubes().end(), [](const auto& tube) { return tube.has_value(); });
  if (!any) return classifications;
  const auto& listed = modes();
  for (std::size_t m = 0; m < listed.size(); ++m) {
    if (tubes()[m]) classify_by_tube(classifications[m], *tubes()[m]);
  }
  identify::assign_orders(listed, classifications, analysis_.options().classes, lower_orders(classifications));
  for (std::size_t m = 0; m < listed.size(); ++m) {
    auto& peak = classifications[m].split_mode;
    if (!peak || !peak->first) continue;
    auto& other = classifications[peak->partner].split_mode;
    const std::size_t partner = peak->partner;
    if (same_pattern(tubes()[m], tubes()[partner])) {
      identify::describe_split(listed[m], listed[partner], plane_of(tubes()[m]), plane_of(tubes()[partner]), *peak,
                               *other);
    } else {
      peak.reset();
      other.reset();
    }
  }
  if (!analysis_.modes_are_complete()) {
    for (identify::ModeClassification& one : classifications) one.order = 0;  // other modes may lie between
  }
  return classifications;
}

const std::vector<std::vector<identify::Mac>>& Survey::macs() const {
  return within_budget(analysis_.budget(), macs_, [&] {
    const std::vector<identify::ModeShape>& found = shapes();
    const SurveyModes& listed = split_modes();
    return analysis_.trace().run(
        "auto MAC", [&] { return identify::auto_mac(found, shapes_in_hits(analysis_, listed, found, roving_)); });
  });
}

acquire::LineRange Survey::band() const { return analysis_.band_lines(); }

const std::vector<identify::SynthesisedFrf>& Survey::synthesis() const { return analysis_.synthesis(); }

const Eigen::MatrixXd& Survey::indicator() const {
  return within_budget(analysis_.budget(), indicator_, [&] {
    const identify::FrfDataset& set = analysis_.fitted_frfs();
    return analysis_.trace().run("mode indicator", [&] { return identify::cmif(set, band()); });
  });
}

std::vector<identify::DrivingPointCheck> Survey::driving_checks() const {
  return identify::check_driving_points(modes(), driving_);
}

std::vector<identify::ReciprocityCheck> Survey::reciprocity() const {
  std::vector<std::pair<identify::FrfIndex, identify::FrfIndex>> pairs;
  for (std::size_t i = 0; i < driving_.size(); ++i) {
    for (std::size_t j = i + 1; j < driving_.size(); ++j) {
      if (driving_[i].channel == driving_[j].channel) continue;
      pairs.push_back({{driving_[i].point, driving_[j].channel, driving_[j].sign},
                       {driving_[j].point, driving_[i].channel, driving_[i].sign}});
    }
  }
  return identify::check_reciprocity(modes(), pairs);
}

std::vector<Warning> Survey::warnings() const {
  std::vector<Warning> out = analysis_.warnings();
  if (!analysis_.possible()) return out;
  // The survey's own warnings replace these two. Its double_peak adds the planes of the shapes, and its three_waves
  // uses shapes around the barrel, which distinguish three waves from bending.
  std::erase_if(out,
                [](const Warning& warning) { return warning.code == "double_peak" || warning.code == "three_waves"; });
  const SurveyResults results{.accel = analysis_.record().accel,
                              .has_samples = analysis_.given_frfs() == nullptr,
                              .modes = modes(),
                              .has_geometry = geometry_.has_value(),
                              .roving = roving_,
                              .shapes = shapes(),
                              .tubes = tubes(),
                              .classifications = classifications(),
                              .driving_checks = driving_checks(),
                              .reciprocity = reciprocity(),
                              .synthesis = synthesis(),
                              .frf_points = analysis_.frf_points(),
                              .names = analysis_.point_names(),
                              .repeated = unresolved_modes(split_modes())};
  remove_consequences_of_pairs(analysis_, split_modes(), out);
  for (Warning& warning : repeated_mode_warnings(split_modes(), !driving_.empty())) out.push_back(std::move(warning));
  out.insert(out.end(), geometry_warnings_.begin(), geometry_warnings_.end());
  for (Warning& warning : survey_warnings(results)) out.push_back(std::move(warning));
  for (Warning& warning : three_wave_warnings(results.modes, results.classifications))
    out.push_back(std::move(warning));
  if (roving_ == identify::Roving::hammer) {
    for (Warning& warning : reference_warnings(results.accel, analysis_.modes(), results.names))
      out.push_back(std::move(warning));
  }
  if (has_reversed_phase(analysis_.record())) remove_consequences_of_reversed_phase(out);
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
