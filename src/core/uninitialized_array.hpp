#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <span>
#include <type_traits>

namespace percuss::inline core {

/// Memory for `bytes` that nobody has set, in pages as large as the system gives; for std::free.
/// errors  std::bad_alloc
void* allocate_pages(std::size_t bytes);

/// Values that are set once, by who owns it: of an array of many MiB a fifth of the time may go into getting small
/// pages of memory, and setting it to zero beforehand takes as much.
template <class Value>
class UninitializedArray {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  explicit UninitializedArray(std::size_t size)
      : values_(static_cast<Value*>(allocate_pages(size * sizeof(Value))), std::free), size_(size) {}
  std::span<Value> part(std::size_t first, std::size_t count) const { return all().subspan(first, count); }
  std::span<Value> all() const { return {values_.get(), size_}; }

 private:
  std::unique_ptr<Value, decltype(&std::free)> values_;
  std::size_t size_;
};

}  // namespace percuss::inline core
