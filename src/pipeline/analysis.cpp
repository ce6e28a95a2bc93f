#include "pipeline/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/windows.hpp"
#include "pipeline/analysis_band.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kAntiAlias = 0.44;  // of fs: above it a recorder's filter shapes the FRF
// Samples: a row so long is looked through for the end of its decay first, which costs less than the lines that are
// saved.
constexpr std::size_t kLongRow = std::size_t{1} << 17U;
constexpr double kUsableBandwidthFactor = 1.2;  // of the −20 dB bandwidth: as far as a margin may go

bool listed(const std::vector<std::size_t>& list, std::size_t i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

void check_numbers(const std::vector<std::size_t>& list, std::size_t hits, const char* option) {
  for (const std::size_t i : list) {
    if (i < hits) continue;
    throw InputError(fmt::format("there is no hit {} among {} hits", i, hits), option,
                     "hits count from 0, as in the report");
  }
}

}  // namespace

Analysis::Analysis(acquire::Record record, AnalysisOptions options)
    : record_(std::move(record)), options_(std::move(options)) {
  if (record_.accel.empty())
    throw InputError("no acceleration channel", record_.source(), "name one with --accel-channel");
}

const std::vector<AnalysedHit>& Analysis::force_hits() const {
  return force_hits_.get([&] { return trace_.run("hits", [&] { return find(); }); });
}

std::vector<AnalysedHit> Analysis::find() const {
  const ThreadLimit limit(options_.threads);
  auto found = given_ ? std::vector<acquire::Hit>{} : acquire::find_hits(record_, options_.hits);
  check_numbers(options_.accept_hits, found.size(), "--accept-hit");
  check_numbers(options_.reject_hits, found.size(), "--reject-hit");
  if (options_.band_Hz) acquire::grade_bandwidth(found, options_.band_Hz->second);
  std::vector<AnalysedHit> hits;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool usable = !found[i].gated_N.empty();
    const bool accept = listed(options_.accept_hits, i) && usable;
    const bool reject = listed(options_.reject_hits, i);
    AnalysedHit hit{
        .hit = std::move(found[i]), .point = 0, .accepted = false, .by_user = accept || reject, .responses = {}};
    hit.point = record_.rows[hit.hit.row].point;
    hit.accepted = accept || (!reject && !acquire::rejects(hit.hit.findings));
    hits.push_back(std::move(hit));
  }
  return hits;
}

std::set<int> Analysis::points() const {
  std::set<int> out = record_.points();
  if (given_) {
    for (const frf::PointFrf& frf : given_->frfs) out.insert(frf.point);
  }
  return out;
}

bool Analysis::possible() const {
  if (given_) return true;
  const auto& all = hits_.ready() ? hits() : force_hits();
  return std::any_of(all.begin(), all.end(), [](const AnalysedHit& hit) { return hit.accepted; });
}

std::pair<double, double> Analysis::band_Hz() const {
  if (options_.band_Hz) return *options_.band_Hz;
  if (given_) return given_band_Hz();
  std::vector<double> reach;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) reach.push_back(hit.hit.bandwidth_Hz);
  }
  const double high = reach.empty() ? kAntiAlias * record_.fs_Hz : std::min(median(reach), kAntiAlias * record_.fs_Hz);
  return {default_low_Hz(high), high};
}

const frf::LineRange& Analysis::lines() const {
  return lines_.get([&] { return given_ ? given_lines() : choose_lines(); });
}

std::size_t Analysis::block_samples() const {
  std::size_t samples = 0;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) samples = samples == 0 ? hit.hit.samples : std::min(samples, hit.hit.samples);
  }
  if (samples == 0)
    throw InputError("no hit can be used", record_.source(), "see the hits' findings; --accept-hit overrules them");
  const bool searched = record_.continuous || record_.rows.size() == 1;
  if (!searched && samples < kLongRow) return samples;
  if (!options_.hits.length_s) samples = std::min(samples, longest_decay());
  return fast_length_at_most(samples);
}

frf::LineRange Analysis::choose_lines() const {
  const std::size_t samples = block_samples();
  double reach = 0;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) reach = std::max(reach, hit.hit.bandwidth_Hz);
  }
  const auto [low, high] = band_Hz();
  if (!options_.band_Hz && !(low < high)) {
    throw InputError("the force shows no bandwidth, from which the band would follow", record_.source(),
                     "check the force's channel, unit and scale, or give --band LO:HI");
  }
  if (!(low < high) || low < 0 || high > record_.fs_Hz / 2) {
    throw InputError(
        fmt::format("the band {:.6g}:{:.6g} Hz does not fit a sampling rate of {:.6g} Hz", low, high, record_.fs_Hz),
        "--band", "give LO:HI with LO < HI <= half the sampling rate");
  }
  const auto [from, to] = band_with_margin(low, high);
  const double top = std::max(high, std::min({to, kUsableBandwidthFactor * reach, kAntiAlias * record_.fs_Hz}));
  const frf::LineRange range = frf::lines_in_band(record_.fs_Hz, samples, from, top);
  require_lines(range, low, high, record_.source(), "record longer or widen --band");
  return range;
}

double Analysis::window_decay_per_s() const {
  if (given_) return given_->decay_per_s;
  if (!(options_.exponential_end > 0)) return 0;
  return frf::decay_for_end(options_.exponential_end, static_cast<double>(lines().samples) / record_.fs_Hz);
}

std::vector<std::size_t> Analysis::accepted_hits() const {
  std::vector<std::size_t> list;
  if (given_) return list;
  for (std::size_t h = 0; h < hits().size(); ++h) {
    if (hits()[h].accepted) list.push_back(h);
  }
  if (!list.empty()) return list;
  throw InputError("no hit can be used", record_.source(), "see the hits' findings; --accept-hit overrules them");
}

std::vector<std::pair<int, acquire::Record>> split_runs(const acquire::Record& record) {
  std::map<int, bool> runs;
  for (const acquire::RowInfo& row : record.rows) runs[row.run] = true;
  std::vector<std::pair<int, acquire::Record>> out;
  out.reserve(runs.size());
  for (const auto& [run, present] : runs) {
    out.emplace_back(run,
                     acquire::select_rows(record, [run = run](const acquire::RowInfo& row) { return row.run == run; }));
  }
  return out;
}

}  // namespace percuss::pipeline
