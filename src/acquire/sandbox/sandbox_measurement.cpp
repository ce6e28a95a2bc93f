#include "frf/formats/sandbox_measurement.hpp"

#include <memory>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/sandbox/fork_server.hpp"
#include "acquire/sandbox/sandbox_record.hpp"
#include "core/error.hpp"

namespace percuss::frf {
namespace {

enum class Kind : std::uint64_t { record, frfs };

void serialize_frf_record(acquire::Serializer& out, const FrfRecord& record) {
  out.put(record.files.front().path);
  out.put(record.files.front().bytes);
  out.put(record.format);
  out.put(record.kind);
  out.put(record.lines);
  out.put(static_cast<std::uint64_t>(record.accel.size()));
  for (const acquire::SignalInfo& signal : record.accel) acquire::serialize_signal(out, signal);
  out.put(record.estimator);
  acquire::serialize_geometry(out, record.geometry);
  out.put_all(record.trace_lines);
  out.put(record.decay_per_s);
  acquire::serialize_strings(out, record.notes);
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

FrfRecord deserialize_frf_record(acquire::Deserializer& in) {
  FrfRecord record;
  std::string path = in.text();
  record.files.push_back({.path = std::move(path), .bytes = in.get<std::uint64_t>()});
  record.format = in.text();
  record.kind = in.get<FrfKind>();
  record.lines = in.get<LineRange>();
  const std::size_t channels = in.count(5 * sizeof(double));
  for (std::size_t c = 0; c < channels; ++c) record.accel.push_back(acquire::deserialize_signal(in));
  record.estimator = in.text();
  record.geometry = acquire::deserialize_geometry(in);
  record.trace_lines = in.all<acquire::TraceLine>();
  record.decay_per_s = in.get<double>();
  record.notes = acquire::deserialize_strings(in);
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

// What the rest of percuss relies on.
bool plausible_frfs(const FrfRecord& record) {
  const std::size_t lines = record.lines.count;
  bool good = lines > 1 && !record.frfs.empty() && !record.accel.empty() && record.lines.df_Hz() > 0;
  for (const PointFrf& frf : record.frfs) {
    const auto fits = [&](std::size_t size) { return size == 0 || size == lines; };
    good = good && frf.channel < record.accel.size() && frf.frf.value.size() == lines && fits(frf.frf.std.size()) &&
           fits(frf.frf.coherence.size());
  }
  return good && record.frfs.size() % record.accel.size() == 0;
}

acquire::SandboxService measurement_service(std::variant<acquire::Record, FrfRecord> opened) {
  acquire::Serializer out;
  if (const auto* frfs = std::get_if<FrfRecord>(&opened)) {
    out.put(Kind::frfs);
    serialize_frf_record(out, *frfs);
    return {.description = out.bytes(), .read = {}};
  }
  out.put(Kind::record);
  acquire::SandboxService service = acquire::record_service(std::move(std::get<acquire::Record>(opened)));
  service.description = out.bytes() + service.description;
  return service;
}

std::variant<acquire::Record, FrfRecord> serve_measurement(const std::shared_ptr<acquire::SandboxProcess>& process) {
  acquire::Deserializer in(process->description());
  try {
    if (in.get<Kind>() == Kind::record) return acquire::sandboxed_record(in, process);
    FrfRecord frfs = deserialize_frf_record(in);
    if (plausible_frfs(frfs)) return frfs;
  } catch (const std::out_of_range&) {
  }
  process->report_contradiction();
}

}  // namespace

bool needs_sandbox(const std::string& path) {
  constexpr std::size_t kHead_bytes = 4096;
  const std::string head = first_bytes(path, kHead_bytes);
  return acquire::is_mat(head) || acquire::is_sound(head) || acquire::is_hdf5(path);
}

std::variant<acquire::Record, FrfRecord> open_measurement_sandboxed(
    const std::string& path, const std::function<std::variant<acquire::Record, FrfRecord>()>& open) {
  return serve_measurement(
      std::make_shared<acquire::SandboxProcess>(path, [&] { return measurement_service(open()); }));
}

std::shared_ptr<acquire::ForkServer> measurement_fork_server(const FrfReadOptions& options) {
  FrfReadOptions within = options;
  within.read.sandboxed = false;
  return std::make_shared<acquire::ForkServer>(
      [within](const std::string& path) { return measurement_service(open_measurement(path, within)); });
}

std::variant<acquire::Record, FrfRecord> open_measurement_forked(
    const std::shared_ptr<acquire::ForkServer>& fork_server, const std::string& path, const FrfReadOptions& options) {
  if (fork_server->lost() || !needs_sandbox(path)) return open_measurement(path, options);
  try {
    return serve_measurement(std::make_shared<acquire::SandboxProcess>(path, fork_server));
  } catch (const InputError&) {
    if (!fork_server->lost()) throw;
  }
  return open_measurement(path, options);
}

}  // namespace percuss::frf
