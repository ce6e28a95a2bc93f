#pragma once
#include <functional>
#include <string>

#include "acquire/record/record.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "acquire/sandbox/serialization.hpp"

namespace percuss {

/// A record's description as bytes, and its samples as a service (signal 0 is the force, 1 … the accelerations).
ConfinedService record_service(Record record);

/// The record that a confined process describes and serves. `in` stands where record_service began.
Record served_record(Unpacker& in, const std::shared_ptr<ConfinedProcess>& process);

/// Parts of it, for other descriptions.
void pack_signal(Packer& out, const SignalInfo& signal);
SignalInfo unpack_signal(Unpacker& in);
void pack_texts(Packer& out, const std::vector<std::string>& texts);
std::vector<std::string> unpack_texts(Unpacker& in);
void pack_geometry(Packer& out, const std::vector<std::vector<double>>& geometry);
std::vector<std::vector<double>> unpack_geometry(Unpacker& in);

/// Opens a record of a foreign binary file in a confined process.
Record open_confined(const std::string& path, const std::function<Record()>& open);

}  // namespace percuss
