#pragma once
#include <cstdint>
#include <string>

namespace percuss::acquire {

/// The descriptors that a sandboxed process keeps. It cannot close them.
inline constexpr int kSandboxSocket = 0, kSandboxParentPipe = 1;

/// Restricts this process permanently to reading the file `path`, allocating memory within limit_resources, and writing
/// to kSandboxSocket. Where the system has Landlock, no other file can be opened. The caller closes the process's other
/// descriptors first (keep_only_descriptors).
/// errors  InputError: the system has no filters of system calls (seccomp), or its Landlock refuses the restriction
void enter_sandbox(const std::string& path, std::uint64_t file_bytes);

}  // namespace percuss::acquire
