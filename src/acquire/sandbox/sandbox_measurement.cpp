#include "acquire/sandbox/sandbox_measurement.hpp"

#include <cmath>
#include <memory>

#include "acquire/record/point_number.hpp"
#include "acquire/sandbox/file_access.hpp"
#include "acquire/sandbox/sandbox_record.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

enum class MeasurementKind : std::uint64_t { record, frfs };

void serialize_frf_record(Serializer& out, const FrfRecord& record) {
  out.put(record.files.front().path);
  out.put(record.files.front().bytes);
  out.put(record.format);
  out.put(record.kind);
  out.put(record.lines);
  out.put(static_cast<std::uint64_t>(record.accel.size()));
  for (const SignalInfo& signal : record.accel) serialize_signal(out, signal);
  for (const SignalInfo& signal : record.accel) serialize_axis(out, signal.axis);
  out.put(record.estimator);
  serialize_geometry(out, record.geometry);
  out.put_all(record.trace_lines);
  out.put(static_cast<std::uint64_t>(record.motions.size()));
  for (const PointMotion& motion : record.motions) {  // of struck points; sensor_roves is never set in the sandbox
    out.put(motion.point);
    out.put(motion.place);
    serialize_axis(out, motion.along);
  }
  out.put(record.decay_per_s);
  serialize_notes(out, record.notes);
  serialize_faces(out, record.trace_faces);
  serialize_driving(out, record.driving);
  out.put(static_cast<std::uint64_t>(record.frfs.size()));
  for (const PointFrf& frf : record.frfs) {
    out.put(frf.point);
    out.put(static_cast<std::uint64_t>(frf.channel));
    out.put_all(frf.frf.value);
    out.put_all(frf.frf.std);
    out.put_all(frf.frf.coherence);
    out.put(static_cast<std::uint64_t>(frf.frf.averages));
  }
}

FrfRecord deserialize_frf_record(Deserializer& in) {
  FrfRecord record;
  std::string path = in.text();
  record.files.push_back({.path = std::move(path), .bytes = in.get<std::uint64_t>()});
  record.format = in.text();
  record.kind = in.get<FrfKind>();
  record.lines = in.get<LineRange>();
  const std::size_t channels = in.count(5 * sizeof(double));
  for (std::size_t c = 0; c < channels; ++c) record.accel.push_back(deserialize_signal(in));
  for (SignalInfo& signal : record.accel) signal.axis = deserialize_axis(in);
  record.estimator = in.text();
  record.geometry = deserialize_geometry(in);
  record.trace_lines = in.all<TraceLine>();
  const std::size_t motions = in.count(2 * sizeof(int) + 3 * sizeof(double));
  for (std::size_t i = 0; i < motions; ++i) {
    const int point = in.get<int>(), place = in.get<int>();
    record.motions.push_back({.point = point, .place = place, .along = deserialize_axis(in)});
  }
  record.decay_per_s = in.get<double>();
  record.notes = deserialize_notes(in);
  record.trace_faces = deserialize_faces(in);
  record.driving = deserialize_driving(in);
  const std::size_t frfs = in.count(5 * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < frfs; ++i) {
    PointFrf frf;
    frf.point = in.get<int>();
    frf.channel = in.get<std::uint64_t>();
    frf.frf.value = in.all<Complex>();
    frf.frf.std = in.all<double>();
    frf.frf.coherence = in.all<double>();
    frf.frf.averages = in.get<std::uint64_t>();
    record.frfs.push_back(std::move(frf));
  }
  return record;
}

bool is_frf_kind(FrfKind kind) {
  return kind == FrfKind::accelerance || kind == FrfKind::mobility || kind == FrfKind::receptance;
}

// The invariants that the other layers rely on. The child may be compromised.
bool plausible_frfs(const FrfRecord& record) {
  const std::size_t lines = record.lines.count;
  const double df_Hz = record.lines.samples > 0 ? record.lines.df_Hz() : 0;
  bool valid = lines > 1 && !record.frfs.empty() && !record.accel.empty() && df_Hz > 0 && std::isfinite(df_Hz) &&
               record.lines.first < kMaxFrfLines && is_frf_kind(record.kind) && plausible_geometry(record) &&
               plausible_driving(record.driving, record.accel.size());
  for (const PointMotion& motion : record.motions)
    valid = valid && is_point_number(motion.point) && is_point_number(motion.place);
  for (const PointFrf& frf : record.frfs) {
    const auto fits = [&](std::size_t size) { return size == 0 || size == lines; };
    valid = valid && is_point_number(frf.point) && frf.channel < record.accel.size() && frf.frf.value.size() == lines &&
            fits(frf.frf.std.size()) && fits(frf.frf.coherence.size());
  }
  return valid && record.frfs.size() % record.accel.size() == 0;
}

void note_missing_confinement(std::vector<Message>& notes) {
  if (can_restrict_files()) return;
  notes.emplace_back("this system (no Landlock) does not keep the reader of the file from opening other files");
}

}  // namespace

SandboxService measurement_service(Measurement opened) {
  Serializer out;
  if (const auto* frfs = std::get_if<FrfRecord>(&opened)) {
    out.put(MeasurementKind::frfs);
    serialize_frf_record(out, *frfs);
    return {.description = out.bytes(), .read = {}};
  }
  out.put(MeasurementKind::record);
  SandboxService service = record_service(std::move(std::get<Record>(opened)));
  service.description = out.bytes() + service.description;
  return service;
}

Measurement sandboxed_measurement(const std::shared_ptr<SandboxProcess>& process) {
  Deserializer in(process->description());
  try {
    if (in.get<MeasurementKind>() == MeasurementKind::record) {
      Record record = sandboxed_record(in, process);
      note_missing_confinement(record.notes);
      return record;
    }
    FrfRecord frfs = deserialize_frf_record(in);
    frfs.files.front() = {.path = process->path(), .bytes = process->file_bytes()};
    note_missing_confinement(frfs.notes);
    if (plausible_frfs(frfs)) return frfs;
  } catch (const std::out_of_range&) {
  }
  process->report_contradiction();
}

Measurement open_in_sandbox(const std::string& path, const std::function<Measurement()>& open) {
  return sandboxed_measurement(std::make_shared<SandboxProcess>(path, [&] { return measurement_service(open()); }));
}

}  // namespace percuss::acquire
