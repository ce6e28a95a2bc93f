#include "acquire/sandbox/sandbox_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "acquire/record/contiguous_samples.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/sample_limits.hpp"
#include "acquire/record/stated_date.hpp"
#include "acquire/sandbox/sandbox_protocol.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::optional<double> if_known(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

// The child may be compromised. Its numbers of row marks, faults and rows serve as indices later, so they are checked.
void require_known(const Record& record) {
  for (const RowInfo& row : record.rows) {
    if (!row_mark(static_cast<int>(row.mark))) throw std::out_of_range("not a row mark");
  }
  for (const RecordFault& fault : record.faults) {
    const std::array numbers{static_cast<double>(static_cast<int>(fault.kind)), static_cast<double>(fault.row),
                             fault.time_s, fault.value};
    if (!record_fault(numbers, record.rows.size())) throw std::out_of_range("not a fault");
  }
}

void serialize_description(Serializer& out, const Record& record) {
  out.put(static_cast<std::uint64_t>(record.files.size()));
  for (const InputFile& file : record.files) {
    out.put(file.path);
    out.put(file.bytes);
    out.put(file.date);
  }
  out.put(record.format);
  out.put(record.fs_Hz);
  serialize_signal(out, record.force);
  out.put(static_cast<std::uint64_t>(record.accel.size()));
  for (const SignalInfo& signal : record.accel) serialize_signal(out, signal);
  serialize_axis(out, record.force.axis);
  for (const SignalInfo& signal : record.accel) serialize_axis(out, signal.axis);
  out.put_all(record.rows);
  out.put_all(record.faults);
  out.put(static_cast<std::uint64_t>(record.continuous));
  out.put(static_cast<std::uint64_t>(record.has_force));
  serialize_geometry(out, record.geometry);
  out.put_all(record.trace_lines);
  serialize_faces(out, record.trace_faces);
  out.put_all(record.contiguous);
  serialize_notes(out, record.notes);
  serialize_driving(out, record.driving);
}

Record deserialize_description(Deserializer& in) {
  Record record;
  const std::size_t files = in.count(3 * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < files; ++i) {
    std::string path = in.text();
    const auto bytes = in.get<std::uint64_t>();
    record.files.push_back({.path = std::move(path), .bytes = bytes, .date = plausible_date(in.text())});
  }
  record.format = in.text();
  record.fs_Hz = in.get<double>();
  record.force = deserialize_signal(in);
  const std::size_t channels = in.count(5 * sizeof(double));
  for (std::size_t c = 0; c < channels; ++c) record.accel.push_back(deserialize_signal(in));
  record.force.axis = deserialize_axis(in);
  for (SignalInfo& signal : record.accel) signal.axis = deserialize_axis(in);
  record.rows = in.all<RowInfo>();
  record.faults = in.all<RecordFault>();
  require_known(record);
  record.continuous = in.get<std::uint64_t>() != 0;
  record.has_force = in.get<std::uint64_t>() != 0;
  record.geometry = deserialize_geometry(in);
  record.trace_lines = in.all<TraceLine>();
  record.trace_faces = deserialize_faces(in);
  record.contiguous = in.all<ContiguousSignal>();
  record.notes = deserialize_notes(in);
  record.driving = deserialize_driving(in);
  return record;
}

// Whether `signals` signals with these rows stay within claim_limit_bytes. The child may be compromised, so nothing is
// multiplied before it is known to be small.
bool fits(const std::vector<RowInfo>& rows, std::size_t signals, std::uint64_t file_bytes) {
  std::uint64_t left = claim_limit_bytes(file_bytes) / sizeof(double) / std::max<std::size_t>(signals, 1);
  for (const RowInfo& row : rows) {
    if (row.samples > left) return false;
    left -= row.samples;
  }
  return true;
}

// Whether all rows of the signal lie within the file.
bool fits(const std::vector<RowInfo>& rows, const ContiguousSignal& signal, std::uint64_t file_bytes) {
  if (signal.number_bytes != sizeof(float) && signal.number_bytes != sizeof(double)) return false;
  if (signal.offset_bytes > file_bytes) return false;
  std::uint64_t left = file_bytes - signal.offset_bytes;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].samples > left / signal.number_bytes) return false;
    if (row + 1 == rows.size()) break;
    if (signal.row_step_bytes > left) return false;
    left -= signal.row_step_bytes;
  }
  return true;
}

// The invariants that the other layers rely on. The child may be compromised.
bool plausible(const Record& record, std::uint64_t file_bytes) {
  bool valid = record.fs_Hz > 0 && std::isfinite(record.fs_Hz) && !record.rows.empty() && !record.accel.empty() &&
               record.files.size() <= 1 && fits(record.rows, record.accel.size(), file_bytes) &&
               plausible_geometry(record) && plausible_driving(record.driving, record.accel.size());
  for (const RowInfo& row : record.rows)
    valid = valid && row.samples >= 2 && row.file == 0 && is_point_number(row.point);
  for (const ContiguousSignal& signal : record.contiguous) valid = valid && fits(record.rows, signal, file_bytes);
  return valid;
}

}  // namespace

void serialize_signal(Serializer& out, const SignalInfo& signal) {
  out.put(signal.name);
  out.put(signal.unit);
  out.put(signal.to_SI);
  out.put(signal.angle_rad.value_or(kUnknown));
  out.put(signal.position_m.value_or(kUnknown));
  out.put(static_cast<std::uint64_t>(signal.measures == Quantity::pressure));
  out.put(static_cast<std::uint64_t>(signal.unit_assumed));
}

SignalInfo deserialize_signal(Deserializer& in) {
  SignalInfo signal;
  signal.name = in.text();
  signal.unit = in.text();
  signal.to_SI = in.get<double>();
  signal.angle_rad = if_known(in.get<double>());
  signal.position_m = if_known(in.get<double>());
  if (in.get<std::uint64_t>() != 0) signal.measures = Quantity::pressure;
  signal.unit_assumed = in.get<std::uint64_t>() != 0;
  return signal;
}

void serialize_axis(Serializer& out, const std::optional<Direction>& axis) {
  for (std::size_t i = 0; i < 3; ++i) out.put(axis ? axis->at(i) : kUnknown);
}

std::optional<Direction> deserialize_axis(Deserializer& in) {
  Direction axis{};
  for (double& x : axis) x = in.get<double>();
  const bool known = std::all_of(axis.begin(), axis.end(), [](double x) { return std::abs(x) <= 1; });
  return known ? std::optional(axis) : std::nullopt;
}

void serialize_notes(Serializer& out, const std::vector<Message>& notes) {
  out.put(static_cast<std::uint64_t>(notes.size()));
  for (const Message& note : notes) {
    out.put(note.text);
    serialize_options(out, note.options);
    out.put(static_cast<std::uint64_t>(note.information ? 1 : 0));
    out.put(note.code);
  }
}

std::vector<Message> deserialize_notes(Deserializer& in) {
  std::vector<Message> notes;
  const std::size_t count = in.count(4 * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = in.text();
    notes.emplace_back(std::move(text), deserialize_options(in));
    notes.back().information = in.get<std::uint64_t>() != 0;
    notes.back().code = in.text();
  }
  return notes;
}

void serialize_geometry(Serializer& out, const std::vector<std::vector<double>>& geometry) {
  out.put(static_cast<std::uint64_t>(geometry.size()));
  for (const auto& point : geometry) out.put_all(point);
}

void serialize_faces(Serializer& out, const std::vector<TraceFace>& faces) {
  out.put(static_cast<std::uint64_t>(faces.size()));
  for (const TraceFace& face : faces) out.put_all(face);
}

std::vector<TraceFace> deserialize_faces(Deserializer& in) {
  std::vector<TraceFace> faces;
  const std::size_t count = in.count(sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) faces.push_back(in.all<int>());
  return faces;
}

std::vector<std::vector<double>> deserialize_geometry(Deserializer& in) {
  std::vector<std::vector<double>> geometry;
  const std::size_t count = in.count(sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) geometry.push_back(in.all<double>());
  return geometry;
}

void serialize_driving(Serializer& out, const std::vector<DrivingPlace>& driving) {
  out.put(static_cast<std::uint64_t>(driving.size()));
  for (const DrivingPlace& at : driving) {
    out.put(at.point);
    out.put(static_cast<std::uint64_t>(at.channel));
  }
}

std::vector<DrivingPlace> deserialize_driving(Deserializer& in) {
  std::vector<DrivingPlace> driving;
  const std::size_t count = in.count(sizeof(int) + sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) {
    const int point = in.get<int>();
    driving.push_back({.point = point, .channel = in.get<std::uint64_t>()});
  }
  return driving;
}

bool plausible_driving(const std::vector<DrivingPlace>& driving, std::size_t channels) {
  return std::all_of(driving.begin(), driving.end(),
                     [&](const DrivingPlace& at) { return is_point_number(at.point) && at.channel < channels; });
}

SandboxService record_service(Record record) {
  Serializer out;
  serialize_description(out, record);
  const auto shared = std::make_shared<const Record>(std::move(record));
  return {.description = out.bytes(),
          .read = [shared](std::size_t row, std::size_t signal, std::size_t first, std::span<double> samples) {
            if (signal == 0) {
              shared->read_force_N(row, first, samples);
            } else {
              shared->read_accel_mps2(row, signal - 1, first, samples);
            }
          }};
}

Record sandboxed_record(Deserializer& in, const std::shared_ptr<SandboxProcess>& process) {
  Record record;
  try {
    record = deserialize_description(in);
  } catch (const std::out_of_range&) {
    process->report_contradiction();
  }
  if (!plausible(record, process->file_bytes())) process->report_contradiction();
  // This process opens the file by this path.
  for (InputFile& file : record.files)
    file = {.path = process->path(), .bytes = process->file_bytes(), .date = file.date};
  record.read_force_N = [process](std::size_t row, std::size_t first, std::span<double> out) {
    process->read(row, 0, first, out);
  };
  record.read_accel_mps2 = [process](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    process->read(row, channel + 1, first, out);
  };
  return with_contiguous_readers(std::move(record));
}

}  // namespace percuss::acquire
