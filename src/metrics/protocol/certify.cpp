#include "metrics/protocol/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "metrics/protocol/averages.hpp"
#include "metrics/protocol/next_action.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

constexpr double kGridTolerance = 1e-6;  // in half inches

double inertia_ratio(const Session& s, double z_in, double ball_g) {
  return ball_to_bat_inertia(1e-3 * ball_g, s.bat.length_in * kInch_m, z_in * kInch_m,
                             s.bat.moi_ozin2.value_or(0) * kOunceInch2_kgm2);  // (P10)
}

// (P11)
void judge_lot(const Session& s, const ProtocolLimits& limits, Certification& out) {
  std::vector<double> corrections;
  for (const SessionShot& hit : s.lot.hits) {
    JudgedShot judged = judge_shot(s, hit, kNominalSpeed_mph, out.balls[hit.ball], limits);
    if (judged.valid()) corrections.push_back(limits.lot_ratio - hit.out_mph / hit.in_mph);
    judged.counted = judged.valid();
    out.lot_hits.push_back(std::move(judged));
  }
  out.valid_lot_hits = corrections.size();
  if (s.lot.correction) {
    out.correction = s.lot.correction;
  } else if (corrections.size() >= limits.lot_hits) {
    out.correction = mean_of(corrections);
    out.correction_std = standard_error_of(corrections);
  }
}

void check_location(const Session& s, const SessionShot& shot, JudgedShot& judged) {
  const double half_inches = 2 * shot.z_in;
  if (std::abs(half_inches - std::round(half_inches)) > kGridTolerance)
    judged.reasons.push_back({"location", fmt::format("{:g} in is not a multiple of 0.5 in", shot.z_in)});
  if (shot.z_in < s.low_in || shot.z_in > s.high_in) {
    judged.reasons.push_back(
        {"location", fmt::format("{:g} in is outside {:g} to {:g} in", shot.z_in, s.low_in, s.high_in)});
  }
}

void judge_shots(const Session& s, const ProtocolLimits& limits, Certification& out) {
  std::map<HalfInches, std::vector<double>> values;
  std::map<HalfInches, std::vector<const SessionShot*>> counted_shots;
  std::map<HalfInches, std::size_t> valid;
  for (const SessionShot& shot : s.shots) {
    JudgedShot judged = judge_shot(s, shot, contact_mph(s, shot.z_in), out.balls[shot.ball], limits);
    check_location(s, shot, judged);
    const auto at = half_inches(shot.z_in);
    const double correction = out.correction.value_or(0);
    if (judged.valid()) {
      ++valid[at];
      judged.counted = values[at].size() < limits.shots;
      double value = judged.value + correction;
      if (s.metric == PerformanceMetric::bbcor) value = bbcor_of(value, inertia_ratio(s, shot.z_in, shot.ball_g));
      if (judged.counted) {
        values[at].push_back(value);
        counted_shots[at].push_back(&shot);
      }
    }
    if (!shot.damage.empty())
      out.remarks.push_back({"damage", fmt::format("damage seen ({}): {}", shot.place, one_line(shot.damage, 80))});
    out.shots.push_back(std::move(judged));
  }
  for (const auto& [at, counted] : values) {
    out.locations.push_back({.z_in = 0.5 * at,
                             .valid = valid[at],
                             .complete = counted.size() == limits.shots,
                             .mean = mean_of(counted),
                             .std_error = standard_error_of(counted),
                             .metrics = location_metrics(s, 0.5 * at, counted_shots[at], out.correction.value_or(0))});
  }
}

void search(const Session& s, const ProtocolLimits& limits, Certification& out) {
  std::map<HalfInches, double> tested;
  for (const TestedLocation& location : out.locations) {
    if (!location.complete) continue;
    tested[half_inches(location.z_in)] = location.mean;
    if (out.best && *out.best >= location.mean) continue;
    out.best = location.mean;
    out.best_std = location.std_error;
    out.best_location = static_cast<std::size_t>(&location - out.locations.data());
  }
  SearchRules rules{.margin = limits.margin_besr,
                    .low = static_cast<HalfInches>(std::ceil(2 * s.low_in)),
                    .high = static_cast<HalfInches>(std::floor(2 * s.high_in))};
  // The margin is stated in BESR. By (P9), a difference of BBCOR is 1 + k times as large.
  if (s.metric == PerformanceMetric::bbcor) rules.margin *= 1 + inertia_ratio(s, 6, limits.ball_g);
  out.search = next_location(tested, rules);
  // An incomplete location with a higher mean so far must be completed before a conclusion.
  for (const TestedLocation& location : out.locations) {
    if (out.search.state != SearchState::shoot && !location.complete && location.mean > out.best)
      out.search = {.at = half_inches(location.z_in)};
  }
  const bool plateau = limits.accept_plateau && out.search.state == SearchState::plateau;
  if (plateau || out.search.state == SearchState::found) out.sweet_spot_in = 0.5 * out.search.at;
  if (!plateau) return;
  out.remarks.push_back(
      {"plateau", fmt::format("{:g} to {:g} in are within the margin: the best location was accepted as the sweet spot",
                              0.5 * out.search.plateau.front(), 0.5 * out.search.plateau.back())});
}

CertifyVerdict verdict_of(const Session& s, const Certification& c) {
  if (damaged(c)) return CertifyVerdict::fail;
  if (!c.correction || !c.conditions.empty()) return CertifyVerdict::in_progress;
  if (s.limit && c.best && *c.best > *s.limit + kReadingTolerance) return CertifyVerdict::fail;
  if (c.search.state == SearchState::shoot) return CertifyVerdict::in_progress;
  if (!c.sweet_spot_in) return CertifyVerdict::undecided;
  return s.limit ? CertifyVerdict::pass : CertifyVerdict::no_limit;
}

void add_remarks(const Session& s, Certification& c) {
  if (s.limit && c.best && std::abs(*c.best - *s.limit) < 2 * *c.best_std) {
    c.remarks.push_back(
        {"near_limit", fmt::format("the highest mean, {:.4f} ± {:.4f}, is within two standard errors of the limit",
                                   *c.best, *c.best_std)});
  }
  const auto no_pairs =
      std::count_if(s.shots.begin(), s.shots.end(), [](const SessionShot& shot) { return shot.pairs_in_mph.empty(); });
  if (no_pairs > 0) {
    c.remarks.push_back(
        {"pairs_not_given", fmt::format("{} one speed only: the agreement of the gates was not checked",
                                        no_pairs == 1 ? "1 shot has" : fmt::format("{} shots have", no_pairs))});
  }
}

}  // namespace

const char* name_of(CertifyVerdict verdict) {
  switch (verdict) {
    case CertifyVerdict::pass:
      return "pass";
    case CertifyVerdict::fail:
      return "fail";
    case CertifyVerdict::undecided:
      return "undecided";
    case CertifyVerdict::no_limit:
      return "no_limit";
    case CertifyVerdict::in_progress:
      break;
  }
  return "in_progress";
}

Certification certify(const Session& session, const ProtocolLimits& limits) {
  if (session.metric == PerformanceMetric::bbcor && !session.bat.moi_ozin2) {
    throw InputError("BBCOR needs the bat's moment of inertia", "bat.moi_oz_in2", "compute it from the pendulum",
                     {"metrics.period_s"});
  }
  Certification out{.conditions = condition_findings(session, limits)};
  judge_lot(session, limits, out);
  judge_shots(session, limits, out);
  search(session, limits, out);
  out.verdict = verdict_of(session, out);
  add_remarks(session, out);
  out.next = next_action(session, out, limits);
  return out;
}

}  // namespace percuss::metrics
