#pragma once
#include <cstddef>

namespace percuss {
inline namespace core {

/// For tests: the ThreadLimit that parallel_for_cost and parallel_for_chunks obey on this thread; 0: none.
std::size_t current_thread_limit();

}  // namespace core
}  // namespace percuss
