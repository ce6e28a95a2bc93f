#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace percuss {
inline namespace core {

/// Uninitialised array, written once by its owner. Zeroing many MiB first can take a fifth of the run time.
/// errors  std::bad_alloc
template <class Value>
class UninitializedArray {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  explicit UninitializedArray(std::size_t size) : values_(allocate(size * sizeof(Value)), std::free), size_(size) {}
  std::span<Value> part(std::size_t first, std::size_t count) const { return all().subspan(first, count); }
  std::span<Value> all() const { return {values_.get(), size_}; }

 private:
  static Value* allocate(std::size_t bytes) {
    constexpr std::size_t kCacheLine = 64;
    void* const memory = std::aligned_alloc(kCacheLine, (bytes / kCacheLine + 1) * kCacheLine);
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<Value*>(memory);
  }

  std::unique_ptr<Value, decltype(&std::free)> values_;
  std::size_t size_;
};

}  // namespace core
}  // namespace percuss
