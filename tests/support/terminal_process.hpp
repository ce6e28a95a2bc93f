#pragma once
#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace percuss::test {

struct TerminalOptions {
  std::string folder;                      // working folder; empty: the current one
  unsigned short columns = 100;            // width of the terminal
  std::vector<std::string> environment{};  // NAME=VALUE; overrides the current environment
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
  /// Reads the output until it contains this text, after the texts of earlier calls. Returns false after 100 s, or when
  /// the process has ended.
  bool shows(const std::string& text);
  /// Waits for the end and returns the exit code; −1 for a signal, or after 100 s. If `read`, it reads the output while
  /// it waits.
  int wait(bool read = true);
  /// Whether the terminal echoes its input and delivers it line by line.
  bool has_echo_and_lines() const;
  /// All output read so far.
  const std::string& screen() const { return screen_; }

 private:
  bool read_some();  // false when no more output can come

  std::string screen_;
  int master_ = -1;
  pid_t child_ = -1;
  std::size_t seen_ = 0;
};

}  // namespace percuss::test
