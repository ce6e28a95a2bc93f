#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "acquire/sandbox/serialization.hpp"

namespace percuss::acquire {

/// A service with the record's description and samples. Signal 0 is the force, 1 … are the accelerations.
SandboxService record_service(Record record);

/// The record that a sandboxed process describes and serves. `in` is at the start of the bytes of record_service.
/// errors  InputError: the description is impossible.
Record sandboxed_record(Deserializer& in, const std::shared_ptr<SandboxProcess>& process);

/// Parts of the description of a record, which the description of FRFs shares.
void serialize_signal(Serializer& out, const SignalInfo& signal);
SignalInfo deserialize_signal(Deserializer& in);
/// A direction, or three NaN. It is not a part of serialize_signal, because stored parts of a batch have the layout of
/// serialize_signal.
void serialize_axis(Serializer& out, const std::optional<Direction>& axis);
std::optional<Direction> deserialize_axis(Deserializer& in);
void serialize_notes(Serializer& out, const std::vector<Message>& notes);
std::vector<Message> deserialize_notes(Deserializer& in);
void serialize_geometry(Serializer& out, const std::vector<std::vector<double>>& geometry);
std::vector<std::vector<double>> deserialize_geometry(Deserializer& in);
void serialize_faces(Serializer& out, const std::vector<TraceFace>& faces);
std::vector<TraceFace> deserialize_faces(Deserializer& in);
void serialize_driving(Serializer& out, const std::vector<DrivingPlace>& driving);
std::vector<DrivingPlace> deserialize_driving(Deserializer& in);

// Checks of the parts that a sandboxed process describes, because the process may be compromised.

/// Whether every row of the geometry has the same 2 or 3 numbers, and the lines and faces connect its rows. Of a Record
/// or an FrfRecord.
template <class AnyRecord>
bool plausible_geometry(const AnyRecord& record) {
  const auto& rows = record.geometry;
  const auto fits = [&](const std::vector<double>& row) {
    return (row.size() == 2 || row.size() == 3) && row.size() == rows.front().size();
  };
  const auto exists = [&](int point) { return point >= 0 && static_cast<std::size_t>(point) < rows.size(); };
  const auto connects = [&](const auto& points) { return std::all_of(points.begin(), points.end(), exists); };
  return std::all_of(rows.begin(), rows.end(), fits) &&
         std::all_of(record.trace_lines.begin(), record.trace_lines.end(), connects) &&
         std::all_of(record.trace_faces.begin(), record.trace_faces.end(),
                     [&](const TraceFace& face) { return face.size() >= 3 && connects(face); });
}

/// Whether the driving places have valid point numbers and are at one of the channels.
bool plausible_driving(const std::vector<DrivingPlace>& driving, std::size_t channels);

}  // namespace percuss::acquire
