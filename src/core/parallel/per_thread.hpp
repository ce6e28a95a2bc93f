#pragma once
#include <memory>

namespace percuss {
inline namespace core {

/// A pointer of each thread, null at first. `destroy` receives a thread's pointer, if it is not null, when the thread
/// ends. For static variables only: the key is never released.
class ThreadKey {
 public:
  /// errors  std::bad_alloc: the system has no more keys.
  explicit ThreadKey(void (*destroy)(void*));
  void* get() const;
  /// errors  std::bad_alloc
  void set(const void* value) const;

 private:
  unsigned long key_;  // NOLINT(google-runtime-int): holds pthread_key_t
};

/// One T per thread, made at its first use there and destroyed when the thread ends. Where memory is short, local()
/// throws; the first use of a thread_local variable with a destructor ends the program instead (glibc). For static
/// variables only.
template <class T>
class PerThread {
 public:
  /// The calling thread's value. errors  std::bad_alloc
  T& local() const {
    if (void* const known = key_.get()) return *static_cast<T*>(known);
    auto made = std::make_unique<T>();
    key_.set(made.get());
    return *made.release();
  }

 private:
  ThreadKey key_{[](void* value) { delete static_cast<T*>(value); }};
};

}  // namespace core
}  // namespace percuss
