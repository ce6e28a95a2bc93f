#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "metrics/protocol/location_metrics.hpp"
#include "metrics/protocol/session.hpp"
#include "metrics/protocol/sweet_spot.hpp"

namespace percuss::metrics {

/// The limits of the protocol, [8] in docs/theory/sources.md, sections 3.3 to 3.5.
struct ProtocolLimits {
  double temperature_F = 72, temperature_tolerance_F = 4;
  double humidity_percent = 50, humidity_tolerance_percent = 5;
  double ball_days = 14, bat_days = 2;
  double ball_g = 145.4, ball_tolerance_g = 1.0;
  int impacts = 8, ear_impacts = 2;  // of one ball; on one ear (SessionShot::ear)
  double inbound_tolerance_mph = 2, angle_deg = 5, pair_tolerance_mph = 1.5;
  std::size_t shots = 6, lot_hits = 30;
  double lot_ratio = 0.231;  // v_out/v_in of the standard bat
  double margin_besr = 0.003;
  bool accept_plateau = false;  // take the best location of a plateau as the sweet spot, instead of no verdict
};

/// A violated limit, or a remark: a code for programs and a sentence for people.
struct ProtocolFinding {
  std::string code, message;
};

struct JudgedShot {
  double in_mph = 0, out_mph = 0, target_mph = 0, value = 0;  // value: the metric (BESR for BBCOR), uncorrected
  bool counted = false;                                       // one of the first six of its location; of the lot: valid
  std::vector<ProtocolFinding> reasons;                       // none: valid
  bool valid() const { return reasons.empty(); }
};

struct BallUse {
  int impacts = 0;
  std::array<int, 5> ears{};  // impacts by SessionShot::ear; [0]: not stated
  double ball_g = 0;          // at the last weighing
  std::string spent;          // the reason not to use it again; empty: usable
};

struct TestedLocation {
  double z_in = 0;
  std::size_t valid = 0;
  bool complete = false;
  double mean = 0, std_error = 0;  // of the shots counted so far, with the correction
  LocationMetrics metrics;         // of the same shots
};

enum class CertifyVerdict { in_progress, pass, fail, undecided, no_limit };
const char* name_of(CertifyVerdict verdict);

struct NextAction {
  std::string code;  // check_bat, condition_bat, condition_balls, restore_climate, lot_hit, shoot, stop
  std::optional<double> z_in, target_mph;
  std::size_t left = 0;  // remaining hits or shots
  std::string ball;      // the least used of the usable balls; empty: a new one
  std::string message;
};

struct Certification {
  std::vector<ProtocolFinding> conditions;  // violated
  std::optional<double> correction, correction_std;
  std::size_t valid_lot_hits = 0;
  std::vector<JudgedShot> lot_hits, shots;
  std::map<std::string, BallUse> balls;
  std::vector<TestedLocation> locations;  // by z
  SearchStep search;
  std::optional<double> sweet_spot_in, best, best_std;  // best: the highest mean of the complete locations
  std::optional<std::size_t> best_location;             // its index
  CertifyVerdict verdict = CertifyVerdict::in_progress;
  std::vector<ProtocolFinding> remarks;
  NextAction next;
};

/// Judges a session at any stage and states the next action. Shots are judged in their order, and a later shot never
/// changes the judgement of an earlier one. The mean of a location is the mean of its first six valid shots.
/// A bat fails as soon as damage is seen. Once the lot's correction is known and no condition is violated, it also
/// fails as soon as a complete location exceeds the limit. It passes only when the sweet spot is found and every
/// complete location keeps the limit.
/// errors  InputError: BBCOR without the bat's moment of inertia.
Certification certify(const Session& session, const ProtocolLimits& limits = {});

/// Violated limits of the laboratory and of conditioning, and implausible readings of the bat.
std::vector<ProtocolFinding> condition_findings(const Session& session, const ProtocolLimits& limits = {});

/// Judges one shot and counts the impact of its ball. A violated limit of the laboratory or of conditioning makes every
/// shot invalid, but a shot's own temperature and humidity replace the session's.
JudgedShot judge_shot(const Session& session, const SessionShot& shot, double target_mph, BallUse& ball,
                      const ProtocolLimits& limits);

}  // namespace percuss::metrics
