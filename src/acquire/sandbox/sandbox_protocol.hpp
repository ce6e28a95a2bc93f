#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace percuss::acquire {

// What a confined reader and its parent say to each other, over a socket: requests one way, outcomes the other.

/// Numbers first … first + count − 1 of a row's signal, wanted in the memory that both share.
struct SandboxRequest {
  std::uint64_t row = 0, signal = 0, first = 0, count = 0;
};

/// How a request ended. An outcome is this number, the payload's length and the payload.
enum class SandboxOutcome : std::uint64_t { good, input_error, ambiguous, no_memory, other };

/// All of the bytes, or false when the other side is gone.
bool send_bytes(int descriptor, const void* from, std::size_t bytes);
bool receive_bytes(int descriptor, void* to, std::size_t bytes);

/// Runs `work` and tells its result, or the error it threw; false when the parent is gone.
bool run_and_send_outcome(int descriptor, const std::function<std::string()>& work);

/// Throws the AmbiguousColumns that the payload of SandboxOutcome::unclear describes; std::out_of_range when it does
/// not.
[[noreturn]] void throw_ambiguous_columns(const std::string& payload);

}  // namespace percuss::acquire
