#include "pipeline/impact_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/units.hpp"
#include "pipeline/hit_deflections.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/impact_speed.hpp"
#include "pipeline/impacts.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/deflection_warnings.hpp"
#include "pipeline/warnings/force_findings.hpp"
#include "pipeline/warnings/lost_sample_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"

namespace percuss::pipeline {
namespace {

using PositionOf = std::function<std::optional<double>(int point)>;

PositionOf positions(const Analysis& analysis, const ImpactTestOptions& options) {
  const std::set<int> points = analysis.record().points();
  if (options.position_m.empty()) return [](int) { return std::optional<double>(); };
  if (options.position_m.size() != points.size()) {
    throw InputError(fmt::format("{} positions for {} points", options.position_m.size(), points.size()),
                     analysis.record().source(), "state one position for each point that was hit", {"positions"});
  }
  std::map<int, double> by_point;
  for (const int point : points) by_point.emplace(point, options.position_m[by_point.size()]);
  return [by_point](int point) { return std::optional<double>(by_point.at(point)); };
}

struct MeanOfHits {
  double value = 0, std = 0;
};

// The mean of the values that are known, and its standard deviation; NaN if none is.
MeanOfHits mean_of(const std::vector<MeanOfHits>& hits) {
  double sum = 0, own = 0, scatter = 0, n = 0;
  for (const MeanOfHits& hit : hits) {
    if (std::isnan(hit.value)) continue;
    sum += hit.value;
    own += hit.std * hit.std;
    ++n;
  }
  const double mean = sum / n;
  for (const MeanOfHits& hit : hits) {
    if (!std::isnan(hit.value)) scatter += std::pow(hit.value - mean, 2);
  }
  const double from_scatter = n > 1 ? std::sqrt(scatter / (n * (n - 1))) : 0;
  return {mean, std::max(std::sqrt(own) / n, from_scatter)};
}

PointDeflection mean_deflection(const std::vector<const metrics::Deflection*>& members) {
  std::vector<MeanOfHits> peaks, forward;
  bool positive = false, negative = false;
  for (const metrics::Deflection* d : members) {
    peaks.push_back({d->peak_m, d->peak_std_m});
    forward.push_back({std::abs(d->forward_m), d->forward_std_m});
    positive = positive || d->peak_m > 0;
    negative = negative || d->peak_m < 0;
  }
  PointDeflection out{.hits = members.size(), .directions_differ = positive && negative};
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const MeanOfHits peak = out.directions_differ ? MeanOfHits{kUnknown, kUnknown} : mean_of(peaks);
  const MeanOfHits first_motion = mean_of(forward);
  out.peak_m = peak.value;
  out.std_m = peak.std;
  out.forward_m = first_motion.value;
  out.forward_std_m = first_motion.std;
  return out;
}

std::vector<PointDeflection> averaged(const std::vector<DeflectedHit>& hits, const PositionOf& position_of) {
  std::map<std::pair<int, std::size_t>, std::vector<const metrics::Deflection*>> groups;
  for (const DeflectedHit& hit : hits) groups[{hit.point, hit.channel}].push_back(&hit.deflection);
  std::vector<PointDeflection> points;
  for (const auto& [key, members] : groups) {
    PointDeflection point = mean_deflection(members);
    point.point = key.first;
    point.channel = key.second;
    point.position_m = position_of(key.first);
    points.push_back(point);
  }
  return points;
}

// lost_samples: the impacts that are not used because they lack samples within their pulse, or too many after it.
std::vector<Warning> left_out_warnings(const std::vector<AnalysedHit>& impacts, const AnalysisOptions& options) {
  std::vector<Warning> out;
  for (std::size_t h = 0; h < impacts.size(); ++h) {
    if (is_usable_impact(impacts[h], options, h)) continue;
    for (const acquire::Finding& finding : impacts[h].hit.findings) {
      if (finding.code != acquire::FindingCode::lost_samples) continue;
      out.push_back({"lost_samples", fmt::format("hit {} is left out: {}", h + 1, finding.message), {"accept_hit"}});
    }
  }
  return out;
}

std::string without_force_remedy(metrics::DeflectionMethod method, bool mass_given) {
  std::string remedy = method == metrics::DeflectionMethod::modal ? "choose another method" : "";
  if (mass_given) remedy += std::string(remedy.empty() ? "" : " and ") + "leave out the effective mass";
  return remedy + ", or name the force's channel";
}

// errors  InputError: the record lacks what the options need, or a response is a pressure.
void require_deflections(const acquire::Record& record, const ImpactTestOptions& options) {
  const metrics::DeflectionMethod method = options.deflection.method;
  if (!record.has_force && (method == metrics::DeflectionMethod::modal || options.effective_mass_kg)) {
    throw InputError("no force was recorded", record.source(),
                     without_force_remedy(method, options.effective_mass_kg.has_value()),
                     {"method", "effective_mass", "force_channel"});
  }
  for (const acquire::SignalInfo& signal : record.accel) {
    if (signal.measures == Quantity::pressure) {
      throw InputError(one_line(signal.name, 40) + " is a pressure: it has no deflection", record.source(),
                       "name the accelerations, or find the modes alone", {"accel_channel"});
    }
  }
}

bool is_accepted_by_user(const AnalysisOptions& options, std::size_t hit) {
  return names_hit(options.accept_hits, options.reject_hits, hit);
}

TestImpacts impacts_of(const Analysis& analysis, const acquire::Record& record, metrics::DeflectionMethod method) {
  const AnalysisOptions& options = analysis.options();
  TestImpacts out{.all = record.has_force ? analysis.force_hits() : impacts_without_force(record)};
  out.clipped_samples = method == metrics::DeflectionMethod::modal
                            ? std::vector<std::size_t>(out.all.size())
                            : clipped_samples_of(record, out.all, options.threads);
  for (std::size_t h = 0; h < out.all.size(); ++h) {
    const bool whole = out.clipped_samples[h] == 0 || is_accepted_by_user(options, h);
    if (whole && is_usable_impact(out.all[h], options, h)) out.used.push_back(h);
  }
  out.rest_recorded = rest_recorded(record.fs_Hz, out.all, out.used);
  out.moving = moves_before(record, out.all, out.used, analysis.options().threads);
  return out;
}

std::vector<Warning> warnings_of(const ImpactTest& test, const TestImpacts& impacts, const Analysis& analysis,
                                 const ImpactTestOptions& options) {
  const ClosedGaps& closed = analysis.closed_gaps();
  DeflectionResults results{.without_pulse = impacts_without_pulse(impacts.all, analysis.options()),
                            .impacts = impacts.all.size(),
                            .rest_recorded = impacts.rest_recorded,
                            .free_body = options.deflection.free_body,
                            .has_force = closed.record.has_force,
                            .mass_known = options.effective_mass_kg.has_value()};
  for (std::size_t i = 0; i < impacts.used.size(); ++i) {
    if (impacts.moving[i]) results.moving.push_back(impacts.used[i]);
  }
  for (std::size_t h = 0; h < impacts.all.size(); ++h) {
    if (impacts.clipped_samples[h] == 0 || !is_usable_impact(impacts.all[h], analysis.options(), h)) continue;
    const bool accepted = is_accepted_by_user(analysis.options(), h);
    (accepted ? results.clipped_used : results.clipped_left_out).push_back({h, impacts.clipped_samples[h]});
  }
  if (!(options.deflection.highpass_corner_Hz > 0)) results.coupling_Hz = coupling_corner_Hz(impacts.all, impacts.used);
  for (const DeflectedHit& hit : test.hits) {
    results.deflections.push_back(
        {hit.hit, &hit.deflection, impacts.all[hit.hit].hit.onset_s - hit.first_s, closed.record.fs_Hz});
  }
  std::vector<Warning> warnings = deflection_warnings(results);
  for (const auto& more : {input_warnings(closed.record), closed_gap_warnings(closed, impacts.all),
                           left_out_warnings(impacts.all, analysis.options())})
    warnings.insert(warnings.end(), more.begin(), more.end());
  return ranked(std::move(warnings));
}

}  // namespace

ImpactTest deflect(const Analysis& analysis, const ImpactTestOptions& options) {
  const PositionOf position_of = positions(analysis, options);
  const acquire::Record& record = analysis.closed_gaps().record;
  require_deflections(record, options);
  const TestImpacts impacts = impacts_of(analysis, record, options.deflection.method);
  const PlaceModes modes = modes_for_deflections(analysis, impacts, options.deflection);
  ImpactTest test{.speeds = impact_speeds(analysis, impacts.all, impacts.used, options)};
  const BudgetScope scope(analysis.budget());
  analysis.trace().run("deflection", [&] {
    test.hits = hit_deflections(analysis, impacts, modes, options);
    return 0;
  });
  for (DeflectedHit& hit : test.hits) hit.position_m = position_of(hit.point);
  test.points = averaged(test.hits, position_of);
  test.warnings = warnings_of(test, impacts, analysis, options);
  return test;
}

}  // namespace percuss::pipeline
