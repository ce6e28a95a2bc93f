#include "core/parallel/per_thread.hpp"

#include <pthread.h>

#include <new>

namespace percuss {
inline namespace core {

ThreadKey::ThreadKey(void (*destroy)(void*)) {
  pthread_key_t key{};
  if (pthread_key_create(&key, destroy) != 0) throw std::bad_alloc();
  key_ = key;
}

void* ThreadKey::get() const { return pthread_getspecific(static_cast<pthread_key_t>(key_)); }

void ThreadKey::set(const void* value) const {
  if (pthread_setspecific(static_cast<pthread_key_t>(key_), value) != 0) throw std::bad_alloc();
}

}  // namespace core
}  // namespace percuss
