#pragma once

namespace percuss::tools {

/// Makes malloc serve a program that asks for tens of MiB again and again and then ends: it keeps what is freed, and
/// has pages of 2 MiB, where the system has such. To be called before other threads are. Does nothing to other
/// allocators than glibc's.
void configure_malloc();

}  // namespace percuss::tools
