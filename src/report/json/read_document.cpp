#include "report/json/read_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/json_text.hpp"
#include "core/units.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::report {
namespace {

constexpr std::uint64_t kLargest_bytes = std::uint64_t{256} << 20U;
constexpr int kMaxDepth = 16;

// All keys that are read below.
constexpr std::array<std::string_view, 37> kWantedKeys = {"schema",
                                                          "runs",
                                                          "deflection",
                                                          "points",
                                                          "point",
                                                          "peak_m",
                                                          "peak_std_m",
                                                          "position_m",
                                                          "modes",
                                                          "frequency_hz",
                                                          "frequency_std_hz",
                                                          "damping_ratio",
                                                          "damping_ratio_std",
                                                          "family",
                                                          "double_peak",
                                                          "first",
                                                          "residues",
                                                          "channel",
                                                          "re",
                                                          "im",
                                                          "std",
                                                          "sweep",
                                                          "at",
                                                          "peak_deflection_m",
                                                          "roving",
                                                          "flugge_hz",
                                                          "order",
                                                          "confidence",
                                                          "support",
                                                          "kind",
                                                          "places",
                                                          "number",
                                                          "x_m",
                                                          "y_m",
                                                          "z_m",
                                                          "angle_deg",
                                                          "direction"};

// A value of a document, and its location for messages.
class Part {
 public:
  Part(const nlohmann::json& value, std::string where) : value_(value), where_(std::move(where)) {}

  bool has(const char* key) const { return value_.is_object() && value_.contains(key) && !value_[key].is_null(); }
  Part at(const char* key) const {
    if (!has(key)) throw InputError(fmt::format("no \"{}\"", key), where_, "read a document that percuss wrote");
    return {value_[key], where_ + ", " + key};
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    if (!value_.is_array()) throw InputError("not a list", where_, "read a document that percuss wrote");
    std::size_t i = 0;
    for (const nlohmann::json& item : value_) visit(Part(item, fmt::format("{}[{}]", where_, i++)));
  }
  double number() const {
    const double number = value_.is_number() ? value_.get<double>() : std::nan("");
    if (!std::isfinite(number)) throw InputError("not a number", where_, "read a document that percuss wrote");
    return number;
  }
  bool is_false(const char* key) const { return has(key) && value_[key] == false; }
  double number_or(const char* key, double otherwise) const { return has(key) ? at(key).number() : otherwise; }
  std::string text() const {
    if (!value_.is_string()) throw InputError("not a text", where_, "read a document that percuss wrote");
    return value_.get<std::string>();
  }

 private:
  const nlohmann::json& value_;
  std::string where_;
};

constexpr int kEverySensor = -1;  // in the place of a channel
constexpr std::size_t kMaxCellsPerResidue = 4;

int whole(double number) { return static_cast<int>(std::clamp(number, -1e9, 1e9)); }
std::size_t index(double number) { return static_cast<std::size_t>(std::clamp(number, 0.0, 1e9)); }

// Whether the residues fill a fair part of a table of points and channels. If they do not, the table may exceed the
// memory: a document that percuss did not write may state any numbers of points and channels.
bool fill_a_table(const std::vector<identify::Residue>& residues) {
  std::set<std::size_t> points, channels;
  for (const identify::Residue& residue : residues) {
    points.insert(residue.point);
    channels.insert(residue.channel);
  }
  return points.size() >= metrics::kMinPlaces &&
         points.size() * channels.size() <= kMaxCellsPerResidue * residues.size();
}

// Whether there are enough points for a comparison, with one residue each.
bool has_one_per_point(const std::vector<identify::Residue>& residues) {
  std::set<std::size_t> points;
  for (const identify::Residue& residue : residues) points.insert(residue.point);
  return points.size() >= metrics::kMinPlaces && points.size() == residues.size();
}

// The shape at its places (point, channel). If there are enough points, each point is a place, with kEverySensor as its
// channel: every sensor shows the same shape, times a factor of its own. Otherwise, and with a roving sensor of several
// directions, each channel of a point is a place.
std::map<std::pair<int, int>, metrics::ComparedMode::Component> shape_of(const identify::Mode& mode,
                                                                         identify::Roving roving) {
  std::map<std::pair<int, int>, metrics::ComparedMode::Component> out;
  if (roving == identify::Roving::hammer && fill_a_table(mode.residues)) {
    const identify::ModeShape shape = identify::shape_of(mode);
    for (const identify::ShapePlace& place : shape.places)
      out[{static_cast<int>(place.point), kEverySensor}] = {.value = place.value, .std = place.std};
    return out;
  }
  const bool over_points = has_one_per_point(mode.residues);
  for (const identify::Residue& residue : mode.residues) {
    const int channel = over_points ? kEverySensor : static_cast<int>(residue.channel);
    out[{static_cast<int>(residue.point), channel}] = {.value = residue.value, .std = residue.std};
  }
  return out;
}

metrics::ComparedMode mode_in(const Part& part, identify::Roving roving) {
  metrics::ComparedMode mode{.freq_Hz = part.at("frequency_hz").number(),
                             .freq_std_Hz = part.number_or("frequency_std_hz", 0),
                             .damping_std = part.number_or("damping_ratio_std", 0),
                             .family = part.has("family") ? part.at("family").text() : "",
                             .shape = {}};
  if (part.has("damping_ratio")) mode.damping_ratio = part.at("damping_ratio").number();
  mode.second = part.has("double_peak") && part.at("double_peak").is_false("first");
  mode.order = whole(part.number_or("order", 0));
  mode.confidence = part.number_or("confidence", 0);
  if (!part.has("residues")) return mode;
  identify::Mode with_residues;
  part.at("residues").for_each([&](const Part& residue) {
    with_residues.residues.push_back({.point = index(residue.at("point").number()),
                                      .channel = index(residue.at("channel").number()),
                                      .value = {residue.at("re").number(), residue.number_or("im", 0)},
                                      .std = residue.number_or("std", 0)});
  });
  mode.shape = shape_of(with_residues, roving);
  return mode;
}

std::vector<metrics::ComparedMode> frequencies_in(const Part& list, const char* family) {
  std::vector<metrics::ComparedMode> modes;
  list.for_each(
      [&](const Part& value) { modes.push_back({.freq_Hz = value.number(), .family = family, .shape = {}}); });
  return modes;
}

// The modes of a bat. Only a free bat gets orders, because they then equal the orders in a test of a free bat.
std::vector<metrics::ComparedMode> bat_modes_in(const Part& part) {
  std::vector<metrics::ComparedMode> modes = frequencies_in(part.at("frequency_hz"), "bending");
  if (!part.has("support") || part.at("support").at("kind").text() != "free") return modes;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].order = static_cast<int>(m) + 1;
    modes[m].confidence = 1;
  }
  return modes;
}

// The coordinates of a place; nothing if none are stated. A position and an angle on a tube are converted with an
// assumed radius.
std::optional<std::array<double, 3>> coordinates_in(const Part& place) {
  constexpr double kRadius_m = 0.03;
  if (place.has("x_m") || place.has("y_m") || place.has("z_m"))
    return std::array{place.number_or("x_m", 0), place.number_or("y_m", 0), place.number_or("z_m", 0)};
  if (!place.has("position_m")) return std::nullopt;
  const double angle_rad = place.number_or("angle_deg", 0) / kRadian_deg;
  return std::array{place.at("position_m").number(), kRadius_m * std::cos(angle_rad), kRadius_m * std::sin(angle_rad)};
}

std::optional<std::array<double, 3>> direction_in(const Part& place) {
  if (!place.has("direction")) return std::nullopt;
  std::array<double, 3> direction{};
  std::size_t axis = 0;
  place.at("direction").for_each([&](const Part& value) {
    if (axis < direction.size()) direction.at(axis++) = value.number();
  });
  return direction;
}

void add_places(const Part& part, metrics::ComparedDocument& document) {
  part.at("places").for_each([&](const Part& place) {
    const int point = whole(place.at("point").number());
    document.places[point] = {.number = whole(place.number_or("number", point)),
                              .xyz_m = coordinates_in(place),
                              .direction = direction_in(place)};
  });
}

void add_deflections(const Part& part, metrics::ComparedDocument& document) {
  part.at("points").for_each([&](const Part& point) {
    if (!point.has("peak_m")) return;  // no deflection above the noise
    metrics::ComparedDeflection d{.point = whole(point.at("point").number()),
                                  .peak_m = point.at("peak_m").number(),
                                  .std_m = point.number_or("peak_std_m", 0)};
    if (point.has("position_m")) d.position_m = point.at("position_m").number();
    document.deflections.push_back(d);
  });
}

metrics::ComparedDocument analysis_in(const Part& part, std::string name, std::string schema) {
  metrics::ComparedDocument document{
      .name = std::move(name), .schema = std::move(schema), .modes = {}, .deflections = {}};
  if (part.has("deflection")) add_deflections(part.at("deflection"), document);
  if (!part.has("modes")) return document;
  const auto roving =
      part.has("roving") && part.at("roving").text() == "sensor" ? identify::Roving::sensor : identify::Roving::hammer;
  part.at("modes").for_each([&](const Part& mode) { document.modes.push_back(mode_in(mode, roving)); });
  if (part.has("places")) add_places(part, document);
  return document;
}

void add_impacts(const Part& part, metrics::ComparedDocument& document) {
  document.modes = frequencies_in(part.at("frequency_hz"), "bending");
  if (!part.has("sweep")) return;
  part.at("sweep").for_each([&](const Part& impact) {
    if (impact.has("at") && impact.has("peak_deflection_m")) {
      document.deflections.push_back(
          {.position_m = impact.at("at").number(), .peak_m = std::abs(impact.at("peak_deflection_m").number())});
    }
  });
}

}  // namespace

std::vector<metrics::ComparedDocument> read_documents(const std::string& path) {
  return parse_documents(read_input(path, kLargest_bytes).view(), input_name(path));
}

std::vector<metrics::ComparedDocument> parse_documents(std::string_view text, const std::string& where) {
  if (text.empty()) throw InputError("the file is empty", where, "write it again");
  const auto value = parse_json<nlohmann::json>(
      {.text = text,
       .where = where,
       .remedy = "give a JSON document that percuss wrote; percuss analyze writes one of a record",
       .max_depth = kMaxDepth},
      kWantedKeys);
  const Part top(value, where);
  const std::string schema = top.at("schema").text();
  if (schema == "percuss/analysis/1") {
    if (!top.has("runs")) return {analysis_in(top, where, schema)};
    std::vector<metrics::ComparedDocument> documents;
    top.at("runs").for_each([&](const Part& run) {
      documents.push_back(analysis_in(run, fmt::format("{} run {}", where, documents.size()), schema));
    });
    return documents;
  }
  metrics::ComparedDocument document{.name = where, .schema = schema, .model = true, .modes = {}, .deflections = {}};
  if (schema == "percuss/deflection/1") {
    document.model = false;
    add_deflections(top, document);
  } else if (schema == "percuss/model-beam/1") {
    document.modes = frequencies_in(top.at("frequency_hz"), "bending");
  } else if (schema == "percuss/model-bat/1") {
    document.modes = bat_modes_in(top);
  } else if (schema == "percuss/model-impact/1") {
    add_impacts(top, document);
  } else if (schema == "percuss/model-shell/1") {
    document.modes = frequencies_in(top.at("flugge_hz"), "hoop");
  } else {
    throw InputError(
        "a " + one_line(schema, 60) + " has neither modes nor deflections", where,
        "read a JSON document of analyze, survey, deflect, or of a model of a beam, an impact, a bat or a shell");
  }
  return {document};
}

}  // namespace percuss::report
