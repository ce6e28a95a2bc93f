#pragma once

namespace percuss::tools {

/// Configures malloc for a short program that allocates tens of MiB again and again: it keeps freed memory, and its
/// heaps use pages of 2 MiB where the system has them. Call it before other threads start. Affects only glibc's malloc.
void configure_malloc();

}  // namespace percuss::tools
