#pragma once
#include <string>
#include <vector>

namespace percuss::test {

// Commands, options and examples, parsed from the output of --help. Each help text is read once per process.

/// Every command as a list of words, such as {"model", "beam"}. The first list is empty and stands for the program
/// itself. A group comes before its commands.
const std::vector<std::vector<std::string>>& commands();

/// "model beam".
std::string joined(const std::vector<std::string>& words);

/// The output of `percuss WORDS --help`.
const std::string& help_of(const std::vector<std::string>& command);

/// The long names of its options, "--band".
std::vector<std::string> option_names(const std::vector<std::string>& command);

/// The command lines of its examples.
std::vector<std::string> example_lines(const std::vector<std::string>& command);

}  // namespace percuss::test
