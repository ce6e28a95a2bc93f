#include "commands/record/raw_terminal.hpp"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>

namespace percuss::tools {

bool in_foreground(int terminal) { return ::tcgetpgrp(terminal) == ::getpgrp(); }

namespace {

// The handlers read saved_mode only after mode_is_saved is set.
termios saved_mode;
std::atomic<int> mode_is_saved = 0;
std::atomic<int> raw_terminal = -1;
std::atomic<int> arrived_signal = 0;

constexpr std::array kFinishing{SIGINT, SIGTERM, SIGHUP};
constexpr std::array kFatal{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
std::array<struct sigaction, kFinishing.size()> before_finishing;
std::array<struct sigaction, kFatal.size()> before_fatal;
struct sigaction before_pipe, before_stop, before_continue;
std::atomic<bool> continued = false;
std::atomic<double> arrived_s = 0;
// Handlers run in any thread, and may not wait for a lock.
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<double>::is_always_lock_free);

// Handlers call the functions of this namespace: tcgetpgrp, tcsetattr, sigaction and clock_gettime are safe there.
// Setting the mode from the background would stop the process with SIGTTOU.
bool may_set_mode() { return raw_terminal >= 0 && mode_is_saved != 0 && in_foreground(raw_terminal); }

void apply_raw_mode() {
  if (!may_set_mode()) return;
  termios raw = saved_mode;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  ::tcsetattr(raw_terminal, TCSANOW, &raw);
}

void restore_mode() {
  if (may_set_mode()) ::tcsetattr(raw_terminal, TCSANOW, &saved_mode);
}

double now_s() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Restores the mode of the terminal and the earlier handler of the signal, and raises the signal again.
template <std::size_t count>
void raise_with_handlers_of(const std::array<int, count>& signals, const std::array<struct sigaction, count>& before,
                            int signal) {
  restore_mode();
  for (std::size_t i = 0; i < count; ++i) {
    if (signals[i] == signal) ::sigaction(signal, &before[i], nullptr);
  }
  std::raise(signal);
}

// `timeout` and shells send a signal to the process and to its group: a copy within half a second is the same signal.
extern "C" void finish_session(int signal) {
  if (arrived_signal == 0) {
    arrived_s = now_s();
    arrived_signal = signal;
    return;
  }
  constexpr double kSameSignal_s = 0.5;
  if (now_s() - arrived_s < kSameSignal_s) return;
  raise_with_handlers_of(kFinishing, before_finishing, signal);
}

extern "C" void raise_fatal(int signal) { raise_with_handlers_of(kFatal, before_fatal, signal); }

void install(int signal, void (*handler)(int), struct sigaction* before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, before);
}

// Stops here until SIGCONT. The kernel does not stop a process of an orphaned group.
extern "C" void stop_process(int signal) {
  const int kept_errno = errno;
  restore_mode();
  ::sigaction(signal, &before_stop, nullptr);
  sigset_t this_one, before;
  ::sigemptyset(&this_one);
  ::sigaddset(&this_one, signal);
  std::raise(signal);
  ::pthread_sigmask(SIG_UNBLOCK, &this_one, &before);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  install(signal, stop_process, nullptr);
  apply_raw_mode();
  continued = true;
  errno = kept_errno;
}

// Sets the raw mode again after a stop in the background, or by SIGSTOP.
extern "C" void continue_raw(int /*signal*/) {
  const int kept_errno = errno;
  apply_raw_mode();
  continued = true;
  errno = kept_errno;
}

}  // namespace

void enter_raw_mode(int terminal) {
  raw_terminal = terminal;
  mode_is_saved = 0;
  static const int kRegistered = std::atexit(restore_mode);
  static_cast<void>(kRegistered);
  for (std::size_t i = 0; i < kFatal.size(); ++i) install(kFatal[i], raise_fatal, &before_fatal[i]);
  install(SIGTSTP, stop_process, &before_stop);
  install(SIGCONT, continue_raw, &before_continue);
  renew_raw_mode();
}

// Does nothing in the background, where the line editor of the shell sets the mode.
void renew_raw_mode() {
  if (raw_terminal < 0 || !in_foreground(raw_terminal)) return;
  if (mode_is_saved == 0 && ::tcgetattr(raw_terminal, &saved_mode) == 0) mode_is_saved = 1;
  apply_raw_mode();
}

void leave_raw_mode() {
  if (raw_terminal < 0) return;
  constexpr double kMaxDrain_s = 2;  // TCSADRAIN has no limit
  constexpr useconds_t kPollInterval_us = 5000;
  const double until_s = now_s() + kMaxDrain_s;
  int unsent_bytes = 0;
  while (::ioctl(raw_terminal, TIOCOUTQ, &unsent_bytes) == 0 && unsent_bytes > 0 && now_s() < until_s)
    ::usleep(kPollInterval_us);
  restore_mode();
  raw_terminal = -1;
  for (std::size_t i = 0; i < kFatal.size(); ++i) ::sigaction(kFatal[i], &before_fatal[i], nullptr);
  ::sigaction(SIGTSTP, &before_stop, nullptr);
  ::sigaction(SIGCONT, &before_continue, nullptr);
}

bool has_continued() { return continued.exchange(false); }

SessionSignals::SessionSignals() {
  arrived_signal = 0;
  for (std::size_t i = 0; i < kFinishing.size(); ++i) install(kFinishing[i], finish_session, &before_finishing[i]);
  install(SIGPIPE, SIG_IGN, &before_pipe);
}

SessionSignals::~SessionSignals() {
  for (std::size_t i = 0; i < kFinishing.size(); ++i) ::sigaction(kFinishing[i], &before_finishing[i], nullptr);
  ::sigaction(SIGPIPE, &before_pipe, nullptr);
}

int SessionSignals::arrived() { return arrived_signal; }

}  // namespace percuss::tools
