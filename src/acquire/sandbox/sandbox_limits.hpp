#pragma once
#include <cstdint>

namespace percuss::acquire {

/// Restricts this process permanently to what the reader of a foreign file needs: reading files, allocating memory and
/// writing to `descriptor`. It can neither write elsewhere nor use the network nor start processes.
///   memory     2 GiB, or 4 times the file, beyond the present use (no limit under a sanitizer, which needs terabytes)
///   processor  20 s, and one more per 50 MB of the file
///   files      64 open ones
/// On a system without seccomp, only these limits apply.
void enter_sandbox(int descriptor, std::uint64_t file_bytes);

/// The processor time allowed to the reader of a file of `file_bytes`.
unsigned processor_limit_s(std::uint64_t file_bytes);

}  // namespace percuss::acquire
