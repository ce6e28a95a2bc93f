#include "acquire/sandbox/system_call_filter.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <new>
#include <vector>

#include "acquire/sandbox/enter_sandbox.hpp"
#include "acquire/sandbox/sandbox_limits.hpp"

namespace percuss::acquire {
namespace {

// The kernel ignores the upper half of an argument of 32 bits, but comparisons see 64 bits. So each rule requires the
// upper half to be zero, or tests only bits of the lower half.
constexpr scmp_datum_t kAllBits = ~scmp_datum_t{0};

scmp_datum_t bits(int flags) { return static_cast<scmp_datum_t>(static_cast<unsigned>(flags)); }

scmp_arg_cmp equals(unsigned argument, int value) {
  return {.arg = argument, .op = SCMP_CMP_EQ, .datum_a = bits(value), .datum_b = 0};
}
// Among the bits of `mask`, exactly those of `value` are set.
scmp_arg_cmp has_bits(unsigned argument, scmp_datum_t mask, int value) {
  return {.arg = argument, .op = SCMP_CMP_MASKED_EQ, .datum_a = mask, .datum_b = bits(value)};
}

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM))) {
    if (context_ == nullptr) throw std::bad_alloc();
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  void allow(int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    const auto count = static_cast<unsigned>(arguments.size());
    // EDOM: this architecture does not have the call.
    const int result = seccomp_rule_add_array(context_, SCMP_ACT_ALLOW, call, count, arguments.begin());
    complete_ = complete_ && (result == -EDOM || succeeded(result));
    if (result == 0 && call >= 0) calls_.push_back(static_cast<unsigned>(call));
  }
  bool load() {
    if (!complete_) return false;
    std::vector<sock_filter> program = instructions();
    const sock_fprog filter{.len = static_cast<unsigned short>(program.size()), .filter = program.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
  }

 private:
  // When an allocation fails, libseccomp may leave out a rule without an error. A call that the reader needs would then
  // be refused, and the reader could wait for ever. So each call must appear in the program. Throws std::bad_alloc.
  std::vector<sock_filter> instructions() const {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) throw std::bad_alloc();
    std::vector<sock_filter> program(BPF_MAXINSNS);  // 32 kB; a pipe holds 64 kB
    const bool exported = seccomp_export_bpf(context_, ends[1]) == 0;
    const ssize_t size = ::read(ends[0], program.data(), program.size() * sizeof(sock_filter));
    for (const int end : ends) ::close(end);
    if (!exported || size < 0) throw std::bad_alloc();
    program.resize(static_cast<std::size_t>(size) / sizeof(sock_filter));
    if (!std::ranges::all_of(calls_, [&](unsigned call) { return names(program, call); })) throw std::bad_alloc();
    return program;
  }
  static bool names(const std::vector<sock_filter>& program, unsigned call) {
    return std::ranges::any_of(
        program, [&](const sock_filter& step) { return step.code == (BPF_JMP | BPF_JEQ | BPF_K) && step.k == call; });
  }
  static bool succeeded(int result) {
    if (result == -ENOMEM || result == -EFAULT) throw std::bad_alloc();  // the library reports either
    return result == 0;
  }

  scmp_filter_ctx context_;
  std::vector<unsigned> calls_;  // numbers of the allowed calls
  bool complete_ = true;
};

// The C library, matio, HDF5 and libsndfile need these to read a file.
void allow_always(Filter& filter) {
  for (const int call :
       {SCMP_SYS(read), SCMP_SYS(pread64), SCMP_SYS(readv), SCMP_SYS(preadv), SCMP_SYS(lseek), SCMP_SYS(fstat),
        SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(stat), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk),
        SCMP_SYS(madvise), SCMP_SYS(futex), SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(rt_sigaction),
        SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(getpid), SCMP_SYS(gettid),
        SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(getrandom), SCMP_SYS(sched_yield), SCMP_SYS(uname),
        SCMP_SYS(sysinfo), SCMP_SYS(fadvise64), SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(restart_syscall),
        // HDF5 resolves the symbolic links of the file's path.
        SCMP_SYS(lstat), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd)})
    filter.allow(call);
}

void allow_reading_files(Filter& filter) {
  constexpr int kHarmless = O_CLOEXEC | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW;
  const scmp_datum_t others = kAllBits & ~bits(kHarmless);
  filter.allow(SCMP_SYS(open), {has_bits(1, others, O_RDONLY)});
  filter.allow(SCMP_SYS(openat), {has_bits(2, others, O_RDONLY)});
  for (const int command : {F_GETFD, F_SETFD, F_GETFL}) filter.allow(SCMP_SYS(fcntl), {equals(1, command)});
  for (const int lock : {LOCK_SH | LOCK_NB, LOCK_UN}) filter.allow(SCMP_SYS(flock), {equals(1, lock)});
}

// Shared memory would let the reader write to other processes. Executable memory would let it run code from the file.
void allow_private_memory(Filter& filter) {
  constexpr int kSharingMask = 0x0F;  // of MAP_SHARED, MAP_PRIVATE and MAP_SHARED_VALIDATE
  const scmp_datum_t execution = bits(PROT_EXEC);
  filter.allow(SCMP_SYS(mmap), {has_bits(2, execution, 0), has_bits(3, bits(kSharingMask), MAP_PRIVATE)});
  filter.allow(SCMP_SYS(mprotect), {has_bits(2, execution, 0)});
}

// Allows closing all descriptors except 0 and 1, which the process keeps. The kernel ignores the upper half of the
// argument: a rule "not 0" would accept a number whose lower half is 0. So each rule requires one of the bits 1 to 5,
// and zeros above them.
void allow_closing(Filter& filter) {
  static_assert(kSandboxSocket < 2 && kSandboxParentPipe < 2);
  const scmp_datum_t beyond = kAllBits & ~bits(kSandboxDescriptors - 1);
  for (int bit = 2; bit < kSandboxDescriptors; bit *= 2)
    filter.allow(SCMP_SYS(close), {has_bits(0, beyond | bits(bit), bit)});
}

}  // namespace

bool filter_system_calls() {
  Filter filter;
  allow_always(filter);
  allow_reading_files(filter);
  allow_private_memory(filter);
  allow_closing(filter);
  filter.allow(SCMP_SYS(write), {equals(0, kSandboxSocket)});
  // abort() signals this process.
  filter.allow(SCMP_SYS(tgkill), {equals(0, ::getpid()), equals(2, SIGABRT)});
  // The processor time for each answer.
  filter.allow(SCMP_SYS(setitimer), {equals(0, ITIMER_PROF)});
  return filter.load();
}

}  // namespace percuss::acquire
