#pragma once
#include <string>
#include <string_view>
#include <utility>

namespace percuss::acquire {

/// Requires that these first bytes of the file `name` can be the start of a text in ASCII, UTF-8 or Latin-1.
/// errors  InputError: empty, UTF-16, binary. The message names known kinds of files that percuss does not read.
void require_text(std::string_view head, const std::string& name);

/// Requires that no line is longer than 1 MiB. Takes little time: it looks only for the last line end in each MiB.
/// errors  InputError: a longer line, with its number
void require_short_lines(std::string_view text, char line_end, const std::string& name);

/// The same for a text that grows while it is read, whose line end is not known yet: CR and LF both end a line. It
/// refuses an endless line before the rest of the file takes memory.
class LineLengthCheck {
 public:
  explicit LineLengthCheck(std::string name) : name_(std::move(name)) {}
  /// errors  InputError: a longer line, with its number
  void operator()(std::string_view text);

 private:
  std::string name_;
  std::size_t checked_ = 0;  // bytes already checked: 0, or up to the end of a line
};

}  // namespace percuss::acquire
