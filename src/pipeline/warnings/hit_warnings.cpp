#include "pipeline/warnings/hit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/io/counted_words.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/hits/hit_consistency.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kPoorCoherence = 0.5;
constexpr std::size_t kMaxPointsInText = 8, kMaxFilesInText = 4;
constexpr double kMaxForce_N = 1e5;  // sledge hammers for tests of bridges measure up to some 20 kN

// The accepted hits with a finding of this code, and the least value of these findings.
struct HitsWithFinding {
  std::vector<std::size_t> hits;
  double least = 0;
};

HitsWithFinding accepted_hits_with(const std::vector<AnalysedHit>& hits, acquire::FindingCode code,
                                   double below = std::numeric_limits<double>::infinity()) {
  HitsWithFinding out;
  for (const std::size_t h : accepted_hits(hits)) {
    for (const acquire::Finding& finding : hits[h].hit.findings) {
      if (finding.code != code || !(finding.value < below)) continue;
      out.least = out.hits.empty() ? finding.value : std::min(out.least, finding.value);
      out.hits.push_back(h);
    }
  }
  return out;
}

// [points] the accepted hits of a test.
std::map<int, std::vector<std::size_t>> hits_of_points(const std::vector<AnalysedHit>& hits) {
  std::map<int, std::vector<std::size_t>> out;
  for (const std::size_t h : accepted_hits(hits)) out[hits[h].point].push_back(h);
  return out;
}

// hits_disagree for the hits `poor`.
Warning disagreement(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                     const std::vector<std::size_t>& poor, const PointNames& names) {
  const auto all = hits_of_points(hits);
  std::map<int, std::vector<std::size_t>> points;  // with poor hits
  for (const std::size_t h : poor) points[hits[h].point].push_back(h);
  const bool survey = all.size() > 1;
  std::vector<std::string> who;
  for (const auto& [point, of_point] : points)
    who.push_back(hit_list(of_point) + (survey ? fmt::format(" at point {}", names.name(point)) : ""));
  Warning warning{"hits_disagree",
                  fmt::format("the other hits explain less than half of the response{} of {}: was another structure, "
                              "point or sensor measured? The modes belong to a mixture",
                              plural(poor.size()),
                              limited_list(who.size(), kMaxPointsInText, [&](std::size_t i) { return who[i]; }))};
  const bool several_tests = std::any_of(points.begin(), points.end(), [&](const auto& one) {
    return may_be_several_tests(record.rows, hits, all.at(one.first));
  });
  if (several_tests) {
    warning.options = {"files"};
    return with_remedy(std::move(warning), "analyse each file as a test of its own");
  }
  if (poor.size() > 1 && !survey)
    return with_remedy(std::move(warning), "analyse the hits of each structure and point apart");
  warning.options = {"reject_hit"};
  if (poor.size() == 1 && !survey) return with_remedy(std::move(warning), "reject this hit if it was elsewhere");
  const bool odd_ones =
      std::all_of(points.begin(), points.end(), [](const auto& one) { return one.second.size() == 1; });
  if (!odd_ones) {
    return with_remedy(std::move(warning), fmt::format("measure {} again, or reject the hits that were elsewhere",
                                                       points.size() == 1 ? "this point" : "these points"));
  }
  return with_remedy(std::move(warning), fmt::format("reject {} if {} elsewhere", hit_list(poor),
                                                     poor.size() == 1 ? "it was" : "they were"));
}

// "hits 4, 5", or in a survey "the hits at point 9 (P9.csv)", "hit 5 at point 2 (P2.csv), hit 9 at point 3 (P3.csv)".
std::string hits_at_points(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& which,
                           const PointNames& names) {
  const auto all = hits_of_points(hits);
  if (all.size() < 2) return hit_list(which);
  std::map<int, std::vector<std::size_t>> points;
  for (const std::size_t h : which) points[hits[h].point].push_back(h);
  std::vector<int> whole;
  std::vector<std::string> who;
  for (const auto& [point, of_point] : points) {
    if (of_point.size() == all.at(point).size()) whole.push_back(point);
    who.push_back(fmt::format("{} at point {}", hit_list(of_point), names.name(point)));
  }
  if (whole.size() == points.size())
    return fmt::format("the hit{} at {}", plural(which.size()), names.list(whole, kMaxPointsInText));
  return limited_list(who.size(), kMaxPointsInText, [&](std::size_t i) { return who[i]; });
}

// The files that hold these hits and no other accepted ones, in their order; nothing where other hits share a file.
std::optional<std::vector<std::size_t>> files_of(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                                 const std::vector<std::size_t>& which) {
  std::set<std::size_t> own, others;
  for (const std::size_t h : accepted_hits(hits)) {
    if (hits[h].hit.row >= record.rows.size()) return std::nullopt;
    const bool is_one = std::binary_search(which.begin(), which.end(), h);
    (is_one ? own : others).insert(record.rows[hits[h].hit.row].file);
  }
  const bool shared = std::any_of(own.begin(), own.end(), [&](std::size_t file) { return others.contains(file); });
  if (shared || *own.rbegin() >= record.files.size()) return std::nullopt;
  return std::vector<std::size_t>(own.begin(), own.end());
}

// polarity: for all accepted hits or for some of them. If only some are negative, a sign for the whole channel is no
// remedy, because it would reverse the other hits.
Warning negative_force(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                       const HitsWithFinding& negative, const PointNames& names) {
  const std::string down_to = fmt::format("is negative during the pulse, down to {:.4g} N", negative.least);
  if (negative.hits.size() == accepted_hits(hits).size()) {
    Warning all{"polarity",
                fmt::format("the force of {} {}: the FRFs have the wrong sign", hit_list(negative.hits), down_to),
                {"setup", "force_scale"}};
    if (record.force.axis) {  // the set-up of a direction has no sign
      all.options = {"force_scale"};
      return with_remedy(std::move(all),
                         "give the scale of the force the other sign: a pulse is positive along the "
                         "stated direction");
    }
    return with_remedy(std::move(all),
                       R"(state "sign": -1 for the force in the set-up, or remove it where it is stated; or )"
                       "give the scale of the force the other sign");
  }
  Warning warning{"polarity", fmt::format("the force of {} {}, and positive at all other hits: the FRFs have the wrong "
                                          "sign there",
                                          hits_at_points(hits, negative.hits, names), down_to)};
  const auto files = files_of(record, hits, negative.hits);
  if (!files) {
    warning.options = {"reject_hit"};
    return with_remedy(std::move(warning), "multiply the force of these hits by -1 in the data, or reject them");
  }
  warning.options = {"force_scale"};
  const double usual = record.force.to_SI;
  const std::string list = limited_list(files->size(), kMaxFilesInText,
                                        [&](std::size_t i) { return short_file_name(record.files[(*files)[i]].path); });
  return with_remedy(std::move(warning), fmt::format("state the scale of the force in N per stored unit, one value for "
                                                     "each file: {:.6g} for {}, {:.6g} for the others",
                                                     -usual, list, usual));
}

}  // namespace

std::vector<Warning> hit_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                  const PointNames& names, const std::set<std::size_t>& noisy) {
  std::vector<Warning> out;
  const std::size_t rejected = hits.size() - accepted_hits(hits).size();
  if (rejected > 0) {
    out.push_back({"rejected_hits",
                   fmt::format("{} of {} hits not used; each hit's verdict gives the reason", rejected, hits.size())});
  }
  auto poor = accepted_hits_with(hits, acquire::FindingCode::low_coherence, kPoorCoherence);
  std::erase_if(poor.hits, [&](std::size_t h) { return noisy.contains(h); });
  if (!poor.hits.empty()) out.push_back(disagreement(record, hits, poor.hits, names));
  if (const auto negative = accepted_hits_with(hits, acquire::FindingCode::polarity); !negative.hits.empty())
    out.push_back(negative_force(record, hits, negative, names));
  std::vector<double> peaks_N;
  for (const std::size_t h : accepted_hits(hits)) peaks_N.push_back(std::abs(hits[h].hit.peak_N));
  if (!peaks_N.empty() && median(peaks_N) > kMaxForce_N) {
    out.push_back(
        with_remedy({"implausible_force",
                     fmt::format("the hits peak at {:.3g} kN, more than any hammer reaches: FRFs, residues and "
                                 "modal masses have the wrong scale",
                                 1e-3 * median(peaks_N)),
                     {"force_sensitivity", "force_scale", "force_unit"}},
                    "check the unit and the scale of the force"));
  }
  if (const auto low = accepted_hits_with(hits, acquire::FindingCode::low_bandwidth); !low.hits.empty()) {
    out.push_back(with_remedy(
        {"low_bandwidth",
         fmt::format("the force of {} does not reach the end of the band: it has fallen by 20 dB at {:.0f} Hz. Modes "
                     "beyond are weakly excited and less certain",
                     hit_list(low.hits), low.least),
         {"band"}},
        "use a harder tip or a lighter hammer, or narrow the band"));
  }
  return out;
}

std::vector<Warning> refused_hit_warnings(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& accepts,
                                          const std::vector<std::size_t>& rejects) {
  std::vector<std::size_t> refused;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (names_hit(accepts, rejects, h) && !can_be_accepted(hits[h])) refused.push_back(h);
  }
  if (refused.empty()) return {};
  return {with_remedy({"accept_refused",
                       fmt::format("{} cannot be accepted: an FRF is the response over the force, and the force has no "
                                   "pulse there",
                                   hit_list(refused)),
                       {"accept_hit"}},
                      refused.size() == 1 ? "repeat this hit" : "repeat these hits")};
}

std::vector<Warning> rest_warnings(const std::vector<AnalysedHit>& hits, const std::vector<EarlierRinging>& ringing,
                                   const std::vector<Tone>& tones) {
  std::set<std::size_t> moving, subtracted, settled;
  for (const std::size_t h : accepted_hits(hits)) {
    if (may_ring_before(hits[h])) moving.insert(h);
  }
  double share = 0;
  for (const EarlierRinging& one : ringing) {
    if (one.rates.empty()) {
      moving.insert(one.hit);
      continue;
    }
    subtracted.insert(one.hit);
    if (one.explained) settled.insert(one.hit);
    share = std::max(share, one.share);
  }
  std::vector<Warning> out;
  std::vector<std::size_t> left;
  std::set_difference(moving.begin(), moving.end(), settled.begin(), settled.end(), std::back_inserter(left));
  if (!left.empty()) {
    // A harmonic of the mains at a mode cannot be removed, as it cannot be told from the mode.
    const bool hum =
        std::any_of(tones.begin(), tones.end(), [](const Tone& tone) { return may_be_mains(tone.freq_Hz); });
    const std::string cause = hum ? "motion remains before " + hit_list(left) +
                                        " after the hum was removed: the structure was not at rest, or a harmonic of "
                                        "the mains lies at a mode. Damping"
                                  : "the structure was not at rest before " + hit_list(left) + ": damping";
    out.push_back(with_remedy(
        {"not_at_rest", cause + ", residues and modal masses may be off by more than their ±"},
        hum ? "wait longer between hits, and keep cables away from power lines" : "wait longer between hits"));
  }
  if (!subtracted.empty()) {
    out.push_back({"earlier_ringing",
                   fmt::format("the structure still rang when it was hit ({}), with up to {:.2g} % of the largest "
                               "response: this ringing was measured before each hit and subtracted",
                               hit_list({subtracted.begin(), subtracted.end()}), 100 * share)});
  }
  return out;
}

}  // namespace percuss::pipeline
