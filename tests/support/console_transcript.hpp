#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::test {

/// A command on a page, and its output as printed there.
struct TranscriptCommand {
  std::string script;                 // one or more lines for /bin/sh
  std::vector<std::string> expected;  // lines; "..." stands for any lines, or none
  std::size_t line = 0;               // of the page, from 1
};

/// The commands of all ```console blocks of a page, in order. A line that starts with "$ " is a command; directly
/// following lines that start with "> " continue it; all other lines are its output.
std::vector<TranscriptCommand> transcript_commands(const std::string& page);

/// How far the last digits of a page and of the output may differ.
enum class LastDigits {
  equal,    // not at all, because a stale page may differ by only one or two units
  rounded,  // by one; by two next to a ±: compilers, sanitizers and C libraries round differently, and an iterative fit
            // ends within its tolerance
};

/// `equal` in a build by g++ for x86-64 without sanitizers; else `rounded`. The pages show the output of the former.
LastDigits last_digits_of_this_build();

/// Whether the printed output agrees with the output on the page. Words, blanks, units, counts (numbers without a
/// decimal point or an exponent) and the number of decimals must be equal; `digits` applies to other numbers.
bool matches_transcript(const std::vector<std::string>& shown, const std::vector<std::string>& printed,
                        LastDigits digits);
bool same_line(std::string_view shown, std::string_view printed, LastDigits digits);

}  // namespace percuss::test
