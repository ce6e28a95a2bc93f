#include "pipeline/warnings/used_hit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/math/statistics.hpp"
#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

using acquire::FindingCode;

constexpr double kShort = 0.8;          // of the median hit
constexpr double kDecides = 0.9;        // of the shortest hit: shorter transforms have another cause
constexpr std::size_t kMaxPoints = 20;  // in a sentence

struct UsedInSpite {
  std::vector<std::size_t> hits;
  double largest = 0;
};

UsedInSpite used_in_spite_of(const std::vector<AnalysedHit>& hits, FindingCode code) {
  UsedInSpite out;
  for (const std::size_t h : accepted_hits(hits)) {
    if (code == FindingCode::double_hit && hits[h].by_user) continue;  // the user's own decision
    for (const acquire::Finding& finding : hits[h].hit.findings) {
      if (finding.code != code || finding.severity == acquire::Severity::info) continue;
      out.hits.push_back(h);
      out.largest = std::max(out.largest, finding.value);
    }
  }
  return out;
}

std::vector<int> dropped_points(const std::vector<AnalysedHit>& hits) {
  std::map<int, bool> used;
  for (const AnalysedHit& hit : hits) used[hit.point] = used[hit.point] || hit.accepted;
  std::vector<int> out;
  for (const auto& [point, any] : used) {
    if (!any) out.push_back(point);
  }
  return out;
}

void add_short_hit(std::vector<Warning>& out, const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                   std::size_t samples) {
  std::vector<double> lengths;
  std::size_t shortest = 0;
  const std::vector<std::size_t> used = accepted_hits(hits);
  for (const std::size_t h : used) {
    lengths.push_back(static_cast<double>(hits[h].hit.samples));
    if (lengths.size() == 1 || hits[h].hit.samples < hits[shortest].hit.samples) shortest = h;
  }
  const auto least = static_cast<double>(hits[shortest].hit.samples);
  const double typical = median(lengths);
  if (least >= kShort * typical || static_cast<double>(samples) < kDecides * least) return;
  const std::size_t file = record.rows[hits[shortest].hit.row].file;
  const std::string where =
      record.files.size() > 1 ? " of " + one_line(record.files[file].path, kMaxNameBytes) : std::string();
  out.push_back(with_remedy({"short_hit",
                             fmt::format("hit {}{} lasts {:.3g} s, the others {:.3g} s: every FRF is cut to its "
                                         "length, which costs resolution and makes damping less certain",
                                         shortest + 1, where, least / record.fs_Hz, typical / record.fs_Hz),
                             {"reject_hit"}},
                            "leave this hit out or record it again"));
}

}  // namespace

std::vector<Warning> used_hit_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       std::size_t samples, const PointNames& names) {
  std::vector<Warning> out;
  if (!any_accepted(hits)) return out;
  if (const UsedInSpite clipped = used_in_spite_of(hits, FindingCode::force_clipped); !clipped.hits.empty()) {
    out.push_back(with_remedy(
        {"force_clipped",
         fmt::format(
             "the force of {} was clipped before the recorder's filter (flat tops: the pulse at 80 % "
             "of its peak is {:.0f} % as long as at 30 %; without clipping, at most about 50 %): frequencies and "
             "damping hold, but FRFs, residues and masses are off by several percent or more",
             hit_list(clipped.hits), clipped.largest * 100)},
        "lower the gain of the hammer's amplifier or hit softer"));
  }
  if (const UsedInSpite twice = used_in_spite_of(hits, FindingCode::double_hit); !twice.hits.empty()) {
    out.push_back(with_remedy(
        {"double_hits_used",
         fmt::format("{}: a second contact, up to {:.1f} % of the main one; used all the same, because too few other "
                     "hits are at the same point. The force holds both contacts, but its spectrum is uneven",
                     hit_list(twice.hits), twice.largest * 100)},
        "repeat the hits of these points"));
  }
  if (const std::vector<int> points = dropped_points(hits); !points.empty()) {
    Warning warning{
        "dropped_points",
        fmt::format("no hit can be used at {}: FRFs and shapes lack {}. Each hit's verdict gives the reason",
                    names.list(points, kMaxPoints), points.size() == 1 ? "it" : "them")};
    const bool acceptable = std::any_of(hits.begin(), hits.end(), [&](const AnalysedHit& hit) {
      return can_be_accepted(hit) && !lacks_samples_of_pulse(hit) &&
             std::binary_search(points.begin(), points.end(), hit.point);
    });
    if (acceptable) warning.options = {"accept_hit"};
    out.push_back(with_remedy(std::move(warning), acceptable ? "repeat these hits, or accept one despite its findings"
                                                             : "repeat these hits"));
  }
  add_short_hit(out, record, hits, samples);
  return out;
}

}  // namespace percuss::pipeline
