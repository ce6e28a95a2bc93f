#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::test {

/// A command that a page shows, and what the page says it prints.
struct TranscriptCommand {
  std::string script;                 // one or more lines for /bin/sh
  std::vector<std::string> expected;  // lines; "..." stands for any lines, or none
  std::size_t line = 0;               // of the page, from 1
};

/// The commands of all ```console blocks of a page, in order. A line that starts with "$ " is a command, lines that
/// start with "> " right after it go on with it, all others are what it prints.
std::vector<TranscriptCommand> transcript_commands(const std::string& page);

/// Whether what was printed is what is shown. Words, blanks, units, counts (numbers without a decimal point) and the
/// number of decimals have to be equal. The last shown digit of other numbers may differ by one, beside a ± by two:
/// compilers, sanitizers and C libraries round differently, and a fit that is iterated ends within its tolerance.
bool matches_transcript(const std::vector<std::string>& shown, const std::vector<std::string>& printed);
bool same_line(std::string_view shown, std::string_view printed);

}  // namespace percuss::test
