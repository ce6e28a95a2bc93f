#pragma once
#include <cstddef>

namespace percuss::inline core {

/// Calls call(task, 0) … call(task, count − 1) on up to `threads` threads (0: all), in any order. The only file that
/// sees oneTBB, and the only one that the thread sanitizer does not watch: what the library orders it cannot see.
void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task);

/// How many threads that are.
std::size_t arena_concurrency(std::size_t threads);

/// Another of these threads calls call(with) once it has nothing else to do; never, where the process ends before.
void enqueue_in_arena(std::size_t threads, void (*call)(void* with), void* with);

}  // namespace percuss::inline core
