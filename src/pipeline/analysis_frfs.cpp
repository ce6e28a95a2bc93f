// A test of which only the FRFs are left.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/analysis_band.hpp"

namespace percuss::pipeline {
namespace {

acquire::Record described(const frf::FrfRecord& frfs) {
  acquire::Record record;
  record.files = frfs.files;
  record.format = frfs.format;
  record.fs_Hz = frfs.lines.fs_Hz;
  record.accel = frfs.accel;
  record.notes = frfs.notes;
  record.geometry = frfs.geometry;
  record.trace_lines = frfs.trace_lines;
  return record;
}

template <class Value>
std::vector<Value> part_of(const std::vector<Value>& all, std::size_t first, std::size_t count) {
  if (all.empty()) return {};
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

Analysis::Analysis(frf::FrfRecord frfs, AnalysisOptions options)
    : record_(described(frfs)), given_(std::move(frfs)), options_(std::move(options)) {
  const auto refuse = [&](const char* option) {
    throw InputError(std::string(option) + " needs records of time, not FRFs", record_.source(), "leave it out");
  };
  if (options_.exponential_end > 0) refuse("--exponential");
  if (options_.estimator != frf::Estimator::h1) refuse("--estimator");
}

std::pair<double, double> Analysis::given_band_Hz() const {
  const frf::LineRange& all = given_->lines;
  const double high = all.freq_Hz(all.count - 1);
  return {std::max(all.freq_Hz(0), default_low_Hz(high)), high};
}

frf::LineRange Analysis::given_lines() const {
  const frf::LineRange& all = given_->lines;
  const auto [low, high] = band_Hz();
  const double top = all.freq_Hz(all.count - 1);
  if (!(low < high) || low < 0 || high > top + 0.5 * all.df_Hz() || low > top) {
    throw InputError(fmt::format("the band {:.6g}:{:.6g} Hz does not fit FRFs from {:.6g} to {:.6g} Hz", low, high,
                                 all.freq_Hz(0), top),
                     "--band", "give LO:HI within them");
  }
  const auto [from, to] = band_with_margin(low, high);
  frf::LineRange lines = frf::lines_in_band(all.fs_Hz, all.samples, from, std::min(to, top));
  const std::size_t end = std::min(lines.first + lines.count, all.first + all.count);
  lines.first = std::max(lines.first, all.first);
  lines.count = end > lines.first ? end - lines.first : 0;
  require_lines(lines, low, high, record_.source(), "widen --band");
  return lines;
}

std::vector<frf::PointFrf> Analysis::given_within_lines() const {
  const std::size_t first = lines().first - given_->lines.first;
  const std::size_t count = lines().count;
  std::vector<frf::PointFrf> out;
  for (const frf::PointFrf& all : given_->frfs) {
    out.push_back({.point = all.point,
                   .channel = all.channel,
                   .frf = {.value = part_of(all.frf.value, first, count),
                           .std = part_of(all.frf.std, first, count),
                           .coherence = part_of(all.frf.coherence, first, count),
                           .averages = all.frf.averages}});
  }
  return out;
}

identify::FrfDataset Analysis::given_set() const {
  identify::FrfDataset set{.lines = lines()};
  std::optional<int> point;
  for (const frf::PointFrf& frf : frfs()) {
    if (frf.point != point) {
      set.points.emplace_back();  // nothing is known of the force but its window
      if (given_->decay_per_s > 0) set.points.back().blocks.push_back({.decay_per_s = given_->decay_per_s});
    }
    point = frf.point;
    set.channels.push_back({.point = set.points.size() - 1, .channel = frf.channel, .frf = frf.frf.value});
  }
  return set;
}

void Analysis::warn_of_freq_scatter(std::vector<Warning>& out) const {
  if (!modes_.ready()) return;
  std::string moving;
  for (const identify::Mode& mode : modes()) {
    if (mode.freq_scatter_Hz > 0)
      moving += fmt::format("{}{:.1f} Hz (by {:.2g} Hz)", moving.empty() ? "" : ", ", mode.pole.freq_Hz,
                            mode.freq_scatter_Hz);
  }
  if (moving.empty()) return;
  out.push_back({"moving_modes", "resonances that move from point to point: " + moving +
                                     ". Means over the points are quoted, and their ± counts the moving. Possible "
                                     "causes: temperature, the strength of the blows, a sensor that was moved"});
}

}  // namespace percuss::pipeline
