#pragma once
#include <string>
#include <vector>

namespace percuss::test {

// What the program says of itself, read from its --help as a user reads it.

/// Every command as its words, {"model", "beam"}; the program itself first, without a word. Groups stand before theirs.
std::vector<std::vector<std::string>> commands();

/// "model beam".
std::string joined(const std::vector<std::string>& words);

/// What `percuss WORDS --help` prints.
std::string help_of(const std::vector<std::string>& command);

/// The long names of its options, "--band".
std::vector<std::string> option_names(const std::vector<std::string>& command);

/// The lines of its examples, as they are to be typed.
std::vector<std::string> example_lines(const std::vector<std::string>& command);

}  // namespace percuss::test
