#pragma once
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <functional>
#include <optional>
#include <type_traits>

namespace percuss::accuracy {

/// The peak memory of this process in bytes; right after a fork, its current memory.
inline double peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Runs `work` in a forked process, so its memory can be measured alone, and returns its result. None when the process
/// did not end normally.
template <class Result>
std::optional<Result> forked(const std::function<Result()>& work) {
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return std::nullopt;
  ::malloc_trim(0);  // otherwise the child would use free memory of the parent uncounted
  const pid_t child = ::fork();
  if (child == 0) {
    int status = 1;
    try {
      const Result result = work();
      if (::write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result)) status = 0;
    } catch (const std::exception& problem) {
      fmt::print(stderr, "not measured: {}\n", problem.what());
    }
    ::_exit(status);
  }
  ::close(ends[1]);
  Result result{};
  const bool whole = child > 0 && ::read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  ::close(ends[0]);
  if (child > 0) ::waitpid(child, nullptr, 0);
  if (!whole) return std::nullopt;
  return result;
}

}  // namespace percuss::accuracy
