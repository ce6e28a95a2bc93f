#include "report/json/survey_json.hpp"

#include <nlohmann/json.hpp>

#include "core/parallel/parallel.hpp"
#include "core/units.hpp"
#include "report/json/or_null.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json places_json(const std::vector<identify::ShapePlace>& places, bool point, bool channel) {
  Json out = Json::array();
  for (const identify::ShapePlace& place : places) {
    Json json = Json::object();
    if (point) json["point"] = place.point;
    if (channel) json["channel"] = place.channel;
    json["re"] = place.value.real();
    json["im"] = place.value.imag();
    json["std"] = place.std;
    out.push_back(std::move(json));
  }
  return out;
}

void add_tube(Json& json, const std::optional<identify::TubeShape>& tube) {
  json["circumferential_order"] = tube ? Json(tube->order) : Json();
  json["order_confidence"] = tube ? Json(tube->confidence) : Json();
  json["alias_order"] = tube ? Json(tube->alias) : Json();
  json["energy_fraction"] = tube ? Json(tube->energy[static_cast<std::size_t>(tube->order)]) : Json();
  json["energy_by_order"] = tube ? Json(tube->energy) : Json();
  json["axial_order"] = tube ? or_null(tube->sign_changes) : Json();
  json["plane_deg"] = tube && tube->plane_rad ? Json(*tube->plane_rad * kRadian_deg) : Json();
  json["plane_std_deg"] = tube && tube->plane_rad ? Json(tube->plane_std_rad * kRadian_deg) : Json();
  if (!tube) return;
  json["axial"] = Json::array();
  for (const identify::AxialValue& v : tube->axial)
    json["axial"].push_back({{"position_m", v.position_m}, {"value", v.value}, {"std", v.std}});
}

Json shape_json(const identify::ModeShape& shape, const std::optional<identify::TubeShape>& tube,
                identify::Roving roving) {
  Json json{{"normalisation", name_of(shape.normalisation)},
            {"scale_std", shape.scale_std},
            {"modal_mass_kg", or_null(shape.modal_mass_kg)},
            {"modal_mass_std_kg", shape.modal_mass_kg ? Json(shape.modal_mass_std_kg) : Json()},
            {"mpc", shape.mpc},
            {"significance", shape.significance}};
  add_tube(json, tube);
  json["values"] = places_json(shape.places, true, roving == identify::Roving::sensor);
  if (roving == identify::Roving::hammer) json["sensors"] = places_json(shape.sensors, false, true);
  return json;
}

Json geometry_json(const pipeline::Survey& survey) {
  if (!survey.geometry()) return {};
  return {{"from", survey.options().geometry ? "file" : "record"},
          {"points", survey.geometry()->points.size()},
          {"tube", survey.geometry()->tube}};
}

// The stated places and directions of the points: the survey's if the geometry states directions, else the record's.
const std::vector<acquire::PointMotion>& stated_motions(const pipeline::Survey& survey) {
  return survey.geometry_has_directions() ? survey.motions() : survey.analysis().record().motions;
}

// Whether these are motions of roving sensors.
bool are_of_sensors(const pipeline::Survey& survey) {
  return survey.geometry_has_directions() ? survey.roving() == identify::Roving::sensor
                                          : survey.analysis().record().sensor_roves;
}

// The direction of a positive value of a point; null where it is not stated.
Json direction_json(const std::vector<acquire::PointMotion>& motions, int point) {
  for (const acquire::PointMotion& motion : motions) {
    if (motion.point == point && motion.along) return *motion.along;
  }
  return {};
}

// The numbers that people see, the coordinates and the directions of the points; empty without a geometry if these
// numbers are the record's.
Json places_json(const pipeline::Survey& survey) {
  // Several roving sensors at one point have directions of their own.
  const bool one_direction = survey.geometry_has_directions() || !are_of_sensors(survey);
  Json out = Json::array();
  bool known = survey.geometry().has_value();
  for (const int point : survey.analysis().points()) {
    const int named = survey.analysis().point_names().number(point);
    const int number = named == point && survey.place_of(static_cast<std::size_t>(point)) == point
                           ? survey.stated_number(point)
                           : named;
    known = known || number != point;
    Json json{{"point", point}, {"number", number}};
    const acquire::GeometryPoint* place = survey.geometry_point(static_cast<std::size_t>(point));
    if (place != nullptr && place->xyz_m) {
      json["x_m"] = place->xyz_m->at(0);
      json["y_m"] = place->xyz_m->at(1);
      json["z_m"] = place->xyz_m->at(2);
    } else if (place != nullptr) {
      json["position_m"] = place->position_m;
      json["angle_deg"] = place->angle_rad * kRadian_deg;
    }
    const Json direction = one_direction ? direction_json(stated_motions(survey), point) : Json();
    if (!direction.is_null()) json["direction"] = direction;
    out.push_back(std::move(json));
  }
  return known ? out : Json::array();
}

// The stated places and directions of the points.
Json motions_json(const pipeline::Survey& survey) {
  Json out = Json::array();
  for (const acquire::PointMotion& motion : stated_motions(survey)) {
    Json json{{"point", motion.point}};
    if (are_of_sensors(survey)) json["channel"] = motion.channel;
    json["place"] = motion.place;
    json["direction"] = motion.along ? Json(*motion.along) : Json();
    out.push_back(std::move(json));
  }
  return out;
}

Json mac_json(const pipeline::Survey& survey) {
  Json value = Json::array(), std = Json::array();
  for (const auto& row : survey.macs()) {
    Json values = Json::array(), stds = Json::array();
    for (const identify::Mac& mac : row) {
      values.push_back(mac.value);
      stds.push_back(mac.std);
    }
    value.push_back(std::move(values));
    std.push_back(std::move(stds));
  }
  return {{"value", std::move(value)}, {"std", std::move(std)}};
}

Json frac_json(const pipeline::Survey& survey) {
  Json out = Json::array();
  const auto points = survey.analysis().frf_points();
  for (const identify::SynthesisedFrf& frf : survey.synthesis()) {
    out.push_back({{"point", points[frf.point]},
                   {"channel", frf.channel},
                   {"frac", frf.frac},
                   {"noise_share", frf.noise_share},
                   {"level_db", frf.level_dB},
                   {"poor", pipeline::poorly_explained(frf)}});
  }
  return out;
}

Json driving_json(const pipeline::Survey& survey) {
  Json out = Json::array();
  for (const identify::DrivingPointCheck& check : survey.driving_checks()) {
    out.push_back({{"mode", check.mode},
                   {"point", check.at.point},
                   {"channel", check.at.channel},
                   {"re", check.residue.real()},
                   {"im", check.residue.imag()},
                   {"std", check.std},
                   {"wrong_sign", check.wrong_sign}});
  }
  return out;
}

Json pair_json(const identify::FrfIndex& at) { return {{"point", at.point}, {"channel", at.channel}}; }

Json reciprocity_json(const pipeline::Survey& survey) {
  Json out = Json::array();
  for (const identify::ReciprocityCheck& check : survey.reciprocity()) {
    out.push_back({{"mode", check.mode},
                   {"one", pair_json(check.one)},
                   {"other", pair_json(check.other)},
                   {"difference", check.difference},
                   {"deviations", check.deviations}});
  }
  return out;
}

}  // namespace

std::string survey_json(const pipeline::Survey& survey, JsonOptions options) {
  const ThreadLimit limit(survey.analysis().options().threads);
  const bool possible = survey.analysis().possible();
  const std::vector<identify::ModeClassification> classifications =
      possible ? survey.classifications() : std::vector<identify::ModeClassification>{};
  options.classifications = &classifications;
  const std::vector<pipeline::Warning> warnings = survey.warnings();
  options.warnings = &warnings;
  if (possible) {
    options.modes = &survey.split_modes();
    options.shape = [&, &shapes = survey.shapes(), &tubes = survey.tubes()](std::size_t m) {
      return indented_text(shape_json(shapes[m], tubes[m], survey.roving()));
    };
  }
  JsonDocument document = analysis_document(survey.analysis(), options);
  document.add_written("roving", Json(survey.roving() == identify::Roving::hammer ? "hammer" : "sensor"));
  document.add_written("geometry", geometry_json(survey));
  if (const Json places = places_json(survey); !places.empty()) document.add_written("places", places);
  if (!stated_motions(survey).empty()) document.add_written("motion", motions_json(survey));
  if (possible) {
    document.add_written("auto_mac", mac_json(survey));
    survey.synthesis();
    document.add("frac", [&] { return indented_text(frac_json(survey)); });
    document.add_written("driving_point", driving_json(survey));
    document.add_written("reciprocity", reciprocity_json(survey));
  }
  return document.text() + "\n";
}

}  // namespace percuss::report
