#pragma once
#include <string>

#include "acquire/record/record.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "acquire/sandbox/serialization.hpp"

namespace percuss::acquire {

/// A record's description as bytes, and its samples as a service (signal 0 is the force, 1 … the accelerations).
SandboxService record_service(Record record);

/// The record that a confined process describes and serves. `in` stands where record_service began.
Record sandboxed_record(Deserializer& in, const std::shared_ptr<SandboxProcess>& process);

/// Parts of it, for other descriptions.
void serialize_signal(Serializer& out, const SignalInfo& signal);
SignalInfo deserialize_signal(Deserializer& in);
void serialize_strings(Serializer& out, const std::vector<std::string>& texts);
std::vector<std::string> deserialize_strings(Deserializer& in);
void serialize_notes(Serializer& out, const std::vector<Message>& notes);
std::vector<Message> deserialize_notes(Deserializer& in);
void serialize_geometry(Serializer& out, const std::vector<std::vector<double>>& geometry);
std::vector<std::vector<double>> deserialize_geometry(Deserializer& in);

}  // namespace percuss::acquire
