#include "pipeline/source/record_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/source/band.hpp"
#include "pipeline/source/modes_beyond.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kAntiAlias = 0.44;  // of fs: above it a recorder's filter shapes the FRF
// Samples. In longer rows, and in those with several hits, the end of the decay is searched first; that costs less than
// transforming everything.
constexpr std::size_t kLongRow = std::size_t{1} << 17U;
constexpr double kMinLowEnd = 1e-3;  // of the high end of the band: decays at lower lines show only in long segments
constexpr double kUsableBandwidthFactor = 1.2;  // of the −20 dB bandwidth: limit of the margin

// Hits are ascending by row.
bool any_row_has_several(const std::vector<AnalysedHit>& hits) {
  return std::adjacent_find(hits.begin(), hits.end(), [](const AnalysedHit& a, const AnalysedHit& b) {
           return a.hit.row == b.hit.row;
         }) != hits.end();
}

}  // namespace

RecordSource::RecordSource(acquire::Record record) : record_(std::move(record)) {
  if (record_.accel.empty())
    throw InputError("no acceleration channel", record_.source(), "name one", {"accel_channel"});
}

std::vector<acquire::Hit> RecordSource::find_hits(const acquire::HitOptions& options) const {
  return acquire::find_hits(record_, options);
}

void RecordSource::require_accepted(const std::vector<AnalysedHit>& hits) const {
  if (any_accepted(hits)) return;
  if (can_accept_more(hits)) {
    throw InputError("no hit can be used", record_.source(), "see the hits' findings, or accept a hit despite them",
                     {"accept_hit"});
  }
  const bool pulses =
      std::any_of(hits.begin(), hits.end(), [](const AnalysedHit& hit) { return can_be_accepted(hit); });
  throw InputError(pulses ? "no hit can be used" : "no hit has a pulse of the force", record_.source(),
                   "see the hits' findings");
}

std::pair<double, double> RecordSource::default_band_Hz(const std::vector<AnalysedHit>& hits) const {
  std::vector<double> bandwidth_Hz;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted) bandwidth_Hz.push_back(hit.hit.bandwidth_Hz);
  }
  double high_Hz = kAntiAlias * record_.fs_Hz;
  if (!bandwidth_Hz.empty()) high_Hz = std::min(median(bandwidth_Hz), high_Hz);
  return {default_low_Hz(high_Hz), high_Hz};
}

// The common length of the hits' transforms.
std::size_t RecordSource::block_samples(const LineRequest& request, const std::vector<AnalysedHit>& hits,
                                        Trace& trace) const {
  const std::size_t samples = common_samples(record_, hits, request.missing_samples);
  const bool searched = record_.continuous || record_.rows.size() == 1;
  const bool whole = samples < kLongRow && !(searched && any_row_has_several(hits));
  if (!searched && whole) return samples;
  if (whole || request.length_given) return fast_length_at_most(samples);
  const auto [low_Hz, high_Hz] = request.band_Hz;
  const acquire::RelativeBand band{std::max(low_Hz, kMinLowEnd * high_Hz) / record_.fs_Hz, high_Hz / record_.fs_Hz};
  return fast_length_at_most(longest_decay_samples(record_, hits, samples, band, request.threads, trace));
}

void RecordSource::require_band(const LineRequest& request) const {
  const auto [low_Hz, high_Hz] = request.band_Hz;
  if (!request.band_given && !(low_Hz < high_Hz)) {
    throw InputError("the force shows no bandwidth, so the band has no default", record_.source(),
                     "check the force's channel, unit and scale, or state the band", {"band"});
  }
  pipeline::require_band(request.band_Hz, record_.fs_Hz, record_.source());
}

LineChoice RecordSource::choose_lines(const LineRequest& request, const std::vector<AnalysedHit>& hits,
                                      Trace& trace) const {
  require_accepted(hits);
  require_band(request);
  const std::size_t samples = block_samples(request, hits, trace);
  double bandwidth_Hz = 0;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted) bandwidth_Hz = std::max(bandwidth_Hz, hit.hit.bandwidth_Hz);
  }
  const auto [low_Hz, high_Hz] = request.band_Hz;
  const auto [from_Hz, to_Hz] = band_with_margin(low_Hz, high_Hz);
  const double limit_Hz = std::min(kUsableBandwidthFactor * bandwidth_Hz, kAntiAlias * record_.fs_Hz);
  const double end_Hz = std::max(high_Hz, std::min(to_Hz, limit_Hz));
  const double furthest_Hz = std::max(end_Hz, std::min(furthest_end_Hz(end_Hz, request.band_Hz), limit_Hz));
  require_lines(frf::lines_in_band(record_.fs_Hz, samples, from_Hz, end_Hz), low_Hz, high_Hz, record_.source(),
                "record longer or widen the band");
  return {.lines = frf::lines_in_band(record_.fs_Hz, samples, from_Hz, furthest_Hz), .end_Hz = end_Hz};
}

std::vector<FrfGroup> RecordSource::groups(const std::vector<AnalysedHit>& hits) const {
  require_accepted(hits);
  return frf_groups(hits, record_.accel.size());
}

acquire::PointFrf RecordSource::frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator) const {
  return average_frf(group, spectra, estimator);
}

identify::FrfDataset RecordSource::dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits,
                                           const std::vector<acquire::PointFrf>* averages) const {
  if (hits.empty()) throw InputError("no hit can be used", record_.source(), "see the hits' findings");
  return h1_dataset(spectra, hits, record_.accel.size(), averages);
}

}  // namespace percuss::pipeline
