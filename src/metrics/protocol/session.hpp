#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::metrics {

/// The metric by which a bat is judged.
enum class PerformanceMetric { besr, ncaa_besr, bbcor };
const char* name_of(PerformanceMetric metric);
std::optional<PerformanceMetric> performance_metric_named(std::string_view name);

/// One ball fired at the bat (or at the standard bat, for the lot). The units are the protocol's, because its
/// limits are round numbers in them.
struct SessionShot {
  std::string place;  // in the file, for error messages
  std::string ball;
  double z_in = 6;  // from the barrel's tip
  int ear = 0;      // wide face of the ball without a seam, 1 to 4; 0: not stated
  double ball_g = 0;
  double in_mph = 0, out_mph = 0;
  std::vector<double> pairs_in_mph, pairs_out_mph;        // by pair of gates; empty: not stated
  double angle_deg = 0;                                   // of the rebound, vertically
  std::optional<double> temperature_F, humidity_percent;  // replace the session's values
  std::string damage;                                     // visible after the shot
};

struct SessionBat {
  std::string id;
  double length_in = 0;
  std::optional<double> moi_ozin2, weight_oz;
  double days_in_lab = 0;
  std::string material, condition, program;  // as in the table of a study
};

/// The balls of one lot, and their hits on the standard bat.
struct BallLot {
  std::string id;
  double days_in_lab = 0;
  std::optional<double> correction;  // ε; otherwise computed from the hits
  std::vector<SessionShot> hits;
};

/// A test of one bat, finished or not.
struct Session {
  SessionBat bat;
  BallLot lot;
  double temperature_F = 0, humidity_percent = 0;
  PerformanceMetric metric = PerformanceMetric::ncaa_besr;
  std::optional<double> limit;
  double low_in = 3, high_in = 9;  // permitted locations; default: the range with measured barrel diameters
  std::vector<SessionShot> shots;  // in the order fired
};

/// Reads percuss/session/1 (docs/schema/session.schema.json) or the same as a table of shots
/// (docs/theory/performance.md).
/// errors  InputError with file and key or line: another document, an impossible number, gate times that do not rise.
Session parse_session(std::string_view text, const std::string& where);
Session read_session(const std::string& path);

/// An example session to start from; the same as a table.
std::string session_example();
std::string session_table_example();

}  // namespace percuss::metrics
