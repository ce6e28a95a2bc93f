#include "commands/record/raw_terminal.hpp"

#include <termios.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace percuss::tools {
namespace {

// Set before the handlers that read them.
termios saved_mode;
volatile std::sig_atomic_t raw_terminal = -1;
volatile std::sig_atomic_t arrived_signal = 0;

constexpr std::array kFinishing{SIGINT, SIGTERM, SIGHUP};
constexpr std::array kFatal{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTSTP};
std::array<struct sigaction, kFinishing.size()> before_finishing;
std::array<struct sigaction, kFatal.size()> before_fatal;
struct sigaction before_pipe, before_continue;

void apply_raw_mode() {
  termios raw = saved_mode;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  ::tcsetattr(raw_terminal, TCSADRAIN, &raw);
}

// tcsetattr is safe in handlers.
void restore_mode() {
  if (raw_terminal >= 0) ::tcsetattr(raw_terminal, TCSANOW, &saved_mode);
}

extern "C" void finish_session(int signal) {
  arrived_signal = signal;
  if (signal == SIGINT) {  // the second one ends the process
    restore_mode();
    ::sigaction(SIGINT, before_finishing.data(), nullptr);
  }
}

// Restores the terminal, then lets the signal do what it did before.
extern "C" void restore_and_raise(int signal) {
  restore_mode();
  for (std::size_t i = 0; i < kFatal.size(); ++i) {
    if (kFatal[i] == signal) ::sigaction(signal, &before_fatal[i], nullptr);
  }
  std::raise(signal);
}

extern "C" void continue_raw(int /*signal*/) {
  if (raw_terminal < 0) return;
  apply_raw_mode();
  struct sigaction action {};
  action.sa_handler = restore_and_raise;
  ::sigaction(SIGTSTP, &action, nullptr);
}

void install(int signal, void (*handler)(int), struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, &before);
}

}  // namespace

void enter_raw_mode(int terminal) {
  if (::tcgetattr(terminal, &saved_mode) != 0) return;
  raw_terminal = terminal;
  static const int kRegistered = std::atexit(restore_mode);
  static_cast<void>(kRegistered);
  for (std::size_t i = 0; i < kFatal.size(); ++i) install(kFatal[i], restore_and_raise, before_fatal[i]);
  install(SIGCONT, continue_raw, before_continue);
  apply_raw_mode();
}

void leave_raw_mode() {
  if (raw_terminal < 0) return;
  restore_mode();
  raw_terminal = -1;
  for (std::size_t i = 0; i < kFatal.size(); ++i) ::sigaction(kFatal[i], &before_fatal[i], nullptr);
  ::sigaction(SIGCONT, &before_continue, nullptr);
}

SessionSignals::SessionSignals() {
  arrived_signal = 0;
  for (std::size_t i = 0; i < kFinishing.size(); ++i) install(kFinishing[i], finish_session, before_finishing[i]);
  install(SIGPIPE, SIG_IGN, before_pipe);
}

SessionSignals::~SessionSignals() {
  for (std::size_t i = 0; i < kFinishing.size(); ++i) ::sigaction(kFinishing[i], &before_finishing[i], nullptr);
  ::sigaction(SIGPIPE, &before_pipe, nullptr);
}

int SessionSignals::arrived() { return arrived_signal; }

}  // namespace percuss::tools
