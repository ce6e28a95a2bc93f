#pragma once

namespace percuss::tools {

/// Configures malloc for a short program that repeatedly allocates tens of MiB: freed memory is kept, and the heap uses
/// pages of 2 MiB where available. Call it before other threads start. It affects glibc's allocator only.
void configure_malloc();

}  // namespace percuss::tools
