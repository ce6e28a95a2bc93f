#pragma once
#include <cstdint>

namespace percuss::acquire {

/// The memory that the reader of a file of `file_bytes` may allocate: 256 MiB plus 64 times the file.
std::uint64_t memory_limit_bytes(std::uint64_t file_bytes);

/// The processor time that the reader may use for each answer: 2 s plus 1 s per 5 MB of the file. In a sanitized build,
/// which runs about twenty times slower, the limit is twenty times longer.
unsigned processor_limit_s(std::uint64_t file_bytes);

/// Limits this process permanently to the memory above, to kSandboxDescriptors descriptors, and to one hour of
/// processor time for all answers (more if one answer may take longer). It cannot write files or start processes. Lower
/// limits remain. A sanitizer needs terabytes of address space, so a sanitized build has no limit of memory.
void limit_resources(std::uint64_t file_bytes);

/// The heap memory that this process has taken since limit_resources; 0 in a sanitized build.
std::uint64_t heap_growth_bytes();

/// Starts the processor time of an answer. The signal SIGPROF ends a process that exceeds it.
void start_processor_limit(std::uint64_t file_bytes);

/// Descriptors of a sandboxed process are less than this number.
inline constexpr int kSandboxDescriptors = 64;

}  // namespace percuss::acquire
