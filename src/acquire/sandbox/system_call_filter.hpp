#pragma once

namespace percuss::acquire {

/// Restricts this process permanently to the system calls that a reader of files needs. They allocate private memory,
/// open files for reading, and write to kSandboxSocket. Other calls fail with EPERM. False where the system has no such
/// filters (seccomp).
bool filter_system_calls();

}  // namespace percuss::acquire
