#include "percuss/survey.hpp"

#include <set>
#include <span>
#include <utility>

#include "acquire/geometry/geometry.hpp"
#include "api/handles.hpp"
#include "core/error.hpp"
#include "report/json/survey_json.hpp"
#include "report/text/survey_text.hpp"

namespace percuss {
namespace api {
namespace {

constexpr const char* kGeometry = "Geometry";

void require_valid(const Geometry& geometry) {
  std::set<int> listed;
  for (const GeometryPoint& p : geometry.points) listed.insert(p.point);
  const auto require_listed = [&](std::span<const int> points) {
    for (const int point : points) {
      if (listed.contains(point)) continue;
      throw InputError("point " + std::to_string(point) + " is connected, but not listed", kGeometry,
                       "list the point with its coordinates", {"geometry"});
    }
  };
  for (const std::array<int, 2>& line : geometry.lines) require_listed(line);
  for (const std::vector<int>& face : geometry.faces) {
    if (face.size() < 3)
      throw InputError("a face with fewer than three corners", kGeometry, "give three or more", {"geometry"});
    require_listed(face);
  }
  if (geometry.axis > 2) throw InputError("no such axis", kGeometry, "give 0, 1 or 2 for x, y or z", {"geometry"});
}

acquire::Geometry internal_geometry(const Geometry& geometry) {
  require_valid(geometry);
  acquire::Geometry out{.points = {},
                        .tube = geometry.tube,
                        .axis = geometry.axis,
                        .lines = geometry.lines,
                        .faces = geometry.faces,
                        .unit_assumed = geometry.unit_assumed};
  for (const GeometryPoint& p : geometry.points) {
    out.points.push_back({.point = p.point,
                          .xyz_m = p.xyz_m,
                          .position_m = p.position_m,
                          .angle_rad = p.angle_rad,
                          .radius_m = p.radius_m,
                          .along = p.along});
  }
  return out;
}

Geometry public_geometry(const acquire::Geometry& geometry) {
  Geometry out{.points = {},
               .tube = geometry.tube,
               .unit_assumed = geometry.unit_assumed,
               .axis = geometry.axis,
               .lines = geometry.lines,
               .faces = geometry.faces};
  for (const acquire::GeometryPoint& p : geometry.points) {
    out.points.push_back({.point = p.point,
                          .xyz_m = p.xyz_m,
                          .position_m = p.position_m,
                          .angle_rad = p.angle_rad,
                          .radius_m = p.radius_m,
                          .along = p.along});
  }
  return out;
}

template <class Input>
std::shared_ptr<const SurveyData> survey_data(Input input, const SurveyOptions& options) {
  pipeline::AnalysisOptions of_analysis = analysis_options(options.analysis);
  if (options.geometry) {
    for (const GeometryPoint& p : options.geometry->points) of_analysis.geometry_points.insert(p.point);
  }
  const std::shared_ptr<const AnalysisData> analysis(
      new AnalysisData{pipeline::Analysis(std::move(input), std::move(of_analysis))});
  pipeline::SurveyOptions its;
  if (options.roving)
    its.roving = *options.roving == Roving::sensor ? identify::Roving::sensor : identify::Roving::hammer;
  if (options.geometry) its.geometry = internal_geometry(*options.geometry);
  for (const DrivingPoint& at : options.driving_point)
    its.driving.push_back({.point = at.point, .channel = at.channel});
  return std::shared_ptr<const SurveyData>(new SurveyData{analysis, {analysis->analysis, std::move(its)}});
}

std::vector<ShapePlace> places_of(const std::vector<identify::ShapePlace>& places) {
  std::vector<ShapePlace> out;
  out.reserve(places.size());
  for (const identify::ShapePlace& p : places)
    out.push_back({.point = p.point, .channel = p.channel, .value = p.value, .std = p.std});
  return out;
}

TubeShape tube_of(const identify::TubeShape& shape) {
  TubeShape out{.energy = shape.energy,
                .order = shape.order,
                .confidence = shape.confidence,
                .plane_rad = shape.plane_rad,
                .plane_std_rad = shape.plane_std_rad,
                .position_m = {},
                .axial = {},
                .axial_std = {}};
  for (const identify::AxialValue& ring : shape.axial) {
    out.position_m.push_back(ring.position_m);
    out.axial.push_back(ring.value);
    out.axial_std.push_back(ring.std);
  }
  return out;
}

}  // namespace

const pipeline::Survey& computed(const Survey& survey) {
  const pipeline::Analysis& analysis = survey.data().analysis->analysis;
  analysis.hits();
  if (analysis.possible()) analysis.compute_modes_and_frfs();
  return survey.data().survey;
}

}  // namespace api

Geometry read_geometry(const std::string& path) { return api::public_geometry(acquire::read_geometry(path)); }

Survey::Survey(const Record& record, const SurveyOptions& options)
    : data_(api::survey_data(api::record_of_one_run(record), options)) {}

Survey::Survey(const FrfSet& frfs, const SurveyOptions& options)
    : data_(api::survey_data(frfs.data().record, options)) {}

Analysis Survey::analysis() const { return Analysis(data_->analysis); }

std::optional<Geometry> Survey::geometry() const {
  const auto& geometry = data_->survey.geometry();
  return geometry ? std::optional(api::public_geometry(*geometry)) : std::nullopt;
}

std::vector<Mode> Survey::modes() const { return api::modes_of(api::computed(*this).modes()); }

std::vector<ModeShape> Survey::shapes() const {
  std::vector<ModeShape> out;
  for (const identify::ModeShape& shape : data_->survey.shapes()) {
    out.push_back({.places = api::places_of(shape.places),
                   .sensors = api::places_of(shape.sensors),
                   .unit_modal_mass = shape.normalisation == identify::Normalisation::unit_modal_mass,
                   .scale_std = shape.scale_std,
                   .modal_mass_kg = shape.modal_mass_kg,
                   .modal_mass_std_kg = shape.modal_mass_std_kg,
                   .mpc = shape.mpc});
  }
  return out;
}

std::vector<std::optional<TubeShape>> Survey::tubes() const {
  std::vector<std::optional<TubeShape>> out;
  for (const auto& shape : data_->survey.tubes())
    out.push_back(shape ? std::optional(api::tube_of(*shape)) : std::nullopt);
  return out;
}

std::vector<ModeClassification> Survey::classifications() const {
  return api::classifications_of(data_->survey.classifications());
}

std::vector<std::vector<Mac>> Survey::macs() const {
  std::vector<std::vector<Mac>> out;
  for (const auto& row : data_->survey.macs()) {
    out.emplace_back();
    for (const identify::Mac& mac : row) out.back().push_back({.value = mac.value, .std = mac.std});
  }
  return out;
}

std::vector<Warning> Survey::warnings() const { return api::warnings_of(api::computed(*this).warnings()); }
std::string Survey::json() const { return report::survey_json(api::computed(*this)); }
std::string Survey::text(std::size_t width) const { return report::survey_text(api::computed(*this), false, width); }

}  // namespace percuss
