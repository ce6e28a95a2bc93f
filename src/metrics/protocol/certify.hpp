#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "metrics/protocol/session.hpp"
#include "metrics/protocol/sweet_spot.hpp"

namespace percuss::metrics {

/// The protocol's limits, [8] in docs/theory/sources.md, sections 3.3 to 3.5.
struct ProtocolLimits {
  double temperature_F = 72, temperature_tolerance_F = 4;
  double humidity_percent = 50, humidity_tolerance_percent = 5;
  double ball_days = 14, bat_days = 2;
  double ball_g = 145.4, ball_tolerance_g = 1.0;
  int impacts = 8, ear_impacts = 2;
  double inbound_tolerance_mph = 2, angle_deg = 5, pair_tolerance_mph = 1.5;
  std::size_t shots = 6, lot_hits = 30;
  double lot_ratio = 0.231;  // v_out/v_in of the standard bat
  double margin_besr = 0.003;
  bool accept_plateau = false;  // the best of a plateau is the sweet spot, in place of no verdict
};

/// Something that does not hold, as a word for programs and a sentence for people.
struct ProtocolFinding {
  std::string code, message;
};

struct JudgedShot {
  double in_mph = 0, out_mph = 0, target_mph = 0, value = 0;  // value: of the metric, without the lot's correction
  bool counted = false;                                       // one of a location's first six
  std::vector<ProtocolFinding> reasons;                       // none: valid
  bool valid() const { return reasons.empty(); }
};

struct BallUse {
  int impacts = 0;
  std::array<int, 5> ears{};  // by ear; [0]: not stated
  double ball_g = 0;          // as last weighed
  std::string spent;          // why it may not be used again; empty: it may
};

struct TestedLocation {
  double z_in = 0;
  std::size_t valid = 0;
  bool complete = false;
  double mean = 0, std_error = 0;  // of the shots counted so far, correction included
};

enum class CertifyVerdict { in_progress, pass, fail, undecided, no_limit };
const char* name_of(CertifyVerdict verdict);

struct NextAction {
  std::string code;  // condition_bat, condition_balls, restore_climate, lot_hit, shoot, stop
  std::optional<double> z_in, target_mph;
  std::size_t left = 0;  // hits or shots
  std::string ball;      // the least used of those known that may be used; empty: a new one
  std::string message;
};

struct Certification {
  std::vector<ProtocolFinding> conditions;  // that do not hold
  std::optional<double> correction, correction_std;
  std::size_t valid_lot_hits = 0;
  std::vector<JudgedShot> lot_hits, shots;
  std::map<std::string, BallUse> balls;
  std::vector<TestedLocation> locations;  // by z
  SearchStep search;
  std::optional<double> sweet_spot_in, best, best_std;  // best: the highest mean of the complete locations
  CertifyVerdict verdict = CertifyVerdict::in_progress;
  std::vector<ProtocolFinding> remarks;
  NextAction next;
};

/// Judges a session as far as it has gone, and says what comes next. Shots are judged in their order: later ones never
/// change what was said of earlier ones, and a location's mean is that of its first six valid shots.
/// A bat fails as soon as a complete location exceeds the limit or damage is seen; it passes only when the sweet spot
/// is found and the limit held there and at every location tested.
Certification certify(const Session& session, const ProtocolLimits& limits = {});

/// The laboratory's and the conditioning limits that do not hold.
std::vector<ProtocolFinding> condition_findings(const Session& session, const ProtocolLimits& limits = {});

/// The shots judged one by one with the balls' books kept; `conditions` that do not hold make all of them invalid.
JudgedShot judge_shot(const Session& session, const SessionShot& shot, double target_mph, BallUse& ball,
                      const ProtocolLimits& limits);

}  // namespace percuss::metrics
