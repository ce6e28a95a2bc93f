#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss::acquire {

inline constexpr std::size_t kSharedNumbers = std::size_t{1} << 17U;  // transferred at once: 1 MiB
inline constexpr std::size_t kSharedNumbers_bytes = kSharedNumbers * sizeof(double);

/// The numbers that parent and child share; nullptr on failure.
double* map_shared_numbers(int memory);

/// The size of a regular file; 0 for anything else.
std::uint64_t regular_file_bytes(const std::string& path);

/// Runs in the child until the parent closes its end, and returns the exit code.
int serve_in_sandbox(const ReaderDescriptors& descriptors, const std::string& path,
                     const std::function<SandboxService()>& open);
inline constexpr int kNoMemoryExitCode = 11;

}  // namespace percuss::acquire
