#include "acquire/sandbox/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
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

void keep_only_descriptors(std::initializer_list<int> kept) {
  const auto count = static_cast<int>(kept.size());
  std::vector<int> copies;
  for (const int descriptor : kept) copies.push_back(::fcntl(descriptor, F_DUPFD, count));
  for (int i = 0; i < count; ++i) {
    if (::dup2(copies[static_cast<std::size_t>(i)], i) != i) ::_exit(1);  // too many descriptors
  }
  ::closefrom(count);
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
