#include "report/frf_files.hpp"

#include "acquire/formats/text/write_frf_csv.hpp"

namespace percuss::report {

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
    out.frfs.push_back(
        {.point = frf.point, .channel = frf.channel, .frf = acquire::lines_within(frf.frf, first, band.count)});
  }
  return out;
}

std::string frf_csv(const pipeline::Analysis& analysis, acquire::FrfKind kind) {
  return acquire::frf_record_csv(frf_record_of(analysis), kind);
}

}  // namespace percuss::report
