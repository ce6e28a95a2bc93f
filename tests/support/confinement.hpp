#pragma once

namespace percuss::test {

/// Whether this system lets a process restrict its system calls (seccomp filters), or the files that it may open
/// (Landlock).
bool has_seccomp();
bool has_landlock();

/// Takes these features from this process and the programs that it executes, as an old kernel or a container does.
void remove_seccomp();
void remove_landlock();

}  // namespace percuss::test
