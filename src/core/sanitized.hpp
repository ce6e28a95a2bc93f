#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PERCUSS_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PERCUSS_SANITIZED 1
#endif

namespace percuss {
inline namespace core {

// Whether this is a build with the address or the thread sanitizer, and by how much such a build may be slower: limits
// of time are longer by this factor. Large allocations are the slowest.
#if defined(PERCUSS_SANITIZED)
constexpr bool kSanitized = true;
constexpr unsigned kSlowness = 20;
#else
constexpr bool kSanitized = false;
constexpr unsigned kSlowness = 1;
#endif

}  // namespace core
}  // namespace percuss
