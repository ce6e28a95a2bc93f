#pragma once
#include <string>

#include "cli/declaration.hpp"
#include "core/error.hpp"

namespace percuss::tools {

// What is said to a command line that was not understood. Each is one line that names what was typed and what to type
// instead.

UsageError missing_command(const Declaration& all, const DeclaredCommand& group);
UsageError unknown_command(const Declaration& all, const DeclaredCommand& group, const std::string& typed);
UsageError unknown_option(const Declaration& all, const DeclaredCommand& command, const std::string& typed);
/// An option of `command` that stands before its name.
UsageError option_before_command(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option);
/// A word more than the command takes.
UsageError extra_argument(const Declaration& all, const DeclaredCommand& command, const std::string& typed);
UsageError missing_option(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option);
UsageError missing_value(const DeclaredOption& option);
UsageError flag_with_value(const DeclaredOption& option);
UsageError given_twice(const DeclaredOption& option);
UsageError wrong_value(const DeclaredOption& option, const std::string& typed);

}  // namespace percuss::tools
