#include "process_setup.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <string_view>

#include "cli/exit_code.hpp"
#include "core/io/temporary_files.hpp"
#include "core/library_call.hpp"

namespace percuss::tools {
namespace {

constexpr rlim_t kStack_bytes = rlim_t{8} << 20U, kEnoughStack_bytes = rlim_t{2} << 20U;

// Opens /dev/null in place of closed standard streams. The direction is wrong, so that their use stays an error:
// standard input is opened for writing, the outputs for reading.
void reopen_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1) continue;
    const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // gets the lowest number
    if (opened < 0 && ::open("/", O_RDONLY | O_DIRECTORY) < 0) std::_Exit(kInternalError);
  }
}

// During an analysis, each file and the connection to its sandbox stay open.
void allow_many_files() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &files);
}

extern "C" void clean_up_and_die(int signal) {
  remove_temporary_files();  // async-signal-safe
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Outside of a LibraryCall, the fault occurs again on return and ends the process: the handler is used once.
extern "C" void report_library_crash(int /*signal*/) {
  constexpr std::string_view kMessage = "percuss: not enough memory (a library call); analyse fewer rows or channels\n";
  if (!LibraryCall::running()) return;
  remove_temporary_files();
  static_cast<void>(!::write(STDERR_FILENO, kMessage.data(), kMessage.size()));
  std::_Exit(kInternalError);
}

// A sanitizer keeps its own handlers.
void catch_library_crashes() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = report_library_crash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    ::sigaction(signal, &action, nullptr);
  }
}

// The stack grows when it is used, and a growth that `ulimit -v` denies is a crash (in Eigen's products). Touching the
// end of the needed range reserves its addresses.
[[gnu::noinline]] void reserve_stack() {
  constexpr std::size_t kNeeded_bytes = std::size_t{1} << 20U;
  void* const probe =
      ::mmap(nullptr, 2 * kNeeded_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (probe == MAP_FAILED) return;  // too few addresses are free
  ::munmap(probe, 2 * kNeeded_bytes);
  *static_cast<volatile char*>(__builtin_alloca(kNeeded_bytes)) = 0;
}

struct Call {
  int (*run)(int, char**);
  int argc;
  char** argv;
  int code = kInternalError;
};

void* start(void* argument) {
  Call& call = *static_cast<Call*>(argument);
  call.code = call.run(call.argc, call.argv);
  return nullptr;
}

}  // namespace

void set_up_process() {
  reopen_standard_streams();
  allow_many_files();
  std::signal(SIGXFSZ, SIG_IGN);
  catch_library_crashes();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, clean_up_and_die);
}

int run_with_enough_stack(int (*run)(int, char**), int argc, char** argv) {
  rlimit stack{};
  const bool low = ::getrlimit(RLIMIT_STACK, &stack) == 0 && stack.rlim_cur < kEnoughStack_bytes;
  pthread_attr_t attributes{};
  if (!low) reserve_stack();
  if (!low || ::pthread_attr_init(&attributes) != 0) return run(argc, argv);
  ::pthread_attr_setstacksize(&attributes, kStack_bytes);
  ::pthread_setattr_default_np(&attributes);  // of threads that libraries start
  Call call{.run = run, .argc = argc, .argv = argv};
  pthread_t thread{};
  const bool started = ::pthread_create(&thread, &attributes, start, &call) == 0;
  ::pthread_attr_destroy(&attributes);
  if (!started) return run(argc, argv);
  ::pthread_join(thread, nullptr);
  return call.code;
}

}  // namespace percuss::tools
