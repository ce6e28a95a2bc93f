#include "acquire/sandbox/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

namespace percuss::acquire {

int fork_child() {
  const pid_t parent = ::getpid();
  const bool first_thread = ::gettid() == parent;
  const pid_t child = ::fork();
  if (child == 0 && first_thread) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);  // NOLINT: C
    if (::getppid() != parent) ::_exit(0);        // the parent ended before the call
  }
  return child;
}

namespace {

// The numbers, from `first` on, under which this process has the file open. None without /proc.
std::set<int> descriptors_of(const std::string& path, int first) {
  std::set<int> found;
  struct stat file {
  }, open_file{};
  if (path.empty() || ::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return found;
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", absent)) {
    const int number = std::atoi(entry.path().filename().c_str());  // NOLINT(cert-err34-c): names are numbers
    const bool same = number >= first && ::fstat(number, &open_file) == 0 && open_file.st_dev == file.st_dev &&
                      open_file.st_ino == file.st_ino;
    if (same) found.insert(number);
  }
  return found;
}

}  // namespace

void keep_only_descriptors(std::initializer_list<int> kept, const std::string& path) {
  const auto count = static_cast<int>(kept.size());
  std::vector<int> copies;
  for (const int descriptor : kept) copies.push_back(::fcntl(descriptor, F_DUPFD, count));
  for (int i = 0; i < count; ++i) {
    if (::dup2(copies[static_cast<std::size_t>(i)], i) != i) ::_exit(1);  // too many descriptors
  }
  int next = count;
  for (const int number : descriptors_of(path, count)) {
    const int reopened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (reopened != number && (::dup2(reopened, number) != number || ::close(reopened) != 0)) ::_exit(1);
    if (number > next) ::close_range(static_cast<unsigned>(next), static_cast<unsigned>(number - 1), 0);
    next = number + 1;
  }
  ::closefrom(next);
}

void end_with_parent(int parent_pipe) {
  ::fcntl(parent_pipe, F_SETOWN, ::getpid());
  ::fcntl(parent_pipe, F_SETSIG, SIGKILL);
  ::fcntl(parent_pipe, F_SETFL, O_ASYNC | O_NONBLOCK);
  pollfd closed{parent_pipe, 0, 0};
  if (::poll(&closed, 1, 0) > 0) ::_exit(0);  // the parent ended before these calls
}

void reset_signals() {
  for (int signal = 1; signal < NSIG; ++signal) {
    if (signal != SIGKILL && signal != SIGSTOP) std::signal(signal, signal == SIGPIPE ? SIG_IGN : SIG_DFL);
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace percuss::acquire
