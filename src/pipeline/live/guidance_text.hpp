#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "pipeline/live/guide.hpp"
#include "pipeline/live/session_quality.hpp"

namespace percuss::pipeline {

// The sentences of a guided session, for a terminal or a page. Points have the numbers of the geometry; their places in
// the plan, and blows, count from 1.

enum class RovingPart { hammer, sensor };

/// "point 7 of 24, blow 3 of 5", "point 12 (7 of 24), blow 3 of 5" where the number of the point is not its place in
/// the plan; without the point where there is one only. "a further blow (4)" where there are as many as planned.
std::string place_text(const SessionPlan& plan, int point, std::size_t blow);
/// What to do next: "strike: blow 3 of 5", "move the hammer to point 8 of 24, then strike", "finished".
std::string prompt_text(const SessionState& session, RovingPart roving);
/// One line: place, number of the hit in the file where that is another, verdict, reason and remedy, or what the blow
/// reached and advice about the range.
std::string blow_text(const BlowReport& blow, const LiveChannels& channels, const SessionPlan& plan);
/// Advice on an accepted blow: "hit a little softer (force at 94 % of range)"; empty: none. `first`: among the first
/// blows, which set the range.
std::string range_advice(const BlowGrade& grade, const LiveChannels& channels, bool first);
/// "6 modes in Hz: bending 1 205.1 ± 0.08, …; coherence 0.998".
std::string quality_text(const SessionQuality& quality, std::size_t max_modes = 6);
/// "3 more blows bring hoop 1 below 0.05 Hz", goal by goal; without goals, about the mode with the largest ±.
std::string outlook_text(const SessionQuality& quality, const std::vector<PrecisionGoal>& goals);
/// Goal by goal, whether it was reached: "the goal hoop 1 < 0.05 Hz is met, ± 0.031 Hz".
std::string goals_text(const SessionQuality& quality, const std::vector<PrecisionGoal>& goals);
/// A fault of the capture, between the blows: "a gap of 200 frames".
std::string fault_text(const acquire::CaptureFinding& fault, const LiveChannels& channels);
/// A blow that is not recorded (GuideObserver::on_left_out).
std::string left_out_text(double time_s, bool too_early);
/// Why no blow is seen (GuideObserver::on_silent_hammer); `later`: after others.
std::string silent_hammer_text(const LiveChannels& channels, std::optional<double> trigger_N, bool later);
/// A push at this time was too long for a blow.
std::string long_push_text(const LongPush& push, double time_s);
/// The end: "22 of 24 points complete; 113 blows count, 9 rejected, 2 undone".
std::string summary_text(const SessionState& session);

}  // namespace percuss::pipeline
