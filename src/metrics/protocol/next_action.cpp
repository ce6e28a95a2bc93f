#include "metrics/protocol/next_action.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "metrics/protocol/performance.hpp"

namespace percuss::metrics {
namespace {

// The usable ball with the fewest impacts.
std::string ball_to_use(const Certification& c) {
  const BallUse* least = nullptr;
  std::string name;
  for (const auto& [id, ball] : c.balls) {
    if (!ball.spent.empty() || (least != nullptr && least->impacts <= ball.impacts)) continue;
    least = &ball;
    name = id;
  }
  return name;
}

NextAction action_for_conditions(const Certification& c) {
  const ProtocolFinding& first = c.conditions.front();
  if (first.code == "implausible_value")
    return {.code = "check_bat", .message = "check the bat's readings: " + first.message};
  const bool bat = first.code == "bat_conditioning", balls = first.code == "ball_conditioning";
  return {.code = bat     ? "condition_bat"
                  : balls ? "condition_balls"
                          : "restore_climate",
          .message = (bat || balls ? "wait: " : "restore the laboratory's climate: ") + first.message};
}

std::string no_sweet_spot_message(const SearchStep& search) {
  const double first_in = 0.5 * search.plateau.front(), last_in = 0.5 * search.plateau.back();
  if (search.plateau.size() == 1) {
    return fmt::format(
        "stop: the best location, {:g} in, is at an end of the permitted range: no sweet spot is isolated", first_in);
  }
  return fmt::format("stop: {} adjacent locations, {:g} to {:g} in, are within the margin{}: no sweet spot is isolated",
                     search.plateau.size(), first_in, last_in,
                     search.state == SearchState::edge ? ", up to an end of the permitted range" : "");
}

std::string end_message(const Session& s, const Certification& c) {
  switch (c.verdict) {
    case CertifyVerdict::pass:
      return fmt::format("done: the sweet spot is {:g} in from the tip, {} {:.4f} there, within the limit of {:g}",
                         *c.sweet_spot_in, name_of(s.metric), *c.best, *s.limit);
    case CertifyVerdict::fail:
      return damaged(c)
                 ? "stop: the bat is damaged"
                 : fmt::format("stop: {} {:.4f} exceeds the limit of {:g}", name_of(s.metric), *c.best, *s.limit);
    case CertifyVerdict::no_limit:
      return fmt::format("done: the sweet spot is {:g} in from the tip, {} {:.4f} there; no limit was given",
                         *c.sweet_spot_in, name_of(s.metric), *c.best);
    default:
      return no_sweet_spot_message(c.search);
  }
}

}  // namespace

double contact_mph(const Session& s, double z_in) {
  return contact_speed_mps(s.bat.length_in * kInch_m, z_in * kInch_m) / kMilePerHour_mps;
}

bool damaged(const Certification& c) {
  return std::any_of(c.remarks.begin(), c.remarks.end(), [](const auto& remark) { return remark.code == "damage"; });
}

NextAction next_action(const Session& s, const Certification& c, const ProtocolLimits& limits) {
  if (c.verdict != CertifyVerdict::in_progress) return {.code = "stop", .message = end_message(s, c)};
  if (!c.conditions.empty()) return action_for_conditions(c);
  NextAction next{.code = "lot_hit", .ball = ball_to_use(c)};
  if (!c.correction) {
    next.left = limits.lot_hits - c.valid_lot_hits;
    next.z_in = 6;
    next.target_mph = kNominalSpeed_mph;
    next.message = fmt::format("lot: {} more valid hits on the standard bat, 6 in from its tip, at {:g} ± {:g} mph",
                               next.left, kNominalSpeed_mph, limits.inbound_tolerance_mph);
    return next;
  }
  next.code = "shoot";
  next.z_in = 0.5 * c.search.at;
  next.target_mph = contact_mph(s, *next.z_in);
  next.left = limits.shots;
  for (const TestedLocation& location : c.locations) {
    if (location.z_in == *next.z_in) next.left -= std::min(location.valid, limits.shots);
  }
  next.message = fmt::format("shoot: {} more valid shots {:g} in from the tip, at {:.2f} ± {:g} mph", next.left,
                             *next.z_in, *next.target_mph, limits.inbound_tolerance_mph);
  return next;
}

}  // namespace percuss::metrics
