#pragma once
#include <string>

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
/// A direction, or three NaN. The layout of serialize_signal, which the parts of a batch store, lacks it.
void serialize_axis(Serializer& out, const std::optional<Direction>& axis);
std::optional<Direction> deserialize_axis(Deserializer& in);
void serialize_notes(Serializer& out, const std::vector<Message>& notes);
std::vector<Message> deserialize_notes(Deserializer& in);
void serialize_geometry(Serializer& out, const std::vector<std::vector<double>>& geometry);
std::vector<std::vector<double>> deserialize_geometry(Deserializer& in);
void serialize_faces(Serializer& out, const std::vector<TraceFace>& faces);
std::vector<TraceFace> deserialize_faces(Deserializer& in);

}  // namespace percuss::acquire
