#pragma once
#include <cstdint>

namespace percuss::acquire {

/// Restricts this process permanently to what the reader of a foreign file needs: reading files, allocating memory and
/// writing to `descriptor`. It can neither write elsewhere nor use the network nor start processes.
///   memory     the larger of 2 GiB and 4 times the file's size, beyond the present use
///   processor  20 s, and 1 s more per 50 MB of the file
///   files      64 open ones
/// A sanitizer needs terabytes of address space, so a sanitized build has no limit of memory. On a system without
/// seccomp, only these limits apply.
void enter_sandbox(int descriptor, std::uint64_t file_bytes);

/// The processor time allowed to the reader of a file of `file_bytes`.
unsigned processor_limit_s(std::uint64_t file_bytes);

}  // namespace percuss::acquire
