#include "metrics/protocol/session.hpp"

#include <fmt/format.h>

#include <array>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"
#include "core/units.hpp"
#include "metrics/protocol/averages.hpp"
#include "metrics/protocol/performance.hpp"

namespace percuss::metrics {
namespace {

constexpr std::uint64_t kMaxSession_bytes = std::uint64_t{16} << 20U;
constexpr std::size_t kMaxShots = 100'000;
constexpr double kMaxSpeed_mph = 400;  // no cannon is faster
constexpr const char* kSessionExample = "certify.example";

constexpr std::array<std::pair<const char*, PerformanceMetric>, 3> kMetricNames{
    {{"besr", PerformanceMetric::besr},
     {"ncaa_besr", PerformanceMetric::ncaa_besr},
     {"bbcor", PerformanceMetric::bbcor}}};

// (P12) for each pair of gates. Four gates in a row make three pairs.
std::vector<double> pair_speeds_mph(const StrictObject& o, const std::string& key, const std::vector<double>& times_s,
                                    double spacing_in) {
  if (times_s.size() != 6 && times_s.size() != 4)
    o.fail("neither four nor six times", key, "give two per pair of gates, or one per gate of four in a row");
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (!(times_s[i] > times_s[i - 1])) o.fail("the times do not rise", key, "give them in the order of the gates");
  }
  std::vector<double> speeds;
  const std::size_t step = times_s.size() == 6 ? 2 : 1;
  for (std::size_t i = 0; i + 1 < times_s.size(); i += step)
    speeds.push_back(spacing_in * kInch_m / (times_s[i + 1] - times_s[i]) / kMilePerHour_mps);
  return speeds;
}

// A speed from the times of gate pairs, from the speeds of the pairs, or as given.
void read_speed(StrictObject& o, const std::string& side, double spacing_in, double& speed_mph,
                std::vector<double>& pairs_mph) {
  const std::string times = "gates_" + side + "_s", pairs = "pairs_" + side + "_mph", whole = "v_" + side + "_mph";
  const int given = int{o.has(times)} + int{o.has(pairs)} + int{o.has(whole)};
  if (given != 1) {
    o.fail(given == 0 ? "no speed" : "more than one speed", whole,
           fmt::format("give one of {}, {} and {}", whole, pairs, times));
  }
  if (o.has(times)) {
    std::vector<double> times_s;
    o.read(times, times_s);
    pairs_mph = pair_speeds_mph(o, times, times_s, spacing_in);
  } else if (o.has(pairs)) {
    o.read(pairs, pairs_mph);
    if (pairs_mph.size() != 3) o.fail("not three speeds", pairs, "give one per pair of gates");
  }
  o.read(whole, speed_mph);
  if (!pairs_mph.empty()) speed_mph = mean_of(pairs_mph);
  const std::string key = o.has(times) ? times : o.has(pairs) ? pairs : whole;
  for (const double pair : pairs_mph) {
    if (!(pair > 0 && pair <= kMaxSpeed_mph)) o.fail(fmt::format("a speed of {:g} mph", pair), key, "check the gates");
  }
  if (!(speed_mph > 0 && speed_mph <= kMaxSpeed_mph))
    o.fail(fmt::format("a speed of {:g} mph", speed_mph), key, "give a speed above 0 mph, at most 400 mph");
}

// A shot of the session, or a hit that calibrates the ball lot (`of_lot`). The hit has no location and no damage.
SessionShot read_session_shot(StrictObject& o, double spacing_in, bool of_lot) {
  SessionShot shot{.place = o.place()};
  for (const char* key : {"ball", "ball_g", "angle_deg"}) o.need(key);
  o.read("ball", shot.ball);
  if (shot.ball.empty() || shot.ball.size() > 80)
    o.fail("the ball's number is empty or longer than 80 characters", "ball", "give the number on the ball");
  if (!of_lot) o.need("z_in");
  if (!of_lot) o.read_within("z_in", 0, 60, shot.z_in);
  o.read("ear", shot.ear);
  if (o.has("ear") && (shot.ear < 1 || shot.ear > 4)) o.fail("no such ear", "ear", "give 1 to 4");
  o.read_within("ball_g", 1, 1000, shot.ball_g);
  o.read_within("angle_deg", -90, 90, shot.angle_deg);
  o.read_within("temperature_f", -100, 200, shot.temperature_F);
  o.read_within("humidity_percent", 0, 100, shot.humidity_percent);
  if (!of_lot) o.read("damage", shot.damage);
  read_speed(o, "in", spacing_in, shot.in_mph, shot.pairs_in_mph);
  read_speed(o, "out", spacing_in, shot.out_mph, shot.pairs_out_mph);
  return shot;
}

void read_session_bat(StrictObject& o, SessionBat& bat) {
  for (const char* key : {"id", "length_in", "days_in_lab"}) o.need(key);
  o.read("id", bat.id);
  o.read_within("length_in", 20, 50, bat.length_in);
  o.read_within("moi_oz_in2", 1, 1e6, bat.moi_ozin2);
  o.read_within("weight_oz", 1, 200, bat.weight_oz);
  o.read_within("days_in_lab", 0, 1e6, bat.days_in_lab);
  for (const auto& [key, text] :
       {std::pair{"material", &bat.material}, {"condition", &bat.condition}, {"program", &bat.program}}) {
    o.read(key, *text);
    if (text->size() > 80) o.fail("more than 80 characters", key, "give a word, as in the table of a study");
  }
}

void read_lot(StrictObject& o, double spacing_in, BallLot& lot) {
  o.need("days_in_lab");
  o.read("id", lot.id);
  o.read_within("days_in_lab", 0, 1e6, lot.days_in_lab);
  o.read_within("correction", -0.2, 0.2, lot.correction);
  o.read_list("hits", [&](StrictObject& hit) {
    if (lot.hits.size() == kMaxShots) o.fail("more than 100000 hits", "hits", "keep one session per file");
    lot.hits.push_back(read_session_shot(hit, spacing_in, true));
  });
}

// The range of permitted locations, from a document or from the metadata of a table.
void read_range(StrictObject& o, Session& s) {
  std::vector<double> range{s.low_in, s.high_in};
  o.read("range_in", range);
  const bool fits = range.size() == 2 && range[0] > 0 && range[0] <= 5 && range[1] >= 7;
  if (!fits || range[1] >= s.bat.length_in - 12) {
    o.fail("not a range of locations", "range_in",
           "give [low, high]: low at most 5 in, high at least 7 in and less than the length minus 12 in");
  }
  s.low_in = range[0];
  s.high_in = range[1];
}

void read_session_document(StrictObject& o, Session& s) {
  std::string schema = "percuss/session/1", metric = name_of(s.metric);
  o.read("schema", schema);
  if (schema != "percuss/session/1") o.fail("not a session", "schema", "give percuss/session/1");
  for (const char* key : {"bat", "ball_lot", "lab", "shots"}) o.need(key);
  double spacing_in = 6;
  o.read_within("gate_spacing_in", 0.1, 100, spacing_in);
  o.read("metric", metric);
  const auto known = performance_metric_named(metric);
  if (!known) o.fail("no such metric", "metric", "give besr, ncaa_besr or bbcor");
  s.metric = *known;
  o.read_within("limit", 0, kMaxLimit, s.limit);
  o.read_part("bat", [&](StrictObject& part) { read_session_bat(part, s.bat); });
  o.read_part("lab", [&](StrictObject& part) {
    for (const char* key : {"temperature_f", "humidity_percent"}) part.need(key);
    part.read_within("temperature_f", -100, 200, s.temperature_F);
    part.read_within("humidity_percent", 0, 100, s.humidity_percent);
  });
  o.read_part("ball_lot", [&](StrictObject& part) { read_lot(part, spacing_in, s.lot); });
  read_range(o, s);
  o.read_list("shots", [&](StrictObject& shot) {
    if (s.shots.size() == kMaxShots) o.fail("more than 100000 shots", "shots", "keep one session per file");
    s.shots.push_back(read_session_shot(shot, spacing_in, false));
  });
}

}  // namespace

const char* name_of(PerformanceMetric metric) { return kMetricNames.at(static_cast<std::size_t>(metric)).first; }

std::optional<PerformanceMetric> performance_metric_named(std::string_view name) {
  for (const auto& [known, metric] : kMetricNames) {
    if (name == known) return metric;
  }
  return std::nullopt;
}

Session parse_session(std::string_view text, const std::string& where) {
  if (text.size() > kMaxSession_bytes) throw InputError("longer than 16 MiB", where, "give a session");
  Session session;
  const JsonText input{.text = text, .where = where, .options = {kSessionExample}};
  const auto read = [&](StrictObject& o) { read_session_document(o, session); };
  looks_like_json(text) ? read_strict_json(input, read) : read_strict_table(input, "shots", read);
  return session;
}

Session read_session(const std::string& path) {
  return parse_session(read_input(path, kMaxSession_bytes).view(), input_name(path));
}

}  // namespace percuss::metrics
