#pragma once
#include <string>

namespace percuss::acquire {

/// Whether this system can restrict the files that a process opens (Landlock).
bool can_restrict_files();

/// Leaves this process one file to open, for reading: the regular file `path`, if there is one. The process can also
/// neither open TCP connections (from version 4 of Landlock on) nor signal other processes (from version 6 on). False
/// when the system has no Landlock or refuses the restriction.
bool leave_one_readable_file(const std::string& path);

}  // namespace percuss::acquire
