#pragma once
#include <cstddef>

namespace percuss {
inline namespace core {

/// Calls call(task, 0) … call(task, count − 1) on up to `threads` threads (0: all processors), in any order. Only
/// task_arena.cpp uses oneTBB. That file is built without the thread sanitizer, which cannot see the order that the
/// library guarantees.
void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task);

}  // namespace core
}  // namespace percuss
