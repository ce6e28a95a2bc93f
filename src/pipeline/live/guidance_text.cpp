#include "pipeline/live/guidance_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "acquire/hits/pulse_shape.hpp"
#include "acquire/live/capture_finding.hpp"
#include "core/io/counted_words.hpp"
#include "core/io/significant_digits.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kNearFullScale = 0.9;               // of the range: the next harder blow is clipped
constexpr double kLowForce = 0.2, kLowAccel = 0.03;  // of the range: below, advise a higher gain
constexpr double kLowCoherence = 0.9;
constexpr std::size_t kMaxShownPoints = 8;
constexpr std::size_t kMaxOutlook = 30;  // blows
constexpr double kTarget = 0.5;          // without goals: the blows that halve the ±

std::size_t index_of(const SessionPlan& plan, int point) {
  return static_cast<std::size_t>(std::find(plan.points.begin(), plan.points.end(), point) - plan.points.begin());
}

std::string force_text(double peak_N) { return fmt::format("{:.3g} N", std::abs(peak_N)); }

std::string frequency_text(double freq_Hz) {
  return freq_Hz < 1000 ? fmt::format("{:.0f} Hz", freq_Hz) : fmt::format("{:.2f} kHz", freq_Hz / 1000);
}

std::string point_text(const SessionPlan& plan, int point) {
  const std::size_t place = index_of(plan, point) + 1, points = plan.points.size();
  if (point == static_cast<int>(place)) return fmt::format("point {} of {}", point, points);
  return fmt::format("point {} ({} of {})", point, place, points);
}

std::string goal_text(const PrecisionGoal& goal, const SessionQuality& quality) {
  const auto m = mode_of(goal, quality);
  if (!m) return goal.text() + ": not found yet";
  const LiveMode& mode = quality.modes[*m];
  const std::string name = name_of(mode, *m);
  const double limit = limit_Hz(goal, mode);
  if (!(mode.freq_std_Hz > 0)) return fmt::format("one more blow gives a ± of {}", name);
  const auto more = further_blows(mode, quality.blows, limit);
  if (!more) return fmt::format("more blows alone do not bring {} below {:.3g} Hz", name, limit);
  if (*more == 0) return fmt::format("{} is below {:.3g} Hz", name, limit);
  return fmt::format("{} more blow{} bring{} {} below {:.3g} Hz", *more, plural(*more), *more == 1 ? "s" : "", name,
                     limit);
}

}  // namespace

std::string place_text(const SessionPlan& plan, int point, std::size_t blow) {
  std::string blows =
      blow <= plan.hits ? fmt::format("blow {} of {}", blow, plan.hits) : fmt::format("a further blow ({})", blow);
  if (plan.points.size() == 1) return blows;
  return point_text(plan, point) + ", " + blows;
}

std::string prompt_text(const SessionState& session, RovingPart roving) {
  if (session.finished()) return "finished";
  if (session.paused()) return "paused; press space to go on";
  const SessionPlan& plan = session.plan();
  const std::size_t accepted = session.accepted_at(session.point());
  std::string strike = "strike: " + place_text(plan, session.point(), accepted + 1);
  const auto& blows = session.blows();
  const bool here = accepted > 0 && blows.back().point == session.point();
  if (plan.points.size() == 1 || here) return strike;
  const char* const moves = roving == RovingPart::hammer ? "hammer" : "sensor";
  if (accepted > 0)
    return fmt::format("move the {}, then strike: {}", moves, place_text(plan, session.point(), accepted + 1));
  return fmt::format("move the {} to {}, then strike", moves, point_text(plan, session.point()));
}

std::string range_advice(const BlowGrade& grade, const LiveChannels& channels, bool first) {
  if (grade.force_range && *grade.force_range > kNearFullScale)
    return fmt::format("hit a little softer (force at {:.3g} % of range)", *grade.force_range * 100);
  const auto accel = [&] { return fmt::format("channel {}", channels.accel_numbers.at(grade.accel_channel)); };
  if (grade.accel_range && *grade.accel_range > kNearFullScale)
    return fmt::format("hit a little softer ({} at {:.3g} % of range)", accel(), *grade.accel_range * 100);
  if (!first) return {};
  if (grade.force_range && *grade.force_range < kLowForce)
    return fmt::format("force peak at {:.2g} % of full scale: raise the gain", *grade.force_range * 100);
  if (grade.accel_range && *grade.accel_range < kLowAccel)
    return fmt::format("{} at {:.2g} % of full scale: raise the gain", accel(), *grade.accel_range * 100);
  return {};
}

std::string blow_text(const BlowReport& blow, const LiveChannels& channels, const SessionPlan& plan) {
  const BlowGrade& grade = blow.grade;
  std::string place = place_text(plan, blow.point, blow.blow);
  place.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(place.front())));
  if (blow.row + 1 != blow.blow) place += fmt::format(" (hit {})", blow.row + 1);
  if (!grade.accepted())
    return fmt::format("{}: rejected: {}{}{}", place, grade.reason, grade.remedy.empty() ? "" : "; ", grade.remedy);
  std::string text =
      fmt::format("{}: accepted, {} up to {}", place, force_text(grade.peak_N), frequency_text(grade.bandwidth_Hz));
  const std::string advice = range_advice(grade, channels, blow.may_advise_gain);
  if (!advice.empty()) text += "; " + advice;
  if (blow.may_advise_gain && !grade.implausible.empty()) text += "; " + grade.implausible;
  if (grade.moved_before) text += "; it had not come to rest: wait a little longer between blows";
  if (grade.unlike_others) text += "; little like the other blows: another place, or noise?";
  if (blow.one_more) text += "; one more blow at this point helps to decide";
  if (grade.rings_at_end) text += "; still ringing at the end: state a longer length to keep the whole decay";
  return text;
}

std::string quality_text(const SessionQuality& quality, std::size_t max_modes) {
  if (quality.modes.empty()) return fmt::format("{} blow{}, no modes yet", quality.blows, plural(quality.blows));
  std::string text = fmt::format("{} mode{} in Hz: ", quality.modes.size(), plural(quality.modes.size()));
  for (std::size_t m = 0; m < std::min(max_modes, quality.modes.size()); ++m) {
    const LiveMode& mode = quality.modes[m];
    const std::string name = mode.order > 0 ? name_of(mode, m) + " " : "";
    text += (m > 0 ? ", " : "") + name + value_with_std(mode.freq_Hz, mode.freq_std_Hz);
  }
  if (quality.modes.size() > max_modes) text += ", …";
  if (quality.coherence) text += fmt::format("; coherence {:.3f}", *quality.coherence);
  if (quality.coherence && *quality.coherence < kLowCoherence) text += ": low, the blows of a point differ";
  return text;
}

std::string outlook_text(const SessionQuality& quality, const std::vector<PrecisionGoal>& goals) {
  std::string text;
  for (const PrecisionGoal& goal : goals) text += (text.empty() ? "" : "; ") + goal_text(goal, quality);
  if (!goals.empty() || quality.modes.empty()) return text;
  const auto widest =
      std::max_element(quality.modes.begin(), quality.modes.end(),
                       [](const LiveMode& a, const LiveMode& b) { return a.freq_std_Hz < b.freq_std_Hz; });
  const auto more = further_blows(*widest, quality.blows, kTarget * widest->freq_std_Hz);
  const std::string name = name_of(*widest, static_cast<std::size_t>(widest - quality.modes.begin()));
  if (!more || *more > kMaxOutlook || !(widest->freq_std_Hz > 0)) return {};
  return fmt::format("{} more blow{} halve{} the ± of {}, {:.2g} Hz", *more, plural(*more), *more == 1 ? "s" : "", name,
                     widest->freq_std_Hz);
}

std::string goals_text(const SessionQuality& quality, const std::vector<PrecisionGoal>& goals) {
  std::string text;
  for (const PrecisionGoal& goal : goals) {
    const auto m = mode_of(goal, quality);
    text += fmt::format("{}the goal {} is {}", text.empty() ? "" : "; ", goal.text(),
                        is_met(goal, quality) ? "met" : "not met");
    if (!m) {
      text += ": no such mode was found";
    } else if (quality.modes[*m].freq_std_Hz > 0) {
      const LiveMode& mode = quality.modes[*m];
      text += goal.relative ? fmt::format(", ± {:.2g} %", 100 * mode.freq_std_Hz / mode.freq_Hz)
                            : fmt::format(", ± {:.2g} Hz", mode.freq_std_Hz);
    }
    if (m && quality.blows < kMinBlowsForGoals) text += fmt::format(": {} blows must count", kMinBlowsForGoals);
  }
  return text;
}

std::string fault_text(const acquire::CaptureFinding& fault, const LiveChannels& channels) {
  if (fault.fault != acquire::CaptureFault::not_a_number) return acquire::finding_text(fault);
  const auto accel = std::find(channels.accel.begin(), channels.accel.end(), fault.channel);
  const std::string name = accel == channels.accel.end()
                               ? fmt::format("channel {} (the force)", channels.force_number)
                               : name_of_channel(channels, static_cast<std::size_t>(accel - channels.accel.begin()));
  return name + " delivers values that are no numbers; check its cable and its input";
}

std::string left_out_text(double time_s, bool too_early) {
  if (too_early) {
    return fmt::format(
        "the blow at {:.2f} s is not recorded: there was no time to measure the noise before it; wait a second before "
        "the first blow",
        time_s);
  }
  return fmt::format(
      "the blow at {:.1f} s is not recorded: another blow, lost samples or the end of the recording came before its "
      "decay could be measured; wait longer between blows, or state the length",
      time_s);
}

std::string long_push_text(const LongPush& push, double time_s) {
  return fmt::format(
      "a push of {:.3g} N and {:.3g} ms, {:.1f} s after the start, is no blow: a hammer's contact lasts "
      "{:.0f} ms at most; strike shorter, or use a harder tip",
      std::abs(push.peak_N), 1e3 * push.length_s, time_s, 1e3 * acquire::kLongestPulse_s);
}

std::string silent_hammer_text(const LiveChannels& channels, std::optional<double> trigger_N, bool later) {
  if (later) {
    return fmt::format(
        "{} moved as after a blow, but the force on channel {} stayed below the trigger level: if you have struck, "
        "check the hammer and its cable{}",
        name_of_channel(channels, 0), channels.force_number,
        trigger_N ? fmt::format(", or state a level below {:.6g} N", *trigger_N) : "");
  }
  if (trigger_N) {
    return fmt::format(
        "{} moves, but the force stays below the trigger level of {:.6g} N: if you have struck, state a "
        "lower one, or check the hammer on channel {}",
        name_of_channel(channels, 0), *trigger_N, channels.force_number);
  }
  return fmt::format(
      "{} moves, but the hammer on channel {} is silent: if you have struck, check its cable, its input and its noise",
      name_of_channel(channels, 0), channels.force_number);
}

std::string summary_text(const SessionState& session) {
  const SessionPlan& plan = session.plan();
  const std::size_t complete = session.complete_points();
  const std::size_t accepted = session.accepted(), undone = session.undone();
  const std::size_t rejected = session.blows().size() - accepted - undone;
  std::string text =
      fmt::format("{} blow{} count{}, {} rejected", accepted, plural(accepted), accepted == 1 ? "s" : "", rejected);
  if (undone > 0) text += fmt::format(", {} undone", undone);
  if (plan.points.size() > 1) text = fmt::format("{} of {} points complete; {}", complete, plan.points.size(), text);
  const std::vector<int> doubtful = session.doubtful_points();
  if (doubtful.empty()) return text;
  if (plan.points.size() == 1) return text + "; they differ: another place, or noise?";
  const auto shown = static_cast<std::ptrdiff_t>(std::min<std::size_t>(doubtful.size(), kMaxShownPoints));
  text += fmt::format("; the blows of point{} {} differ", plural(doubtful.size()),
                      fmt::join(doubtful.begin(), doubtful.begin() + shown, ", "));
  if (doubtful.size() > kMaxShownPoints) text += fmt::format(" and of {} more", doubtful.size() - kMaxShownPoints);
  return text + ": another place, or noise?";
}

}  // namespace percuss::pipeline
