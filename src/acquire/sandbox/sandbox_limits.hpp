#pragma once
#include <cstdint>

namespace percuss::acquire {

/// Takes from this process, for good, what the reader of a foreign file has no use for. It may still read files, take
/// memory and write to `descriptor`; nothing else: no other writing, no network, no new processes.
///   memory     2 GiB, or 4 times the file, beyond what it has now (not under a sanitizer, which needs terabytes)
///   processor  20 s, and one more per 50 MB of the file
///   files      64 open ones
/// Where the system has no seccomp the limits alone hold.
void enter_sandbox(int descriptor, std::uint64_t file_bytes);

/// The processor's time that a reader of a file of that size gets.
unsigned processor_limit_s(std::uint64_t file_bytes);

}  // namespace percuss::acquire
