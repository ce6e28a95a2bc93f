#pragma once
#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace percuss::test {

struct TerminalOptions {
  std::string folder;                      // working folder; empty: the current one
  unsigned short columns = 100;            // width of the terminal
  std::vector<std::string> environment{};  // NAME=VALUE, before the current environment
};

/// The built percuss on a pseudo-terminal, which is its input and output. Killed by the destructor.
class TerminalProcess {
 public:
  TerminalProcess(std::vector<std::string> arguments, const TerminalOptions& options);
  ~TerminalProcess();
  TerminalProcess(const TerminalProcess&) = delete;
  TerminalProcess& operator=(const TerminalProcess&) = delete;

  void type(const std::string& keys) const;
  void send(int signal) const;
  /// Reads until the screen has shown this text, after the texts awaited before. False after a long time, and where the
  /// process has ended.
  bool shows(const std::string& text);
  /// The exit code; −1 for a signal or after a long time. `read`: takes what is written meanwhile.
  int wait(bool read = true);
  /// The terminal shows what is typed, and delivers lines.
  bool has_echo_and_lines() const;
  /// All that was written and read.
  const std::string& screen() const { return screen_; }

 private:
  bool read_some();  // false where nothing more can come

  std::string screen_;
  int master_ = -1;
  pid_t child_ = -1;
  std::size_t seen_ = 0;
};

}  // namespace percuss::test
