#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/sandbox/serialization.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

// The protocol between a sandboxed process and its parent, over a socket: the parent sends requests, the process sends
// outcomes.

/// Asks for numbers first … first + count − 1 of a row's signal, to be written to the shared memory.
struct SandboxRequest {
  std::uint64_t row = 0, signal = 0, first = 0, count = 0;
};

/// The result of a request.
enum class SandboxOutcome : std::uint64_t {
  good,
  input_error,
  ambiguous_columns,
  no_memory,
  other_error,
  machine_fault
};

/// Precedes the payload of an outcome.
struct SandboxOutcomeHead {
  SandboxOutcome outcome = SandboxOutcome::good;
  std::uint64_t payload_bytes = 0;
  std::uint64_t memory_bytes = 0;  // that the process has taken
};

/// Receives all bytes. False when the other process has closed its end.
bool receive_bytes(int descriptor, void* to, std::size_t bytes);

/// Runs `work` and sends its result, or the error that it threw. False when the parent has closed its end.
bool run_and_send_outcome(int descriptor, const std::function<std::string()>& work);

/// The options of an error or a note.
void serialize_options(Serializer& out, const std::vector<OptionId>& options);
/// errors  std::out_of_range: too many options, or not an option's identifier
std::vector<OptionId> deserialize_options(Deserializer& in);

/// The error in the payload of SandboxOutcome::input_error, machine_fault or ambiguous_columns.
/// errors  std::out_of_range: the payload is not such an error
InputError deserialize_input_error(const std::string& payload);
MachineFault deserialize_machine_fault(const std::string& payload);
AmbiguousColumns deserialize_ambiguous_columns(const std::string& payload);

}  // namespace percuss::acquire
