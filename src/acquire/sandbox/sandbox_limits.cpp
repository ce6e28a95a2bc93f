#include "acquire/sandbox/sandbox_limits.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <vector>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PERCUSS_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PERCUSS_SANITIZED 1
#endif

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMinMemory_bytes = std::uint64_t{2} << 30U;
constexpr std::uint64_t kMinTime_s = 20, kBytesPerSecond = 50'000'000;
constexpr rlim_t kOpenFiles = 64;

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit soft_and_hard{value, value};
  setrlimit(resource, &soft_and_hard);
}

[[maybe_unused]] std::uint64_t memory_now_bytes() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

#if defined(__x86_64__) || defined(__aarch64__)

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#else
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#endif

using Program = std::vector<sock_filter>;

void load(Program& program, std::size_t offset) {
  program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
}

void return_action(Program& program, std::uint32_t action) { program.push_back(BPF_STMT(BPF_RET | BPF_K, action)); }

// Skips `skip` instructions unless the value loaded equals `wanted`.
void unless_equal(Program& program, std::uint32_t wanted, std::uint8_t skip) {
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, wanted, 0, skip));
}

constexpr std::size_t argument_offset(std::size_t index) { return offsetof(seccomp_data, args) + 8 * index; }

void allow_always(Program& program) {
  // The C library, matio, HDF5 and libsndfile need these to read a file.
  static const std::vector<long> kAllowed {
    SYS_read, SYS_pread64, SYS_readv, SYS_preadv, SYS_lseek, SYS_close, SYS_fstat, SYS_newfstatat, SYS_statx, SYS_mmap,
        SYS_munmap, SYS_mremap, SYS_mprotect, SYS_brk, SYS_madvise, SYS_futex, SYS_exit, SYS_exit_group,
        SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack, SYS_getpid, SYS_gettid, SYS_tgkill,
        SYS_clock_gettime, SYS_gettimeofday, SYS_getrandom, SYS_sched_yield, SYS_fcntl, SYS_flock, SYS_faccessat,
        SYS_getcwd, SYS_readlinkat, SYS_uname, SYS_sysinfo, SYS_fadvise64, SYS_getuid, SYS_geteuid, SYS_restart_syscall,
#if defined(__x86_64__)
        SYS_stat, SYS_lstat, SYS_access, SYS_readlink,
#endif
  };
  for (const long number : kAllowed) {
    unless_equal(program, static_cast<std::uint32_t>(number), 1);
    return_action(program, SECCOMP_RET_ALLOW);
  }
}

// Allows opening for reading only. The flags are argument `index`.
void allow_opening(Program& program, long number, std::size_t index) {
  constexpr std::uint32_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;
  unless_equal(program, static_cast<std::uint32_t>(number), 4);
  load(program, argument_offset(index));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, kWriting, 1, 0));
  return_action(program, SECCOMP_RET_ALLOW);
  return_action(program, SECCOMP_RET_ERRNO | EPERM);
}

void allow_writing_to(Program& program, int descriptor) {
  unless_equal(program, static_cast<std::uint32_t>(SYS_write), 4);
  load(program, argument_offset(0));
  unless_equal(program, static_cast<std::uint32_t>(descriptor), 1);
  return_action(program, SECCOMP_RET_ALLOW);
  return_action(program, SECCOMP_RET_ERRNO | EPERM);
}

void filter_calls(int descriptor) {
  Program program;
  load(program, offsetof(seccomp_data, arch));
  unless_equal(program, kArchitecture, 1);
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JA, 1, 0, 0));
  return_action(program, SECCOMP_RET_KILL);
  load(program, offsetof(seccomp_data, nr));
  allow_always(program);
#if defined(__x86_64__)
  allow_opening(program, SYS_open, 1);
#endif
  allow_opening(program, SYS_openat, 2);
  allow_writing_to(program, descriptor);
  return_action(program, SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog whole{static_cast<unsigned short>(program.size()), program.data()};
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &whole);  // NOLINT: C. On failure, the resource limits still apply.
}

#else
void filter_calls(int) {}
#endif

}  // namespace

unsigned processor_limit_s(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMax_s = 1'000'000;
  return static_cast<unsigned>(std::min(kMax_s, kMinTime_s + file_bytes / kBytesPerSecond));
}

void enter_sandbox(int descriptor, std::uint64_t file_bytes) {
#if !defined(PERCUSS_SANITIZED)
  limit(RLIMIT_AS, memory_now_bytes() + std::max(kMinMemory_bytes, 4 * file_bytes));
#endif
  limit(RLIMIT_CPU, processor_limit_s(file_bytes));
  limit(RLIMIT_NOFILE, static_cast<rlim_t>(descriptor) + kOpenFiles);  // the parent's files are still open
  limit(RLIMIT_CORE, 0);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);  // NOLINT: C
  filter_calls(descriptor);
}

}  // namespace percuss::acquire
