#pragma once
#include <chrono>

namespace percuss {

/// The wall-clock time of one call of `work`, s.
template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace percuss
