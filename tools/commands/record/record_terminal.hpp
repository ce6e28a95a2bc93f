#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace percuss::tools {

enum class RecordKey { pause, undo, redo, next, go_to, finish };

struct PressedKey {
  RecordKey key = RecordKey::pause;
  std::size_t number = 0;  // go_to
};

/// Lines, bells and keys of a guided session, in a thread of its own. A terminal or pipe that takes nothing, or is
/// closed, does not hold up the callers of its functions. On a terminal, a prompt stays below the lines, and keys are
/// read one by one.
class RecordTerminal {
 public:
  /// Writes to `output` (a descriptor). Reads keys if `input` and `output` are terminals, while the process is in the
  /// foreground.
  RecordTerminal(int input, int output, bool quiet);
  /// Writes the lines that wait, and restores the terminal. A terminal that takes nothing for two seconds loses the
  /// rest. A pipe is waited for until it takes everything or is closed.
  ~RecordTerminal();
  RecordTerminal(const RecordTerminal&) = delete;
  RecordTerminal& operator=(const RecordTerminal&) = delete;

  bool interactive() const { return interactive_; }
  void line(const std::string& text);
  /// `more` follows the text if it fits, else `shorter`.
  void prompt(const std::string& text, const std::string& more = "", const std::string& shorter = "");
  void bell();
  std::optional<PressedKey> take_key();

 private:
  void run();
  void write_some();
  void read_keys();
  void press(char key);
  void wake() const;
  bool in_front() const;
  std::string next_bytes();

  int input_, output_;
  int opened_ = -1;  // the terminal, opened again
  bool quiet_, interactive_;
  std::array<int, 2> wake_{-1, -1};
  std::mutex mutex_;
  std::deque<std::string> lines_;
  std::size_t dropped_ = 0;
  std::string prompt_, more_, shorter_;
  bool redraw_ = false, ring_ = false;
  std::deque<PressedKey> keys_;
  std::optional<std::string> number_;  // being typed after g
  std::string pending_;                // bytes for the output
  bool broken_ = false, was_in_front_ = false;
  std::atomic<bool> closing_{false};
  std::thread thread_;
};

}  // namespace percuss::tools
