// The tests preload this library into percuss. It makes allocations, forks and writes to regular files fail.
//   PERCUSS_FAULT_ALLOCATION=N  the N-th allocation of each process fails; a forked child continues its parent's count
//   PERCUSS_FAULT_WRITE=N       the N-th write to a file, or fsync, and all later ones fail: the disk is full
//   PERCUSS_FAULT_SHORT=N       no write to a file accepts more than N bytes
//   PERCUSS_FAULT_FORK=N        the N-th fork of each process and all later ones fail
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

long environment_number(const char* name) {
  const char* const text = std::getenv(name);
  return text == nullptr ? 0 : std::atol(text);
}

// The function of the C library that this file replaces.
template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool out_of_memory() {
  static const long kFailing = environment_number("PERCUSS_FAULT_ALLOCATION");
  static std::atomic<long> count = 0;
  if (kFailing == 0 || ++count != kFailing) return false;
  errno = ENOMEM;
  return true;
}

bool is_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

// The number of bytes to write; negative: the disk is full.
ssize_t allowed(int descriptor, std::size_t wanted) {
  static const long kFull = environment_number("PERCUSS_FAULT_WRITE"),
                    kShort = environment_number("PERCUSS_FAULT_SHORT");
  static std::atomic<long> count = 0;
  if (!is_file(descriptor)) return static_cast<ssize_t>(wanted);
  if (kFull > 0 && ++count >= kFull) {
    errno = ENOSPC;
    return -1;
  }
  const bool cut = kShort > 0 && wanted > static_cast<std::size_t>(kShort);
  return cut ? kShort : static_cast<ssize_t>(wanted);
}

}  // namespace

extern "C" {

// The functions of the C library by their internal names.
void* __libc_malloc(std::size_t);                 // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void*, std::size_t);         // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t bytes) { return out_of_memory() ? nullptr : __libc_malloc(bytes); }
void* calloc(std::size_t count, std::size_t bytes) { return out_of_memory() ? nullptr : __libc_calloc(count, bytes); }
void* realloc(void* old, std::size_t bytes) { return out_of_memory() ? nullptr : __libc_realloc(old, bytes); }
void* memalign(std::size_t alignment, std::size_t bytes) {
  return out_of_memory() ? nullptr : __libc_memalign(alignment, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** out, std::size_t alignment, std::size_t bytes) {
  void* const memory = memalign(alignment, bytes);
  if (memory == nullptr) return ENOMEM;
  *out = memory;
  return 0;
}

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
  static auto* const kReal = real<ssize_t(int, const void*, std::size_t)>("write");
  const ssize_t some = allowed(descriptor, count);
  return some < 0 ? some : kReal(descriptor, bytes, static_cast<std::size_t>(some));
}
ssize_t pwrite(int descriptor, const void* bytes, std::size_t count, off_t at) {
  static auto* const kReal = real<ssize_t(int, const void*, std::size_t, off_t)>("pwrite");
  const ssize_t some = allowed(descriptor, count);
  return some < 0 ? some : kReal(descriptor, bytes, static_cast<std::size_t>(some), at);
}
ssize_t pwrite64(int descriptor, const void* bytes, std::size_t count, off_t at) {
  return pwrite(descriptor, bytes, count, at);
}
pid_t fork() {
  static auto* const kReal = real<pid_t()>("fork");
  static const long kFirstFailing = environment_number("PERCUSS_FAULT_FORK");
  static std::atomic<long> count = 0;
  if (kFirstFailing > 0 && ++count >= kFirstFailing) {
    errno = EAGAIN;
    return -1;
  }
  return kReal();
}
int fsync(int descriptor) {
  static auto* const kReal = real<int(int)>("fsync");
  return allowed(descriptor, 1) < 0 ? -1 : kReal(descriptor);
}

}  // extern "C"
