#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::metrics {

/// What a bat's performance is judged by.
enum class PerformanceMetric { besr, ncaa_besr, bbcor };
const char* name_of(PerformanceMetric metric);
std::optional<PerformanceMetric> performance_metric_named(std::string_view name);

/// One ball fired at the bat (or, for the lot, at the standard bat), in the protocol's own units, in which its limits
/// are round numbers.
struct SessionShot {
  std::string place;  // in the file, for messages
  std::string ball;
  double z_in = 6;  // from the barrel's tip
  int ear = 0;      // 1 to 4; 0: not stated
  double ball_g = 0;
  double in_mph = 0, out_mph = 0;
  std::vector<double> pairs_in_mph, pairs_out_mph;        // by pair of gates; empty: not stated
  double angle_deg = 0;                                   // of the rebound, vertically
  std::optional<double> temperature_F, humidity_percent;  // in place of the session's
  std::string damage;                                     // seen after the shot
};

struct SessionBat {
  std::string id;
  double length_in = 0;
  std::optional<double> moi_ozin2, weight_oz;
  double days_in_lab = 0;
};

/// Balls of one lot, and how they do on the standard bat.
struct BallLot {
  std::string id;
  double days_in_lab = 0;
  std::optional<double> correction;  // ε; else from the hits
  std::vector<SessionShot> hits;
};

/// A test of one bat, as far as it has gone.
struct Session {
  SessionBat bat;
  BallLot lot;
  double temperature_F = 0, humidity_percent = 0;
  PerformanceMetric metric = PerformanceMetric::ncaa_besr;
  std::optional<double> limit;
  double low_in = 3, high_in = 9;  // where the ball may hit: the profile's rings
  std::vector<SessionShot> shots;  // in the order fired
};

/// Reads percuss/session/1 (docs/schema/session.schema.json) or the same as a table of shots (docs/theory/performance.md).
/// errors  InputError with file and key or line: not such a document, a number that cannot be, gates' times that do not
/// rise, MOI missing where BBCOR is asked for.
Session parse_session(std::string_view text, const std::string& where);
Session read_session(const std::string& path);

/// A session as an operator may start from; the same as a table.
std::string session_example();
std::string session_table_example();

}  // namespace percuss::metrics
