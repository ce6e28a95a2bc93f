#include "support/terminal_process.hpp"
#include "support/percuss_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace percuss::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{100};  // sanitizers are slow

}  // namespace

TerminalProcess::TerminalProcess(std::vector<std::string> arguments, const TerminalOptions& options) {
  arguments.insert(arguments.begin(), "percuss");
  std::vector<std::string> environment = options.environment;  // the first value of a name counts
  environment.emplace_back("TERM=xterm");
  for (char** entry = environ; *entry != nullptr; ++entry) environment.emplace_back(*entry);
  const std::vector<char*> words = c_strings(arguments), settings = c_strings(environment);
  winsize size{.ws_row = 40, .ws_col = options.columns, .ws_xpixel = 0, .ws_ypixel = 0};
  child_ = ::forkpty(&master_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("no pseudo-terminal");
  if (child_ == 0) {
    if (options.folder.empty() || ::chdir(options.folder.c_str()) == 0)
      ::execve(PERCUSS_EXECUTABLE, words.data(), settings.data());
    ::_exit(127);
  }
  ::fcntl(master_, F_SETFL, O_NONBLOCK);
}

TerminalProcess::~TerminalProcess() {
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  ::close(master_);
}

void TerminalProcess::type(const std::string& keys) const {
  static_cast<void>(!::write(master_, keys.data(), keys.size()));
}

void TerminalProcess::send(int signal) const { ::kill(child_, signal); }

bool TerminalProcess::shows(const std::string& text) {
  const auto deadline = Clock::now() + kPatience;
  bool more = true;
  while (screen_.find(text, seen_) == std::string::npos) {
    if (!more || Clock::now() > deadline) return false;
    more = read_some();
  }
  seen_ = screen_.find(text, seen_) + text.size();
  return true;
}

int TerminalProcess::wait(bool read) {
  const auto deadline = Clock::now() + kPatience;
  int status = 0;
  while (::waitpid(child_, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline) return -1;
    if (read) read_some();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  child_ = -1;
  while (read && Clock::now() < deadline && read_some()) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool TerminalProcess::has_echo_and_lines() const {
  termios mode{};
  return ::tcgetattr(master_, &mode) == 0 && (mode.c_lflag & ICANON) != 0 && (mode.c_lflag & ECHO) != 0;
}

// Reading fails with EIO once the program has closed the terminal.
bool TerminalProcess::read_some() {
  pollfd file{.fd = master_, .events = POLLIN, .revents = 0};
  ::poll(&file, 1, 20);
  std::array<char, 4096> bytes{};
  const auto got = ::read(master_, bytes.data(), bytes.size());
  if (got > 0) screen_.append(bytes.data(), static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && errno == EAGAIN);
}

}  // namespace percuss::test
