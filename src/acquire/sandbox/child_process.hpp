#pragma once
#include <cstddef>
#include <initializer_list>
#include <string>

namespace percuss::acquire {

/// As fork(). A child of the process's first thread is killed when the process ends. The kernel would kill the
/// child of another thread when that thread ends, so such a child needs end_with_parent.
int fork_child();

/// Closes all descriptors of this process but these, which become 0, 1, …. Descriptors of the file `path` remain under
/// their numbers, read-only: if the file was open before the fork, HDF5 reads it through the old descriptor.
void keep_only_descriptors(std::initializer_list<int> kept, const std::string& path = {});

/// The kernel kills this process once the write end of this pipe is closed in all processes. Only the parent holds the
/// write end.
void end_with_parent(int parent_pipe);

/// Sets all signals to their default action, except SIGPIPE, which is ignored.
void reset_signals();

}  // namespace percuss::acquire
