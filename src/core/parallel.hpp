#pragma once
#include <cstddef>
#include <functional>

namespace percuss {

/// Calls task(0) … task(count − 1), each once, on at most `threads` threads (0: as many as the machine has; 1: here, in
/// order). Tasks write only to places of their own, so that the result does not depend on the number of threads. The
/// first exception thrown by a task is passed on.
void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& task);

}  // namespace percuss
