#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>

#include "acquire/sandbox/sandbox_measurement.hpp"
#include "core/error.hpp"
#include "support/confinement.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// Attempts of malicious code in a sandboxed reader. Each must fail, except reading the file itself, and looking up
// names and sizes of files.
namespace percuss::acquire::enter_sandbox_test {

using testing::HasSubstr;

struct Attempt {
  const char* name;
  std::function<long()> result;  // negative: refused
};

template <class... Arguments>
long call(long number, Arguments... arguments) {
  return ::syscall(number, arguments...);
}

long map(int protection, int flags, int descriptor) {
  void* const at = ::mmap(nullptr, 4096, protection, flags, descriptor, 0);
  if (at == MAP_FAILED) return -1;
  if ((protection & PROT_WRITE) != 0) *static_cast<char*>(at) = 'x';
  return 0;
}

class EnterSandbox : public testing::Test {
 protected:
  EnterSandbox() {
    test::write_bytes(path_, "MATLAB");
    test::write_bytes(other_, "kept");
    file_ = ::open(other_.c_str(), O_RDWR);
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, pair_.data()), 0);
    bystander_ = ::fork();
    while (bystander_ == 0) ::pause();
  }
  ~EnterSandbox() override {
    ::kill(bystander_, SIGKILL);
    ::waitpid(bystander_, nullptr, 0);
    for (const int descriptor : {file_, pair_[0], pair_[1]}) ::close(descriptor);
  }
  /// The names of the attempts that succeed in the sandbox, or the message of a system without seccomp.
  std::string successes(const std::vector<Attempt>& attempts) const {
    try {
      open_in_sandbox(path_, [&]() -> Measurement {
        std::string names;
        for (const Attempt& attempt : attempts) {
          if (attempt.result() >= 0) names += std::string(names.empty() ? "" : ", ") + attempt.name;
        }
        throw InputError(names, "attempts", "that succeeded");
      });
    } catch (const InputError& error) {
      return error.problem();
    }
    return "no answer";
  }
  void expect_none(const std::vector<Attempt>& attempts) const {
    const std::string expected =
        test::has_seccomp() ? "" : "this system cannot confine the process that reads the file";
    EXPECT_EQ(successes(attempts), expected);
    EXPECT_EQ(test::bytes_of(other_), "kept");
    EXPECT_EQ(::waitpid(bystander_, nullptr, WNOHANG), 0) << "a process was killed";
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat"), other_ = folder_.file("other");
  pid_t parent_ = ::getpid(), bystander_ = -1;
  std::array<int, 2> pair_{-1, -1};
  int file_ = -1;
};

TEST_F(EnterSandbox, LeavesOneFileReadable) {
  const auto open = [](const std::string& path, int flags) {
    return [=] { return static_cast<long>(::open(path.c_str(), flags)); };
  };
  const std::string of_parent = "/proc/" + std::to_string(parent_);
  std::vector<Attempt> reads{{"another file", open(other_, O_RDONLY)},
                             {"/etc/passwd", open("/etc/passwd", O_RDONLY)},
                             {"memory of the parent", open(of_parent + "/mem", O_RDONLY)},
                             {"environment of the parent", open(of_parent + "/environ", O_RDONLY)},
                             {"arguments of the parent", open(of_parent + "/cmdline", O_RDONLY)},
                             {"own memory", open("/proc/self/mem", O_RDONLY)}};
  if (test::has_landlock()) expect_none(reads);
  expect_none({{"a folder", open("/", O_RDONLY | O_DIRECTORY)},
               {"a path", open("/etc", O_PATH)},
               {"own memory for writing", open("/proc/self/mem", O_RDWR)},
               {"writing the file", open(path_, O_WRONLY)},
               {"truncating the file", open(path_, O_RDONLY | O_TRUNC)},
               {"a new file", [&] { return ::open(folder_.file("new").c_str(), O_RDONLY | O_CREAT, 0600); }},
               {"a file without name", [] { return ::open("/tmp", O_TMPFILE | O_RDWR, 0600); }},
               {"flags beyond 32 bits", [&] { return call(SYS_openat, AT_FDCWD, path_.c_str(), 0x100000000L); }},
               {"openat2", [] { return call(SYS_openat2, AT_FDCWD, "/etc/passwd", nullptr, 0L); }}});
  if (!test::has_seccomp()) return;
  EXPECT_EQ(successes({{"the file itself", open(path_, O_RDONLY)}}), "the file itself");
}

TEST_F(EnterSandbox, ReachesNoOtherProcess) {
  const auto signal_by_descriptor = [&](int descriptor) {
    const bool armed = ::fcntl(descriptor, F_SETOWN, bystander_) == 0 && ::fcntl(descriptor, F_SETSIG, SIGKILL) == 0 &&
                       ::fcntl(descriptor, F_SETFL, O_ASYNC | O_NONBLOCK) == 0;
    return armed ? 0 : -1;
  };
  const auto fork = [] {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child;
  };
  std::array<char, 8> bytes{};
  const iovec here{bytes.data(), bytes.size()}, there{&parent_, bytes.size()};
  expect_none(
      {{"kill", [&] { return ::kill(parent_, 0); }},
       {"tgkill of another process", [&] { return call(SYS_tgkill, bystander_, bystander_, SIGKILL); }},
       {"tgkill of another process with SIGABRT", [&] { return call(SYS_tgkill, bystander_, bystander_, SIGABRT); }},
       {"tkill", [&] { return call(SYS_tkill, bystander_, SIGKILL); }},
       {"signal of its own other than SIGABRT", [] { return call(SYS_tgkill, ::getpid(), ::getpid(), SIGCONT); }},
       {"rt_sigqueueinfo", [&] { return call(SYS_rt_sigqueueinfo, bystander_, SIGCONT, nullptr); }},
       {"pidfd_open", [&] { return call(SYS_pidfd_open, bystander_, 0); }},
       {"signal of a socket", [&] { return signal_by_descriptor(pair_[0]); }},
       {"signal of its own socket", [&] { return signal_by_descriptor(0); }},
       {"ptrace", [&] { return ::ptrace(PTRACE_ATTACH, bystander_, 0, 0); }},
       {"process_vm_readv", [&] { return call(SYS_process_vm_readv, parent_, &here, 1L, &there, 1L, 0L); }},
       {"fork", fork},
       {"clone3", [] { return call(SYS_clone3, nullptr, 0L); }},
       {"execve", [] { return ::execl("/bin/true", "true", nullptr); }},
       {"socket", [] { return ::socket(AF_INET, SOCK_STREAM, 0); }},
       {"local socket", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }},
       {"shared memory by number", [] { return call(SYS_shmget, 0, 4096L, 01600); }},
       {"io_uring_setup", [] { return call(SYS_io_uring_setup, 1, nullptr); }},
       {"bpf", [] { return call(SYS_bpf, 0, nullptr, 0); }},
       {"userfaultfd", [] { return call(SYS_userfaultfd, 0); }},
       {"keyctl", [] { return call(SYS_keyctl, 0, 0, 0); }}});
}

TEST_F(EnterSandbox, ClosesDescriptorsOfTheParent) {
  const iovec byte{const_cast<char*>("x"), 1};  // NOLINT: C
  char read_byte = 0;
  expect_none({{"map for writing", [&] { return map(PROT_READ | PROT_WRITE, MAP_SHARED, file_); }},
               {"map for reading", [&] { return map(PROT_READ, MAP_PRIVATE, file_); }},
               {"write", [&] { return ::write(file_, "x", 1); }},
               {"pwrite", [&] { return ::pwrite(file_, "x", 1, 0); }},
               {"writev", [&] { return ::writev(file_, &byte, 1); }},
               {"ftruncate", [&] { return ::ftruncate(file_, 1); }},
               {"lock", [&] { return ::flock(file_, LOCK_EX | LOCK_NB); }},
               {"send", [&] { return ::send(pair_[0], "x", 1, MSG_NOSIGNAL); }},
               {"write to standard output", [] { return ::write(1, "", 0); }},
               {"write to standard error", [] { return ::write(2, "", 0); }},
               {"read standard error", [&] { return ::read(2, &read_byte, 0); }},
               {"ioctl", [] { return call(SYS_ioctl, 0, 0x5412L, "x"); }}});
}

// A reader hands over its numbers in shared memory. Other readers must not inherit this memory.
TEST_F(EnterSandbox, DoesNotInheritTheNumbersOfOtherReaders) {
  const auto maps = [] {
    std::size_t count = 0;
    std::ifstream lines("/proc/self/maps");
    for (std::string line; std::getline(lines, line);)
      count += line.find("memfd:percuss") != std::string::npos ? 1U : 0U;
    return count;
  };
  if (!test::has_seccomp()) return;
  const SandboxProcess first(path_, [] { return SandboxService{.description = "d", .read = {}}; });
  const pid_t other = ::fork();
  if (other == 0) ::_exit(static_cast<int>(maps()));
  int status = -1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  if (std::filesystem::exists("/proc/self/maps")) {
    EXPECT_EQ(maps(), 1U);
  }
}

TEST_F(EnterSandbox, ChangesNeitherFilesNorItsLimits) {
  const auto with_own_file = [&](const auto& attempt) { return attempt(::open(path_.c_str(), O_RDONLY)); };
  rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
  expect_none({{"unlink", [&] { return ::unlink(other_.c_str()); }},
               {"rename", [&] { return ::rename(other_.c_str(), path_.c_str()); }},
               {"mkdir", [&] { return ::mkdir(folder_.file("new").c_str(), 0700); }},
               {"chmod", [&] { return ::chmod(other_.c_str(), 0777); }},
               {"symlink", [&] { return ::symlink("a", folder_.file("new").c_str()); }},
               {"utimensat", [&] { return ::utimensat(AT_FDCWD, other_.c_str(), nullptr, 0); }},
               {"memory for execution",
                [] { return map(PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1); }},
               {"memory made executable",
                [] {
                  void* const page = ::mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
                  return ::mprotect(page, 4096, PROT_READ | PROT_EXEC);
                }},
               {"shared memory", [] { return map(PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1); }},
               {"shared map of the file",
                [&] { return with_own_file([](int file) { return map(PROT_READ, MAP_SHARED, file); }); }},
               {"exclusive lock of the file",
                [&] { return with_own_file([](int file) { return ::flock(file, LOCK_EX | LOCK_NB); }); }},
               {"memfd_create", [] { return call(SYS_memfd_create, "x", 0); }},
               {"setrlimit", [&] { return call(SYS_prlimit64, 0, RLIMIT_CPU, &unlimited, nullptr); }},
               {"prctl", [] { return call(SYS_prctl, 3 /* PR_GET_DUMPABLE */, 0L, 0L, 0L, 0L); }},
               {"closing the parent pipe", [] { return ::close(1); }},
               {"closing the parent pipe by more than 32 bits", [] { return call(SYS_close, 0x100000001L); }},
               {"wait", [] {
                  const timespec moment{0, 1};
                  return call(SYS_nanosleep, &moment, nullptr);
                }}});
  EXPECT_FALSE(std::filesystem::exists(folder_.file("new")));
}

// The sandbox does not hide names and sizes of files, as docs/project/security.md states.
TEST_F(EnterSandbox, LeavesNamesAndSizesOfFilesVisible) {
  if (!test::has_seccomp()) return;
  const std::string link = folder_.file("link");
  std::filesystem::create_symlink(other_, link);
  struct stat status {};
  std::array<char, 16> target{};
  EXPECT_EQ(successes({{"stat", [&] { return ::stat(other_.c_str(), &status); }},
                       {"readlink", [&] { return ::readlink(link.c_str(), target.data(), target.size()); }}}),
            "stat, readlink");
}

#if defined(__x86_64__)
// The filter allows calls of the native interface only. It ends a process that calls by the numbers of x32.
TEST_F(EnterSandbox, EndsAProcessThatUsesAnotherInterface) {
  if (!test::has_seccomp()) return;
  EXPECT_THAT(successes({{"x32", [] { return call(SYS_openat | 0x40000000L, AT_FDCWD, "/etc/passwd", O_RDONLY); }}}),
              HasSubstr("signal 31"));
}
#endif

}  // namespace percuss::acquire::enter_sandbox_test
