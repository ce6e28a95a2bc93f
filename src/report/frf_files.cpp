#include "report/frf_files.hpp"

#include <algorithm>

#include "acquire/formats/hdf5/write_frf_hdf5.hpp"
#include "acquire/formats/text/write_frf_csv.hpp"
#include "acquire/write_record.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::report {
namespace {

template <class Value>
std::vector<Value> lines_within(const std::vector<Value>& all, std::size_t first, std::size_t count) {
  if (all.empty()) return {};
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

acquire::FrfRecord frf_record_of(const pipeline::Analysis& analysis) {
  const acquire::LineRange& lines = analysis.lines();
  const acquire::LineRange band = analysis.band_lines();
  acquire::FrfRecord out;
  out.files = analysis.record().files;
  out.format = analysis.record().format;
  out.lines = band;
  out.accel = analysis.record().accel;
  out.geometry = analysis.record().geometry;
  out.trace_lines = analysis.record().trace_lines;
  out.trace_faces = analysis.record().trace_faces;
  out.decay_per_s = analysis.window_decay_per_s();
  const acquire::FrfRecord* const given = analysis.given_frfs();
  out.estimator = given != nullptr ? given->estimator : name_of(analysis.options().estimator);
  const std::size_t first = band.first - lines.first;
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    out.frfs.push_back({.point = frf.point, .channel = frf.channel, .frf = {}});
    out.frfs.back().frf = {.value = lines_within(frf.frf.value, first, band.count),
                           .std = lines_within(frf.frf.std, first, band.count),
                           .coherence = lines_within(frf.frf.coherence, first, band.count),
                           .averages = frf.frf.averages};
  }
  return out;
}

void write_frfs(const std::string& path, const acquire::FrfRecord& record, acquire::FrfKind kind, bool force) {
  acquire::write_frfs(path, record, kind, force);
}

std::string frf_csv(const pipeline::Analysis& analysis, acquire::FrfKind kind) {
  return acquire::frf_record_csv(frf_record_of(analysis), kind);
}

void write_frf_csv(const std::string& path, const pipeline::Analysis& analysis, acquire::FrfKind kind, bool force) {
  write_file(path, frf_csv(analysis, kind), force);
}

void write_frf_hdf5(const std::string& path, const pipeline::Analysis& analysis, acquire::FrfKind kind, bool force) {
  acquire::write_frf_record_hdf5(path, frf_record_of(analysis), kind, force);
}

}  // namespace percuss::report
