#include "commands/record/record_terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

#include "commands/record/raw_terminal.hpp"
#include "core/error.hpp"
#include "core/visible_text.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxLines = 2000, kLine_bytes = 600;
constexpr std::size_t kPiece_bytes = 512;  // a writable pipe takes at least this many bytes without waiting
constexpr auto kPatience = std::chrono::seconds(2);
constexpr int kPoll_ms = 100;
constexpr std::size_t kMaxPointDigits = 10;  // of acquire::kMaxPointNumber
constexpr const char* kErase = "\r\x1b[K";

std::size_t columns_of(int terminal) {
  winsize size{};
  return ::ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// Opens the terminal again, without blocking: a terminal that takes no output would hold up the end of the session.
// Standard output itself stays blocking, because other programs share it. −1: not possible.
int open_again(int terminal) {
  std::array<char, 256> name{};
  if (::ttyname_r(terminal, name.data(), name.size()) != 0) return -1;
  return ::open(name.data(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

// The first characters of the text that fit into so many columns.
std::string fitting(const std::string& text, std::size_t columns) {
  std::size_t at = 0;
  for (std::size_t used = 0; at < text.size() && used < columns; ++used)
    at += std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(at)));
  return text.substr(0, at);
}

// Breaks a long line between words: the terminal itself would break it within a number.
std::string folded(const std::string& line, std::size_t columns) {
  if (report::text_width(line) <= columns) return line;
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  return line.substr(0, indent) + report::wrapped(line, columns, std::max<std::size_t>(indent, 2));
}

}  // namespace

RecordTerminal::RecordTerminal(int input, int output, bool quiet)
    : input_(input), output_(output), quiet_(quiet), interactive_(::isatty(input) == 1 && ::isatty(output) == 1) {
  if (::pipe2(wake_.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw_system_error("cannot watch the terminal", errno, "the session", "close other programs");
  if (interactive_) {
    enter_raw_mode(input_);
    opened_ = open_again(output);
    if (opened_ >= 0) output_ = opened_;
  }
  thread_ = std::thread([this] { run(); });
}

RecordTerminal::~RecordTerminal() {
  prompt("");
  closing_ = true;
  wake();
  thread_.join();
  if (interactive_) leave_raw_mode();
  if (opened_ >= 0) ::close(opened_);
  ::close(wake_[0]);
  ::close(wake_[1]);
}

void RecordTerminal::wake() const { static_cast<void>(!::write(wake_[1], "", 1)); }

void RecordTerminal::line(const std::string& text) {
  {
    const std::lock_guard lock(mutex_);
    lines_.push_back(one_line(text, kLine_bytes));
    if (lines_.size() > kMaxLines) {
      lines_.pop_front();
      ++dropped_;
    }
  }
  wake();
}

void RecordTerminal::prompt(const std::string& text, const std::string& more, const std::string& shorter) {
  if (!interactive_) return;
  {
    const std::lock_guard lock(mutex_);
    if (prompt_ == text) return;
    prompt_ = text;
    more_ = more;
    shorter_ = shorter;
    redraw_ = true;
  }
  wake();
}

void RecordTerminal::bell() {
  if (quiet_ || !interactive_) return;
  {
    const std::lock_guard lock(mutex_);
    ring_ = true;
  }
  wake();
}

std::optional<PressedKey> RecordTerminal::take_key() {
  const std::lock_guard lock(mutex_);
  if (keys_.empty()) return {};
  const PressedKey key = keys_.front();
  keys_.pop_front();
  return key;
}

// The next line, or the prompt if no line waits.
std::string RecordTerminal::next_bytes() {
  const std::lock_guard lock(mutex_);
  std::string out;
  if (std::exchange(ring_, false)) out += '\a';
  if (dropped_ > 0) {
    out += fmt::format("{}… {} lines were not shown\n", interactive_ ? kErase : "", dropped_);
    dropped_ = 0;
  }
  if (!lines_.empty()) {
    out += (interactive_ ? kErase + folded(lines_.front(), columns_of(output_)) : lines_.front()) + "\n";
    lines_.pop_front();
    redraw_ = interactive_;
  } else if (was_in_front_ && std::exchange(redraw_, false)) {
    out += kErase;
    if (number_) {
      out += "go to point: " + *number_;
    } else if (!prompt_.empty()) {
      const std::size_t columns = columns_of(output_) - 1;
      const bool fits = report::text_width(prompt_ + more_) <= columns;
      out += fitting(prompt_ + (fits ? more_ : shorter_), columns);
    }
  }
  return out;
}

void RecordTerminal::write_some() {
  const auto written = ::write(output_, pending_.data(), std::min(pending_.size(), kPiece_bytes));
  if (written > 0) {
    pending_.erase(0, static_cast<std::size_t>(written));
  } else if (written < 0 && errno != EINTR && errno != EAGAIN) {
    broken_ = true;  // closed: the session goes on without it
  }
}

void RecordTerminal::press(char key) {
  const std::lock_guard lock(mutex_);
  if (number_) {
    redraw_ = true;
    if (key >= '0' && key <= '9' && number_->size() < kMaxPointDigits) {
      *number_ += key;
    } else if ((key == 127 || key == '\b') && !number_->empty()) {
      number_->pop_back();
    } else if (key == '\n' || key == '\r') {
      if (!number_->empty()) keys_.push_back({.key = RecordKey::go_to, .number = std::stoul(*number_)});
      number_.reset();
    } else if (key == '\x1b') {
      number_.reset();
    }
    return;
  }
  constexpr std::array<std::pair<char, RecordKey>, 5> kMeanings{{{' ', RecordKey::pause},
                                                                 {'u', RecordKey::undo},
                                                                 {'r', RecordKey::redo},
                                                                 {'n', RecordKey::next},
                                                                 {'q', RecordKey::finish}}};
  for (const auto& [name, meaning] : kMeanings) {
    if (name == key) keys_.push_back({.key = meaning});
  }
  if (key == 'g') {
    number_ = "";
    redraw_ = true;
  }
}

void RecordTerminal::read_keys() {
  std::array<char, 64> bytes{};
  const auto got = ::read(input_, bytes.data(), bytes.size());
  if (got <= 0) {
    if (got == 0 || (errno != EINTR && errno != EAGAIN)) input_ = -1;  // poll ignores it from now on
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) press(bytes[i]);
}

// Keys are read and the prompt is shown only in the foreground: reading in the background would stop the process.
bool RecordTerminal::in_front() const { return interactive_ && input_ >= 0 && in_foreground(input_); }

void RecordTerminal::run() {
  Clock::time_point taken = Clock::now();
  for (;;) {
    const bool front = in_front();
    if (interactive_ && (has_continued() || (front && !was_in_front_))) {
      if (front) renew_raw_mode();
      const std::lock_guard lock(mutex_);
      redraw_ = true;
    }
    was_in_front_ = front;
    if (pending_.empty() || broken_) pending_ = next_bytes();
    const bool closing = closing_;
    if (closing && (pending_.empty() || broken_)) return;
    if (closing && interactive_ && Clock::now() - taken > kPatience) return;
    if (!closing) taken = Clock::now();
    const bool has_output = !pending_.empty() && !broken_;
    std::array<pollfd, 3> files{{{.fd = wake_[0], .events = POLLIN, .revents = 0},
                                 {.fd = front ? input_ : -1, .events = POLLIN, .revents = 0},
                                 {.fd = has_output ? output_ : -1, .events = POLLOUT, .revents = 0}}};
    ::poll(files.data(), files.size(), kPoll_ms);
    std::array<char, 256> ignored{};
    while (::read(wake_[0], ignored.data(), ignored.size()) > 0) {
    }
    if (files[1].revents != 0) read_keys();
    if (files[2].revents != 0) {
      write_some();
      taken = Clock::now();
    }
  }
}

}  // namespace percuss::tools
