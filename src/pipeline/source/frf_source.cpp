#include "pipeline/source/frf_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "pipeline/source/band.hpp"
#include "pipeline/source/modes_beyond.hpp"

namespace percuss::pipeline {
namespace {

// A band may end this far beyond the last line: tables of 20, 20.25 … 1999.75 Hz are meant to end at 2000 Hz.
constexpr double kBeyond_lines = 1.01;

// [lines] squared magnitude of all FRFs.
std::vector<double> power_of(const acquire::FrfRecord& frfs) {
  std::vector<double> power(frfs.lines.count);
  for (const acquire::PointFrf& one : frfs.frfs) {
    for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(one.frf.value[k]);
  }
  return power;
}

acquire::Record record_without_rows(const acquire::FrfRecord& frfs) {
  acquire::Record record;
  record.files = frfs.files;
  record.format = frfs.format;
  record.fs_Hz = frfs.lines.fs_Hz;
  record.accel = frfs.accel;
  record.notes = frfs.notes;
  record.geometry = frfs.geometry;
  record.trace_lines = frfs.trace_lines;
  record.trace_faces = frfs.trace_faces;
  record.driving = frfs.driving;
  record.motions = frfs.motions;
  record.sensor_roves = frfs.sensor_roves;
  return record;
}

}  // namespace

FrfSource::FrfSource(acquire::FrfRecord frfs) : frfs_(std::move(frfs)), record_(record_without_rows(frfs_)) {}

std::set<int> FrfSource::points() const {
  std::set<int> points;
  for (const acquire::PointFrf& frf : frfs_.frfs) points.insert(frf.point);
  return points;
}

std::pair<double, double> FrfSource::default_band_Hz(const std::vector<AnalysedHit>& /*hits*/) const {
  const acquire::LineRange& all = frfs_.lines;
  const double high_Hz = all.freq_Hz(all.count - 1);
  return {std::max(all.freq_Hz(0), default_low_Hz(high_Hz)), high_Hz};
}

LineChoice FrfSource::choose_lines(const LineRequest& request, const std::vector<AnalysedHit>& /*hits*/,
                                   Trace& /*trace*/) const {
  const acquire::LineRange& all = frfs_.lines;
  const auto [low_Hz, high_Hz] = request.band_Hz;
  const double top_Hz = all.freq_Hz(all.count - 1);
  if (!(low_Hz < high_Hz) || low_Hz < 0 || high_Hz > top_Hz + kBeyond_lines * all.df_Hz() || low_Hz > top_Hz) {
    throw InputError(fmt::format("the band {:.6g}:{:.6g} Hz does not fit FRFs from {:.6g} to {:.6g} Hz", low_Hz,
                                 high_Hz, all.freq_Hz(0), top_Hz),
                     record_.source(), "choose LO:HI within this range", {"band"});
  }
  const auto [from_Hz, to_Hz] = band_with_margin(low_Hz, high_Hz);
  const double end_Hz = end_past_modes(std::min(to_Hz, top_Hz), request.band_Hz, all, power_of(frfs_));
  acquire::LineRange lines = frf::lines_in_band(all.fs_Hz, all.samples, from_Hz, end_Hz);
  const std::size_t end = std::min(lines.first + lines.count, all.first + all.count);
  lines.first = std::max(lines.first, all.first);
  lines.count = end > lines.first ? end - lines.first : 0;
  require_lines(lines, low_Hz, high_Hz, record_.source(), "widen the band");
  return {.lines = lines, .end_Hz = lines.freq_Hz(lines.count - 1)};
}

std::vector<FrfGroup> FrfSource::groups(const std::vector<AnalysedHit>& /*hits*/) const {
  std::vector<FrfGroup> groups;
  groups.reserve(frfs_.frfs.size());
  for (const acquire::PointFrf& frf : frfs_.frfs)
    groups.push_back({.index = groups.size(), .point = frf.point, .channel = frf.channel, .hits = {}});
  return groups;
}

acquire::PointFrf FrfSource::frf(const FrfGroup& group, const TestSpectra& spectra,
                                 frf::Estimator /*estimator*/) const {
  const acquire::PointFrf& given = frfs_.frfs[group.index];
  const std::size_t first = spectra.lines.first - frfs_.lines.first;
  return {.point = group.point,
          .channel = group.channel,
          .frf = acquire::lines_within(given.frf, first, spectra.lines.count)};
}

identify::FrfDataset FrfSource::dataset(const TestSpectra& spectra, const std::vector<std::size_t>& /*hits*/,
                                        const std::vector<acquire::PointFrf>* /*averages*/) const {
  const acquire::LineRange& lines = spectra.lines;
  identify::FrfDataset set{.lines = lines};
  std::optional<int> point;
  for (const acquire::PointFrf& frf : frfs_.frfs) {
    if (frf.point != point) {
      set.points.emplace_back();  // of the force only the window is known
      if (frfs_.decay_per_s > 0) set.points.back().blocks.push_back({.decay_per_s = frfs_.decay_per_s});
    }
    point = frf.point;
    set.channels.push_back({.point = set.points.size() - 1,
                            .channel = frf.channel,
                            .frf = acquire::lines_within(frf.frf.value, lines.first - frfs_.lines.first, lines.count)});
  }
  return set;
}

}  // namespace percuss::pipeline
