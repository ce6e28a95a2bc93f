#include "acquire/formats/sound/sound_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"

namespace percuss::acquire {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxScale = 1e15;

const char* name_of_quantity(Quantity quantity) {
  if (quantity == Quantity::force) return "force";
  return quantity == Quantity::pressure ? "pressure" : "acceleration";
}

void read_calibrated(StrictObject& o, SoundCalibration::Signal& signal) {
  std::string measures = "acceleration";
  o.read("name", signal.name);
  o.read("measures", measures);
  if (measures == "force") {
    signal.measures = Quantity::force;
  } else if (measures == "pressure") {
    signal.measures = Quantity::pressure;
  } else if (measures != "acceleration") {
    o.fail(R"(neither "force", "acceleration" nor "pressure")", "measures", "write one of them");
  }
  o.need("si_at_full_scale");
  o.read_within("si_at_full_scale", -kMaxScale, kMaxScale, signal.to_SI);
  o.read("angle_rad", signal.angle_rad);
  o.read("position_m", signal.position_m);
}

void read_whole(StrictObject& o, const char* key, double low, double high, int& to) {
  double value = to;
  o.read_within(key, low, high, value);
  if (value != std::round(value)) o.fail("not a whole number", key, "write a whole number");
  to = static_cast<int>(value);
}

void read_geometry(StrictObject& o, SoundCalibration& out) {
  std::vector<double> values, numbers, lines;
  std::size_t coordinates = 3;
  o.read("geometry_m", values);
  o.read("coordinates", coordinates);
  o.read("geometry_points", numbers);
  o.read("trace_lines", lines);
  if (coordinates < 2 || coordinates > 3 || values.size() % coordinates != 0)
    o.fail("not 2 or 3 coordinates for every point", "geometry_m", "write them point by point");
  const std::size_t points = values.size() / coordinates;
  if (!o.has("geometry_points")) {
    for (std::size_t i = 0; i < points; ++i) numbers.push_back(static_cast<double>(i));
  }
  if (numbers.size() != points) o.fail("not one number for every point", "geometry_points", "write one each");
  std::size_t all_points = points;
  o.read("points", all_points);
  if (all_points > max_points(points)) o.fail("points numbered too far apart", "points", "number them from 0");
  const std::vector<double> none(coordinates, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < points; ++i) {
    const double number = numbers[i];
    if (!(number >= static_cast<double>(out.geometry.size()) && number < static_cast<double>(all_points)) ||
        number != std::floor(number))
      o.fail("point numbers that do not rise, or are not below \"points\"", "geometry_points", "number points from 0");
    out.geometry.resize(static_cast<std::size_t>(number), none);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(i * coordinates);
    out.geometry.emplace_back(at, at + static_cast<std::ptrdiff_t>(coordinates));
  }
  out.geometry.resize(all_points, none);
  out.trace_lines = trace_lines_of(lines, out.geometry.size(), o.place() + ", trace_lines");
}

bool is_known(const std::vector<double>& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

bool calibration_holds_geometry(const std::vector<std::vector<double>>& geometry) {
  return geometry.size() <=
         max_points(static_cast<std::size_t>(std::count_if(geometry.begin(), geometry.end(), is_known)));
}

namespace {

void add_geometry(const SoundCalibration& calibration, Json& out) {
  const auto& geometry = calibration.geometry;
  if (geometry.empty() || !calibration_holds_geometry(geometry)) return;
  Json values = Json::array(), numbers = Json::array(), lines = Json::array();
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    if (!is_known(geometry[i])) continue;
    numbers.push_back(i);
    for (const double coordinate : geometry[i]) values.push_back(coordinate);
  }
  for (const auto& [from, to] : calibration.trace_lines) {
    lines.push_back(from);
    lines.push_back(to);
  }
  out["coordinates"] = geometry.front().size();
  out["geometry_m"] = std::move(values);
  if (numbers.size() != geometry.size()) {
    out["points"] = geometry.size();
    out["geometry_points"] = std::move(numbers);
  }
  if (!lines.empty()) out["trace_lines"] = std::move(lines);
}

}  // namespace

std::string calibration_text(const SoundCalibration& calibration) {
  Json signals = Json::array(), rows = Json::array();
  for (const SoundCalibration::Signal& signal : calibration.signals) {
    Json one{
        {"name", signal.name}, {"measures", name_of_quantity(signal.measures)}, {"si_at_full_scale", signal.to_SI}};
    if (signal.angle_rad) one["angle_rad"] = *signal.angle_rad;
    if (signal.position_m) one["position_m"] = *signal.position_m;
    signals.push_back(std::move(one));
  }
  for (const RowInfo& row : calibration.rows)
    rows.push_back({{"samples", row.samples}, {"point", row.point}, {"run", row.run}});
  Json out{{"fs_hz", calibration.fs_Hz},
           {"continuous", calibration.continuous},
           {"signals", std::move(signals)},
           {"rows", std::move(rows)}};
  add_geometry(calibration, out);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SoundCalibration parse_calibration(std::string_view text, const std::string& where) {
  SoundCalibration out;
  const JsonText strict{.text = text, .where = where, .remedy = "convert the record again"};
  read_strict_json(strict, [&](StrictObject& o) {
    o.read("fs_hz", out.fs_Hz);
    o.read("continuous", out.continuous);
    o.need("signals");
    o.read_list("signals", [&](StrictObject& item) { read_calibrated(item, out.signals.emplace_back()); });
    o.read_list("rows", [&](StrictObject& item) {
      RowInfo& row = out.rows.emplace_back();
      item.need("samples");
      item.read("samples", row.samples);
      read_whole(item, "point", 0, static_cast<double>(kMaxPointNumber), row.point);
      read_whole(item, "run", std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), row.run);
    });
    read_geometry(o, out);
  });
  return out;
}

}  // namespace percuss::acquire
